"""However a drawing is written down, it is the same drawing."""

from dataclasses import dataclass

import numpy as np
from hypothesis import given, settings
from hypothesis import strategies as st

from iconstudio.model import Frame
from iconstudio.svg.decode import decode
from iconstudio.svg.parse import parse
from iconstudio.svg.plain import document, plain
from iconstudio.svg.resvg import render_coverage

BOX = (0.0, 0.0, 100.0, 100.0)
FRAME = Frame(0, 0, 100)

numbers = st.integers(5, 60)
colours = st.sampled_from(
    [
        (
            "#000000",
            ["black", "#000", "rgb(0 0 0)", "hsl(0, 0%, 0%)", "oklab(0 0 0)", "RGB(0,0,0)"],
        ),
        ("#ffffff", ["white", "#FFF", "rgb(100% 100% 100%)", "lab(100 0 0)", "hwb(0 100% 0%)"]),
        ("none", ["none", "NONE"]),
    ]
)


@dataclass(frozen=True)
class Shape:
    """A shape in its plain form, as it is written, and its properties with all their spellings."""

    plain: str
    written: str
    paints: tuple[tuple[str, str, str], ...]
    """Property, plain value and other spelling."""


@st.composite
def shapes(draw):
    x, y, width, height = (draw(numbers) for _ in range(4))
    right, bottom = x + width, y + height
    path = f"M{x} {y}H{right}V{bottom}H{x}Z"
    written = draw(
        st.sampled_from(
            [
                f'<rect x="{x}" y="{y}" width="{width}px" height="{height}"',
                f'<path d="M{x},{y}h{width}v{height}h-{width}z"',
                f'<polygon points="{x},{y} {right} {y},{right},{bottom} {x} {bottom}"',
                f'<path d="m{x}.0 {y}l{width} 0 0 {height}-{width} 0Z"',
            ]
        )
    )
    paints = []
    for name in ("fill", "stroke"):
        value, spellings = draw(colours)
        paints.append((name, value, draw(st.sampled_from(spellings))))
    thick = draw(st.integers(1, 6))
    spelling = draw(st.sampled_from([f"{thick}", f"{thick}px", f"{thick / 16}rem", f"+{thick}.0"]))
    paints.append(("stroke-width", str(thick), spelling))
    return Shape(f'<path d="{path}"', written, tuple(paints))


class Writer:
    """Writes a drawing in odd notations; keeps what belongs at its beginning."""

    def __init__(self, draw):
        self.draw = draw
        self.rules: list[str] = []
        self.defs: list[str] = []

    def choose(self, *options):
        return self.draw(st.sampled_from(options))

    def shape(self, shape):
        attributes, style, classes = "", "", []
        for name, _, value in shape.paints:
            match self.choose("attribute", "style", "class", "variable", "important"):
                case "attribute":
                    attributes += f' {name}="{value}"'
                case "style":
                    attributes += f' {name}="red"'
                    style += f"{name}:{value};"
                case "class":
                    classes.append(f"c{len(self.rules)}")
                    self.rules.append(f".{classes[-1]}{{{name}:{value}}}")
                case "variable":
                    style += f"--v{len(self.rules)}:{value};{name}:var(--v{len(self.rules)},red);"
                    self.rules.append("")
                case "important":
                    classes.append(f"c{len(self.rules)}")
                    style += f"{name}:red;"
                    self.rules.append(f".{classes[-1]}{{{name}:{value} !important}}")
        text = f'{shape.written}{attributes} class="{" ".join(classes)}" style="{style}"/>'
        match self.choose("here", "used", "symbol", "switch"):
            case "used":
                self.defs.append(text.replace(" ", f' id="d{len(self.defs)}" ', 1))
                return f'<use {self.choose("href", "xlink:href")}="#d{len(self.defs) - 1}"/>'
            case "symbol":
                self.defs.append(
                    f'<symbol id="d{len(self.defs)}" overflow="visible">{text}</symbol>'
                )
                return f'<use href="#d{len(self.defs) - 1}"/>'
            case "switch":
                return f'<switch><g requiredExtensions="a"/><g>{text}</g></switch>'
        return text

    def group(self, inner):
        """Return a group with a transform, plainly and oddly."""
        x, y = self.draw(st.integers(-20, 20)), self.draw(st.integers(-20, 20))
        plainly = f'<g transform="translate({x} {y})">{inner[0]}</g>'
        oddly = self.choose(
            f'<g transform="translate({x},{y})">{inner[1]}</g>',
            f'<g style="transform:translate({x}px,{y}px)">{inner[1]}</g>',
            f'<g style="translate:{x}px {y}px">{inner[1]}</g>',
            f'<g transform="translate({x})translate(0,{y})">{inner[1]}</g>',
            f'<a href="https://example.org" transform="matrix(1 0 0 1 {x} {y})">{inner[1]}</a>',
            f'<inkscape:x/><g transform="rotate(90)rotate(-90)translate({x} {y})">{inner[1]}</g>',
            f'<g style="transform:translate({y}px,{-x}px);rotate:90deg">'
            f'<g transform="rotate(-90)">{inner[1]}</g></g>',
        )
        return plainly, oddly


@st.composite
def drawings(draw):
    """A drawing plainly and oddly written."""
    writer = Writer(draw)

    def build(depth):
        plainly, oddly = "", ""
        for _ in range(draw(st.integers(1, 3))):
            if depth and draw(st.booleans()):
                one = writer.group(build(depth - 1))
            else:
                shape = draw(shapes())
                paints = "".join(f' {name}="{value}"' for name, value, _ in shape.paints)
                one = f"{shape.plain}{paints}/>", writer.shape(shape)
            plainly, oddly = plainly + one[0], oddly + one[1]
        return plainly, oddly

    plainly, oddly = build(2)
    head = f"<style>{''.join(writer.rules)}</style><defs>{''.join(writer.defs)}</defs>"
    parts = [head, oddly] if draw(st.booleans()) else [oddly, head]
    namespace = draw(st.sampled_from(['xmlns="http://www.w3.org/2000/svg" ', ""]))
    return (
        f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 100 100">{plainly}</svg>',
        f'<svg {namespace}viewBox="0 0 100 100">{"".join(parts)}</svg>',
    )


@given(drawings(), st.sampled_from(["utf-8", "utf-16", "utf-8-sig"]))
@settings(max_examples=150)
def test_any_notation_gives_the_picture_of_the_plain_form(drawing, encoding):
    plainly, oddly = drawing
    read = plain(*parse(decode(oddly.encode(encoding))))
    assert read.remarks == ()
    drawn = render_coverage(document(read.content, BOX), FRAME, 100).astype(int)
    expected = render_coverage(plainly, FRAME, 100).astype(int)
    assert np.abs(drawn - expected).max() <= 3


@given(drawings())
@settings(max_examples=50)
def test_what_is_plain_stays_as_it_is(drawing):
    once = plain(*parse(drawing[1]))
    again = plain(*parse(document(once.content, BOX)))
    assert (again.page, again.remarks) == (BOX, ())
    first = render_coverage(document(once.content, BOX), FRAME, 64).astype(int)
    second = render_coverage(document(again.content, BOX), FRAME, 64).astype(int)
    assert np.abs(first - second).max() <= 1
