"""Drawings whose values are written out in code: lists, constants, defaults, components."""

import pytest

from iconstudio.svg.markup import markup_of
from tests.svg.pictures import assert_shows

BARS = "".join(
    f'<rect x="{x}" y="{3 * n + 2}" width="4" height="9"/>' for n, x in enumerate((2, 9, 16))
)
BAR = 'width="4" height="9"'
LITERAL = "[2, 9, 16]"
OBJECTS = "[{x: 2, y: 2}, {x: 9, y: 5}, {x: 16, y: 8}]"


def drawing(body, before="", after=""):
    return f'{before}<svg viewBox="0 0 24 24">{body}</svg>{after}'


AS_THE_BARS = {
    "a literal list": drawing(
        f"{{{LITERAL}.map((x, i) => <rect key={{x}} x={{x}} y={{3 * i + 2}} {BAR}/>)}}"
    ),
    "a list that is declared": drawing(
        f"{{bars.map(({{ x, y }}) => (<rect {{...{{x, y}}}} {BAR}/>))}}",
        f"const bars: {{ x: number }}[] = {OBJECTS};\nexport default () => (",
        ");",
    ),
    "a list that is computed": drawing(
        "{Array.from({ length: 3 }, (_, i) => { const x = i * 7 + 2; return ("
        f"<g transform={{`translate(${{x}} ${{Math.round(3 * i) + 2}})`}}><rect {BAR}/></g>); }})}}"
    ),
    "a spread list": drawing(
        f"{{[...Array(3).keys()].map(i => <rect x={{2 + 7 * i}} y={{'' + (2 + 3 * i)}} {BAR}/>)}}"
    ),
    "entries of an object": drawing(
        f"{{Object.entries(bars).map(([x, y]) => <rect x={{x}} y={{y}} {BAR}/>)}}",
        "const bars = {'2': 2, '9': 5, '16': 8};",
    ),
    "a component of its own": drawing(
        "<Bar x={2} y={2}/><Bar x={9} y={5}/><Bar x={16} y={8}/>",
        "const Bar = ({x, y, width = 4}) => <rect x={x} y={y} width={width} "
        'height="9"/>;\nexport default () => ',
    ),
    "elements in constants": drawing(
        "{first}{rest}{off && <circle r={9}/>}{on && <path d=''/>}{title && <title>a</title>}",
        f'const first = <rect x="2" y="2" {BAR}/>;\nconst rest = [<rect x="9" y="5" {BAR}/>, '
        f'<rect x="16" y="8" {BAR}/>];\nconst Icon = ({{ off = false, on = true }}) => ',
    ),
    "path data in constants": drawing(
        "<path d={`M${a} 2h4v9h-4z`}/><path d={'M9 ' + b + rest}/><path d={shapes.last}/>",
        "const a = 2, b = 5; const rest = 'h4v9h-4z';\nconst shapes = {last: 'M16 8' + rest};\n",
    ),
    "Vue": drawing(
        f'<rect v-for="(x, i) in {LITERAL}" :key="i" :x="x" :y="3 * i + 2" {BAR}/>'
        '<path v-show="more" d="M0 0h24v24z"/>',
        "<template>",
        "</template><script setup>defineProps({more: {type: Boolean, default: false}})</script>",
    ),
    "Vue, over data": drawing(
        f'<rect v-for="one of bars" v-bind="one" {BAR}/>',
        "<template>",
        f"</template><script>export default {{data() {{return {{bars: {OBJECTS}}} }} }}</script>",
    ),
    "Vue, counting": drawing(f'<rect v-for="n in 3" :x="7 * n - 5" :y="3 * n - 1" {BAR}/>'),
    "Svelte": drawing(
        f"{{#each bars as {{ x, y }}, i (x)}}<rect {{x}} y={{y}} {BAR}/>{{/each}}",
        f"<script>let bars = {OBJECTS};</script>",
    ),
    "Angular": drawing(
        f'<rect *ngFor="let x of {LITERAL}; let i = index" [attr.x]="x" [attr.y]="3 * i + 2"'
        f" {BAR}/>"
    ),
    "Angular's blocks": drawing(
        f'@for (x of {LITERAL}; track x; let i = $index) {{ <rect x="{{{{x}}}}" '
        f'[attr.y]="3 * i + 2" {BAR}/> }}'
    ),
    "Alpine": drawing(
        f'<template x-for="one in bars"><rect :x="one.x" x-bind:y="one.y" {BAR}/></template>',
        f'<div x-data="{{ bars: {OBJECTS} }}">',
        "</div>",
    ),
    "Solid": drawing(
        f"<For each={{{LITERAL}}}>{{(x, i) => <rect x={{x}} y={{3 * i() + 2}} {BAR}/>}}</For>"
    ),
    "Jinja": drawing(
        f'{{% for x in {LITERAL} %}}<rect x="{{{{ x }}}}" y="{{{{ 3 * (x - 2) / 7 + 2 }}}}" {BAR}/>'
        "{% endfor %}"
    ),
}


@pytest.mark.parametrize("kind", AS_THE_BARS)
def test_values_that_are_written_out_are_read(kind):
    choosing = kind == "Vue"
    assert_shows(AS_THE_BARS[kind], BARS, remarks=("chooses between",) if choosing else ())


LEFT_OUT = {
    "a list": ("{items.map((x) => <rect x={x.a} width={3}/>)}", "by “items.map("),
    "a condition": ("{on && <circle r={9}/>}", "by “on && <circle"),
    "a call": ("{rest()}", "by “rest()”"),
    "a place": ("<rect x={x} width={3} height={3}/>", "A <rect> whose “x: x”"),
    "a template of a text": ("<path d={`M${x} 0h9v9z`}/>", "A <path> whose “d: `M${x} 0h9v9z`”"),
    "text with braces": ('<path d="M{x} 0h9v9z"/>', "A <path> whose “d: "),
    "Vue's list": ('<rect v-for="x in list" :x="x" width="3" height="3"/>', "A <rect> whose"),
    "Svelte's list": ("{#each list as x}<rect {x} width='3' height='3'/>{/each}", "A <rect> whose"),
    "a component": ("<Part x={3}/>", "An element <Part> was left out"),
    "a bomb": (
        "{a.map(() => a.map(() => a.map(() => <path d='M0 0h9v9z'/>)))}",
        "by “a.map(",
    ),
}


@pytest.mark.thorough(but=1)
@pytest.mark.parametrize("kind", LEFT_OUT)
def test_what_is_not_written_out_is_left_out_and_told(kind):
    body, words = LEFT_OUT[kind]
    bombs = "const a = Array(9000).fill(0);" if kind == "a bomb" else ""
    assert_shows(drawing(body + BARS, bombs), BARS, remarks=(words,))


def test_defaults_choose_between_drawings():
    body = '{filled ? <path d="M1 1"/> : <path d={filled ? "M2 2" : "M3 3"}/>}'
    markup, remarks = markup_of(drawing(body, "const A = ({ filled = false }) => "))
    assert (markup.count("<path"), remarks) == (1, [])
    assert 'd="M3 3"' in markup
