"""What style sheets compute, clip and hand on, and drawings within drawings: the right picture."""

import base64

import pytest

from tests.svg.pictures import BODY, HOUSE, OUTLINE, PATH, ROOF, WINDOW, assert_shows, read, svg

pytestmark = pytest.mark.thorough(but=1)

EVENODD = f'fill-rule="evenodd" d="{HOUSE}"'
CODED = base64.b64encode(svg(PATH).encode()).decode()
TWO = svg(
    f'<style>path{{fill:#000;fill-rule:evenodd}}</style><g id="a"><path d="{HOUSE}"/></g>'
    '<g id="b" style="display:none"/>'
)

AS_THE_HOUSE = {
    "computed geometry": svg(
        f'<path d="{BODY}"/><rect style="x:calc(3px * 3);y:calc((10px + 2px));fill:#fff;'
        'width:min(6px, 60px);height:clamp(1px, 5px, 9px)"/>'
    ),
    "computed of percentages": svg(
        f'<path d="{BODY}"/><rect x="calc(50% - 3px)" y="calc(100% / 2)" width="calc(25% + 0px)"'
        ' height="5" fill="#fff"/>'
    ),
    "moved by percentages": svg(
        f'<g style="transform:translate(50%, 50%)"><g style="transform:translate(-12px, -12px)">'
        f'{PATH}</g></g><g style="transform-box:fill-box;transform:translateX(100%)"/>'
    ),
    "computed attribute": svg(
        f'<path d="{BODY}"/><rect x="calc(1px + 8px)" y="12" width="6" height="5" fill="#fff"/>'
    ),
    "computed variable": svg(
        f'<path d="{BODY}"/><rect style="--u:3px;x:calc(var(--u) * 3);y:calc(var(--u) * 4)"'
        ' width="calc(12px / 2)" height="5" fill="#fff"/>'
    ),
    "computed transform": svg(
        f'<g style="transform:translate(calc(4px - 1px), 0) rotate(calc(90deg * 0))">{PATH}</g>'
    ),
    "clipped to a polygon": svg(
        f'<path d="{BODY}"/><rect width="24" height="24" fill="#fff" style="clip-path:'
        'polygon(37.5% 50%, 15px 12px, 15px 17px, 37.5% 17px)"/>'
    ),
    "clipped to an inset": svg(
        f'<path d="{BODY}"/><rect width="24" height="24" fill="#fff" style="clip-path:'
        'inset(50% 37.5% 7px 9px)"/>'
    ),
    "clipped to a path": svg(
        f'<path d="{BODY}"/><rect width="24" height="24" fill="#fff" style="clip-path:'
        f"path(evenodd, '{WINDOW}')\"/>"
    ),
    "clipped by the page's box": svg(
        f'<path d="{BODY}"/><rect x="9" y="9" width="9" height="9" fill="#fff" style="clip-path:'
        'polygon(37.5% 50%, 62.5% 50%, 62.5% 17px, 9px 17px) view-box"/>'
    ),
    "variable of a use": svg(
        f'<defs><g id="a"><path style="fill:var(--a,red);fill-rule:evenodd" d="{HOUSE}"/>'
        '<path style="fill:var(--b, #000)" d="M0 0h24v24H0z"/></g></defs>'
        '<g style="--a:#000"><use href="#a" style="--b:none"/></g>'
    ),
    "variable of a use of a use": svg(
        f'<defs><path id="a" style="fill:var(--a,none)" {EVENODD}/><g id="b"><use href="#a"/></g>'
        '</defs><style>.on{--a:#000}</style><use class="on" href="#b"/>'
    ),
    "nested media": svg(
        f"<style>path{{fill:red;@media screen{{fill-rule:evenodd}}@media print{{fill:none}}}}"
        f'</style><path d="{HOUSE}"/>'
    ),
    "a drawing within": svg(
        f'<image width="24" height="24" href="data:image/svg+xml;base64,{CODED}"/>'
    ),
    "a drawing within, in words": svg(
        '<g fill="none" stroke="red"><image x="6" y="6" width="12" height="12" xlink:href="'
        f'data:image/svg+xml,{svg(PATH).replace("<", "%3C").replace(chr(34), "%22")}"/></g>'
    ),
    "a drawing within, with ids and rules of its own": svg(
        '<style>path{fill:none}</style><clipPath id="c"><path d="M0 0h1v1z"/></clipPath>'
        '<image width="24" height="24" href="data:image/svg+xml;base64,'
        + base64.b64encode(
            svg(
                '<style>path{fill:#000}</style><clipPath id="c"><path d="M0 0h24v24H0z"/>'
                f'</clipPath><g clip-path="url(#c)">{PATH}</g>'
            ).encode()
        ).decode()
        + '"/>'
    ),
}


@pytest.mark.parametrize("kind", AS_THE_HOUSE)
def test_the_house_is_drawn(kind):
    assert_shows(AS_THE_HOUSE[kind], PATH)


AS_SHAPES = {
    "circle": ("circle(25% at 50% 12px)", '<circle cx="12" cy="12" r="6"/>'),
    "circle up to a side": ("circle(at 75% 50%)", '<circle cx="18" cy="12" r="6"/>'),
    "ellipse": ("ellipse(8px 25% at center)", '<ellipse cx="12" cy="12" rx="8" ry="6"/>'),
    "round inset": (
        "inset(4px 2px round 3px)",
        '<rect x="2" y="4" width="20" height="16" rx="3"/>',
    ),
    "rect": ("rect(4px 22px 20px auto)", '<rect y="4" width="22" height="16"/>'),
}


@pytest.mark.parametrize("kind", AS_SHAPES)
def test_basic_shapes_clip(kind):
    value, expected = AS_SHAPES[kind]
    assert_shows(svg(f'<rect width="24" height="24" style="clip-path:{value}"/>'), expected)


def test_strokes_are_computed_and_stay_strokes():
    document = svg(
        f'<path style="fill:none;stroke:#000;stroke-width:calc(1px + .0625rem)" d="{ROOF}"/>'
    )
    assert_shows(document, OUTLINE)
    assert "stroke" in read(document).svg


SAID = {
    "unknown units": (svg(f'{PATH}<rect style="x:calc(5vw - 2px)" d=""/>'), "calc(5vw - 2px)"),
    "unknown shape": (svg(f'<g style="clip-path:circle(tomorrow)">{PATH}</g>'), "circle(tomorrow)"),
    "another file's drawing": (
        svg(f'{PATH}<image width="9" height="9" href="icons/x.svg#a"/>'),
        "A drawing in another file (“icons/x.svg”)",
    ),
    "damaged drawing within": (
        svg(f'{PATH}<image width="9" height="9" href="data:image/svg+xml,Dear dog"/>'),
        "was left out",
    ),
}


@pytest.mark.parametrize("kind", SAID)
def test_what_is_left_out_is_told(kind):
    document, words = SAID[kind]
    assert_shows(document, PATH, remarks=(words,))


def test_drawings_within_drawings_end():
    document = svg(PATH)
    for _ in range(9):
        inner = base64.b64encode(document.encode()).decode()
        address = f"data:image/svg+xml;base64,{inner}"
        document = svg(f'{PATH}<image width="9" height="9" href="{address}"/>')
    assert any("was left out" in remark for remark in read(document).remarks)


LEFT_OUT = {
    "offset-path: path('M2 2L9 9'); offset-distance: 50%": "A path of motion (offset-path)",
    "offset: path('M2 2L9 9') 50% auto": "A path of motion (offset-path)",
    "mask-image: linear-gradient(#000 50%, transparent 50%)": (
        "“mask-image: linear-gradient(#000 50%, transparent 50%)” was not understood"
    ),
    "-webkit-mask: radial-gradient(circle, #000 50%, #0000 51%)": "“-webkit-mask: radial-gradient(",
    f"clip-path: shape({'from 0 0, ' * 9})": f"shape({'from 0 0, ' * 5}from…” was not understood",
    "transform: perspective(99px) rotateY(40deg)": "“transform: perspective(99px) rotateY(",
}


@pytest.mark.parametrize("style", LEFT_OUT)
def test_what_moves_or_cuts_and_is_not_drawn_is_told(style):
    assert_shows(svg(f'<g style="{style}">{PATH}</g>'), PATH, remarks=[LEFT_OUT[style]])


@pytest.mark.parametrize("style", ["offset-path: none", "offset-rotate: 45deg", "offset: none"])
def test_what_moves_nothing_is_not_told(style):
    assert_shows(svg(f'<g style="{style}">{PATH}</g>'), PATH)


@pytest.mark.parametrize(
    "style",
    [
        "-webkit-clip-path: polygon(0 0, 12px 0, 12px 24px, 0 24px) view-box",
        "-webkit-transform: scale(.5, 1)",
        "-webkit-transform: scale(.5, 1); -webkit-transform-origin: 0 0",
    ],
)
def test_older_names_of_properties_are_read(style):
    page = '<path d="M0 0h24v24H0z"/>'
    assert_shows(svg(f'<g style="{style}">{page}</g>'), '<path d="M0 0h12v24H0z"/>')
