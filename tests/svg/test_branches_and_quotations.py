"""Conditions in code, drawings that other texts quote, motions, and what is too fine."""

import gzip
import json

import pytest

from iconstudio.model import IconstudioError
from iconstudio.svg.colours import colour
from tests.svg.pictures import HOUSE, PATH, assert_shows, read, svg

pytestmark = pytest.mark.thorough(but=1)

BOX = 'viewBox="0 0 24 24"'
OTHER = '<circle cx="3" cy="20" r="3"/>'
D = f'fill-rule="evenodd" d="{HOUSE}"'
CHOICES = {
    "Svelte": f"{{#if a}}{PATH}{{:else}}{OTHER}{{/if}}",
    "Svelte, by value": f"{{#if v === 'x'}}{PATH}{{/if}}{{#if v === 'y'}}{OTHER}{{/if}}",
    "Vue": f'<path v-if="a" {D}/><circle v-else-if="b" r="9"/><g v-else>{OTHER}</g>',
    "Vue, unreadable": f'<path v-if="a" :d="path"/><path v-else {D}/>',
    "Angular": f'<path *ngIf="a" {D}/><circle *ngIf="!a" r="9"/>',
    "Angular's blocks": f"@if (a) {{ {PATH} }} @else {{ {OTHER} }}",
    "Angular's switch": f"@switch (a) {{ @case (1) {{ {PATH} }} @default {{ {OTHER} }} }}",
    "Angular's template": f'<ng-container *ngIf="a; else b">{PATH}</ng-container>'
    f"<ng-template #b>{OTHER}</ng-template>",
    "Jinja": f"{{% if a %}}{PATH}{{% elif b %}}{OTHER}{{% else %}}{OTHER}{{% endif %}}",
    "Liquid": f"{{%- case a -%}}{{%- when 1 -%}}{PATH}{{%- when 2 -%}}{OTHER}{{%- endcase -%}}",
    "Handlebars": f"{{{{#if a}}}}{PATH}{{{{else}}}}{OTHER}{{{{/if}}}}",
    "Mustache": f"{{{{#a}}}}{PATH}{{{{/a}}}}{{{{^a}}}}{OTHER}{{{{/a}}}}",
    "Go": f"{{{{ if .A }}}}{PATH}{{{{ else }}}}{OTHER}{{{{ end }}}}",
    "ERB": f"<% if a %>{PATH}<% else %>{OTHER}<% end %>",
    "EJS": f"<% if (a) {{ %>{PATH}<% }} else {{ %>{OTHER}<% }} %>",
    "PHP": f"<?php if ($a): ?>{PATH}<?php else: ?>{OTHER}<?php endif; ?>",
    "Blade": f"@if ($a)\n{PATH}\n@else\n{OTHER}\n@endif",
    "JSX": f"{{a ? (<>{PATH}</>) : {OTHER}}}",
    "JSX, twice": f"{{a && {PATH}}}{{!a && {OTHER}}}",
    "JSX, an attribute": f'<path fillRule="evenodd" d={{a ? "{HOUSE}" : "M0 0h9"}}/>',
    "Solid": f"<Show when={{a}} fallback={{{OTHER}}}>{PATH}</Show>",
    "Solid's switch": f"<Switch><Match when={{a}}>{PATH}</Match><Match when={{b}}>{OTHER}</Match>"
    "</Switch>",
}


@pytest.mark.parametrize("kind", CHOICES)
def test_the_first_branch_is_taken_alone(kind):
    assert_shows(f"<svg {BOX}>{CHOICES[kind]}</svg>", PATH, remarks=("chooses between",))


ESCAPED = svg(PATH).replace("&", "&amp;").replace("<", "&lt;").replace('"', "&quot;")
PERCENT = svg(PATH).replace('"', "'").replace("<", "%3C").replace(">", "%3E").replace("#", "%23")
QUOTED = {
    "escaped": ESCAPED,
    "JSON": json.dumps({"a": [1, {"svg": svg(PATH)}]}),
    "a string": f"export default {json.dumps(svg(PATH))};",
    "CSS": f'.a{{background:url("data:image/svg+xml,{PERCENT}")}}',
    "a page": f'<html><body><img src="data:image/svg+xml,{PERCENT}"></body></html>',
    "without a root": PATH,
    "compressed twice": gzip.compress(gzip.compress(svg(PATH).encode())),
    "capitals": f'<SVG viewbox="0 0 24 24"><PATH FILL-RULE="evenodd" D="{HOUSE}"/></SVG>',
}


@pytest.mark.parametrize("kind", QUOTED)
def test_what_is_quoted_is_read(kind):
    assert_shows(QUOTED[kind], PATH)


def test_code_and_images_are_called_by_their_names():
    with pytest.raises(IconstudioError, match="Compose"):
        read("val A = ImageVector.Builder().path { moveTo(1f, 2f) }")
    images = '<image width="9" height="9" href="a.png"/><image width="9" height="9" href="b"/>'
    words = ("A bitmap in another file", "A picture in another file")
    assert_shows(svg(PATH + images), PATH, remarks=words)


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("color-mix(in srgb, black 80%, white)", "#333333"),
        ("color-mix(in srgb, red, blue)", "#800080"),
        ("color-mix(in srgb, currentColor 50%, transparent)", "rgba(0,0,0,0.5)"),
        ("rgb(from red r 0 0 / 50%)", "rgba(255,0,0,0.5)"),
        ("light-dark(black, white)", "#000000"),
        ("color-mix(in nothing, red, blue)", None),
    ],
)
def test_colours_are_mixed(text, expected):
    assert colour(text) == expected


ENDLESS = 'dur="1s" repeatCount="indefinite"'
MOVED = {
    "to its end": (
        f'<circle r="3"><animateMotion path="M0 0L9 9" dur="1s" fill="freeze"/></circle>{PATH}',
        f'<circle cx="9" cy="9" r="3"/>{PATH}',
        ("at the end",),
    ),
    "along a shape": (
        f'<path id="p" fill="none" d="M4 4H20"/><circle r="3"><animateMotion {ENDLESS}>'
        '<mpath href="#p"/></animateMotion></circle><path d="M2 20h20v3h-20z"/>',
        '<circle cx="12" cy="4" r="3"/><path d="M2 20h20v3h-20z"/>',
        ("in the middle",),
    ),
    "a pulse": (
        '<circle cx="12" cy="12" r="1" fill="none" stroke="#000" stroke-width="2">'
        f'<animate attributeName="r" values="1;11" {ENDLESS}/>'
        f'<animate attributeName="stroke-opacity" values="1;0" {ENDLESS}/></circle>',
        '<circle cx="12" cy="12" r="6" fill="none" stroke="#000" stroke-width="2"/>',
        ("in the middle",),
    ),
}


RING = '<circle cx="12" cy="12" r="9" fill="none" stroke="#000" stroke-width="2" {}'
ARC = RING.format('stroke-dasharray="28 80"/>')
DASHES = {
    "SMIL, from nothing": RING.format('stroke-dasharray="0 80">')
    + f'<animate attributeName="stroke-dasharray" values="0 80;28 80;0 80" {ENDLESS}/></circle>',
    "CSS, without dashes before": "<style>@keyframes a{0%{stroke-dasharray:1,80}"
    "50%{stroke-dasharray:28,80}100%{stroke-dasharray:56,80}}circle{animation:a 1s infinite}"
    f"</style>{RING.format('/>')}",
    "CSS, by an offset": "<style>@keyframes a{0%{stroke-dashoffset:57}50%{stroke-dashoffset:29}}"
    "circle{animation:a 1s infinite;stroke-dasharray:57;stroke-dashoffset:57}"
    f"</style>{RING.format('/>')}",
}


@pytest.mark.parametrize("kind", DASHES)
def test_dashes_that_grow_are_neither_empty_nor_whole(kind):
    assert_shows(svg(DASHES[kind]), ARC, least=0.95, remarks=("in the middle",))


@pytest.mark.parametrize("kind", MOVED)
def test_what_moves_is_where_it_ends_or_midway(kind):
    document, expected, remarks = MOVED[kind]
    assert_shows(svg(document), expected, remarks=remarks)


LINE = '<path stroke="#000" stroke-width="8" fill="none" d="M5 50h90"'
FINE = {
    "a strip": ('viewBox="0 0 10000 10"', '<rect width="10000" height="10"/>', "drawn thicker"),
    "dashes": ('viewBox="0 0 100 100"', f'{LINE} stroke-dasharray="1e-7"/>', "dashes are too fine"),
    "a pattern": (
        'viewBox="0 0 100 100"',
        '<pattern id="p" width="1e-5" height="1e-5" patternUnits="userSpaceOnUse"><path '
        'd="M0 0h1v1z"/></pattern><circle cx="50" cy="50" r="40" fill="url(#p)"/>',
        "pattern in it is too fine",
    ),
    "lines beside others": (
        'viewBox="0 0 400 300"',
        '<g stroke="#1e1e1e" fill="none"><path d="M20 20H380V280H20Z"/>'
        '<path d="M60 150H340" stroke-width="2"/></g>',
        "Some of its lines",
    ),
}


@pytest.mark.parametrize("kind", FINE)
def test_what_is_too_fine_is_drawn_and_told(kind):
    attributes, body, words = FINE[kind]
    (remark,) = read(svg(body, attributes)).remarks
    assert words in remark


@pytest.mark.parametrize("paint", ['stroke="#000" stroke-width="0" fill="none"', ""])
def test_a_line_without_paint_is_nothing(paint):
    with pytest.raises(IconstudioError, match="nothing to be seen"):
        read(svg(f'<path {paint} d="M5 50h90"/>', 'viewBox="0 0 100 100"'))
