"""Which style rules win, and which apply: cascade layers and conditions, as browsers have it."""

import pytest

from iconstudio.svg.parse import parse
from iconstudio.svg.styles import apply_styles
from tests.svg.pictures import assert_shows, svg

AS_RING = "circle{fill:none;stroke:#000}"
AS_DISC = "{fill:#000;stroke:#000}"


def document(style: str, attributes: str = "") -> str:
    """Return a circle of a style sheet."""
    circle = f'<circle id="x" class="k" cx="12" cy="12" r="9" stroke-width="3"{attributes}/>'
    return svg(f"<style>{style}</style>{circle}")


def is_ring(style: str, attributes: str = "") -> bool:
    """Whether a circle of this style sheet is not filled but stroked."""
    root, _ = parse(document(style, attributes))
    apply_styles(root)
    (circle,) = root.iter("circle")
    assert circle.get("stroke") == "#000000"
    return circle.get("fill") == "none"


@pytest.mark.parametrize(
    "style",
    [
        f"@layer a{{#x{AS_DISC}}} {AS_RING}",
        f"{AS_RING} @layer a{{#x{AS_DISC}}}",
        f"@layer a,b; @layer b{{{AS_RING}}} @layer a{{#x{AS_DISC}}}",
        f"@layer a{{#x{AS_DISC}}} @layer b{{{AS_RING}}}",
        f"@layer b{{}} @layer a{{{AS_RING}}} @layer b{{#x{AS_DISC}}}",
        f"@layer{{#x{AS_DISC}}} @layer{{{AS_RING}}}",
        f"@layer a{{@layer b{{#x{AS_DISC}}} {AS_RING}}}",
        f"@layer a{{@layer b,c; @layer c{{{AS_RING}}} @layer b{{#x{AS_DISC}}}}}",
        f"@layer a.b,a.c; @layer a{{@layer c{{{AS_RING}}}}} @layer a.b{{#x{AS_DISC}}}",
        f"@media screen{{@layer a{{#x{AS_DISC}}}}} @layer b{{{AS_RING}}}",
        "@layer a{circle{fill:none!important;stroke:#000}} #x{fill:#000!important}",
        "@layer a{.k{fill:none!important;stroke:#000}} @layer b{#x{fill:#000!important}}",
        "@layer a{circle{fill:#000!important} @layer b{circle{fill:none!important;stroke:#000}}}",
        f"{AS_RING} @layer a,b; @layer a{{#x{{fill:none;stroke:#000}}}} @layer b{{}}",
        f"circle{AS_DISC} circle{{@layer a{{fill:#000}}}} {AS_RING}",
    ],
)
def test_the_later_layer_wins_and_no_layer_over_all(style: str) -> None:
    """However specific the rules of other layers are; what is important, the other way round."""
    assert is_ring(style)


def test_a_style_attribute_wins_over_layers() -> None:
    """Both where it is important and where nothing is."""
    assert is_ring(f"@layer a{{#x{AS_DISC}}}", ' style="fill:none;stroke:#000"')
    important = ' style="fill:none!important;stroke:#000"'
    assert is_ring("@layer a{#x{fill:#000!important}}", important)


def test_a_layer_wins_over_presentation_attributes() -> None:
    """Which are weaker than all rules."""
    assert is_ring(f"@layer a{{{AS_RING}}}", ' fill="#000"')


@pytest.mark.parametrize(
    "condition",
    [
        "(display:grid)",
        "( display : inline-grid )",
        "(fill:none)",
        "(fill:#123456) and (stroke-width:2px)",
        "not (display:banana)",
        "(display:banana) or (display:flex)",
        "((display:banana) or (display:flex)) and (not (display:cherry))",
        "not ((display:grid) and (display:banana))",
        "(color:oklch(50% 0.1 20))",
        "(transform:rotate(4deg))",
        "(mix-blend-mode:multiply)",
        "(--anything:goes)",
        "(width:calc(1px + 2%))",
        "(width:max(1px,2px)) and (height:fit-content)",
        "(d:path('M0 0h4'))",
        "(gap:2px) and (aspect-ratio:1/2)",
        "(display:grid !important)",
        "selector(:has(a))",
        "selector(circle > .a)",
        "not selector(:banana)",
        "not banana(1)",
        "font-format(woff2)",
        "(-webkit-mask-image:none)",
    ],
)
def test_a_condition_that_browsers_meet_holds(condition: str) -> None:
    """Its rules apply."""
    assert is_ring(f"circle{AS_DISC} @supports {condition}{{{AS_RING}}}")
    assert not is_ring(f"circle{AS_DISC} @supports not ({condition}){{{AS_RING}}}")


@pytest.mark.parametrize(
    "condition",
    [
        "not (display:grid)",
        "(display:banana)",
        "(banana:1px)",
        "(fill:banana)",
        "(display:grid) and (display:banana)",
        "not (not (display:banana))",
        "(width:banana(2px))",
        "(color:12px)",
        "(opacity:red)",
        "(stroke-width:red)",
        "(fill:)",
        "(-ms-ime-align:auto)",
        "(-moz-appearance:meterbar)",
        "selector(:banana)",
        "selector(::banana)",
        "banana(1)",
        "(display:grid) or (display:flex) and (color:red)",
        "font-format(banana)",
    ],
)
def test_a_condition_that_browsers_do_not_meet_fails(condition: str) -> None:
    """Its rules do not apply."""
    assert not is_ring(f"circle{AS_DISC} @supports {condition}{{{AS_RING}}}")


def test_conditions_within_rules_hold_and_fail() -> None:
    """As CSS Nesting allows."""
    style = "circle{{fill:#000;stroke:#000; @supports ({}){{fill:none}}}}"
    assert is_ring(style.format("display:grid"))
    assert not is_ring(style.format("display:banana"))


def test_layers_and_conditions_in_the_picture() -> None:
    """The whole way in."""
    style = f"@layer a{{#x{AS_DISC}}} {AS_RING} @supports not (display:grid){{*{{display:none}}}}"
    plain = '<circle cx="12" cy="12" r="9" stroke-width="3" fill="none" stroke="#000"/>'
    assert_shows(document(style), plain)
