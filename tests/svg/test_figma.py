"""What Figma exports as web pages within SVG."""

import pytest

from iconstudio.svg.figma import IN_ONE_COLOUR
from tests.svg.pictures import BODY, ink, overlap, read, svg

STOP = "{{&quot;color&quot;:{{{}}},&quot;position&quot;:{}}}"
STOPS = ",".join(
    STOP.format(f"&quot;r&quot;:{r},&quot;g&quot;:{g},&quot;b&quot;:0.0,&quot;a&quot;:{a}", at)
    for r, g, a, at in ((1.0, 0.5, 1.0, 0), (0.6, 0.1, 0.1, 1))
)
ANGULAR = f"{{&quot;type&quot;:&quot;GRADIENT_ANGULAR&quot;,&quot;stops&quot;:[{STOPS}]}}"
FRAME = 'viewBox="0 0 24 24" fill="none"'
PAGE = (
    '<foreignObject x="-30" y="-30" width="60" height="60"><div xmlns="http://www.w3.org/1999/xhtml"'
    ' style="{};height:100%;width:100%"></div></foreignObject>'
)
CONIC = PAGE.format("background:conic-gradient(from 90deg,#f80 0deg,#840 360deg)")
BLUR = PAGE.format("backdrop-filter:blur(4px);clip-path:url(#c)")
CLIP = f'<defs><clipPath id="c"><path d="{BODY}"/></clipPath></defs>'
INSTEAD = f'<g clip-path="url(#c)" data-figma-skip-parse="true"><g>{CONIC}</g></g>'
SHAPE = f'<path d="{BODY}" data-figma-gradient-fill="{{}}"/>'


@pytest.mark.parametrize(
    ("said", "beside"),
    [
        (ANGULAR, INSTEAD),
        (ANGULAR, ""),
        ("{&quot;type&quot;:&quot;GRADIENT_ANGULAR&quot;}", INSTEAD),
        ("{&quot;stops&quot;:[]}", INSTEAD),
        ("{...}", INSTEAD),
        ("[" * 100_000, INSTEAD),
    ],
)
def test_an_angular_gradient_is_one_colour_and_told(said, beside):
    document = svg(beside + SHAPE.format(said) + CLIP, FRAME)
    assert read(document).remarks == (IN_ONE_COLOUR,)
    assert overlap(ink(document), ink(svg(f'<path d="{BODY}"/>'))) > 0.99


def test_its_colour_tells_it_from_what_is_on_it():
    on_it = '<path fill="{}" d="M9 12h6v5H9z"/>'
    document = INSTEAD + SHAPE.format(ANGULAR) + CLIP
    white, alike = (ink(svg(document + on_it.format(one), FRAME)) for one in ("#fff", "#f67600"))
    assert not white[165, 128]
    assert alike[165, 128]


def test_shapes_in_place_of_a_gradient_are_drawn_as_they_are():
    quarter = '<rect width="30" height="30" fill="#f80" transform="scale({})"/>'
    four = "".join(quarter.format(one) for one in ("1", "1 -1", "-1 1", "-1"))
    group = f'<g clip-path="url(#c)" data-figma-skip-parse="true">{four}</g>'
    document = svg(group + SHAPE.format(ANGULAR) + CLIP, FRAME)
    assert read(document).remarks == ()
    assert overlap(ink(document), ink(svg(f'<path d="{BODY}"/>'))) > 0.99


@pytest.mark.parametrize(
    "glass",
    [
        f'<g data-figma-bg-blur-radius="8"><path d="{BODY}" fill="#a8f"/></g>',
        f'<path d="{BODY}" fill="#a8f" data-figma-bg-blur-radius="8"/>',
        f'<path d="M9 12h6v5H9z" fill="#f46"/><path d="{BODY}" fill="#a8f" '
        'data-figma-bg-blur-radius="8"/>',
    ],
)
def test_nothing_is_said_of_a_blurred_backdrop(glass):
    document = svg(BLUR + glass + CLIP, FRAME)
    assert read(document).remarks == ()
    assert overlap(ink(document), ink(svg(f'<path d="{BODY}"/>'))) > 0.99


def test_another_web_page_is_told():
    glass = f'<g data-figma-bg-blur-radius="8"><path d="{BODY}" fill="#a8f"/></g>'
    (remark,) = read(svg(BLUR + glass + PAGE.format("color:red") + CLIP, FRAME)).remarks
    assert "only web pages show" in remark
