"""Figures 6, 7 and 9 to 12 of *Curve Analogies*, made again from strokes drawn for this program.

``python -m tests.figures.curves`` writes them to ``resources/pictures/curves``, the same bytes
each time; with names such as ``figure-6``, those only. ``styles`` shows all bundled styles.
"""

import sys
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from pathlib import Path as FilePath

import numpy as np
from fontTools.svgLib.path import parse_path

from iconstudio.algorithms.curves.multiresolution import scribble
from iconstudio.algorithms.curves.outline import strokes_of
from iconstudio.algorithms.curves.restyle import Prepared, prepare, restyled
from iconstudio.algorithms.flattening import flattened
from iconstudio.inputs.line_style import read_style
from iconstudio.inputs.styles import bundled, named
from iconstudio.model import Line, LineStyle, PathPen, StylePair
from iconstudio.resources import resource

HERE = FilePath(__file__).parent
INK, WIDTH, GAP = "#1c1e22", 3.0, 34.0

SPIRAL = (
    "M70 150C40 120 60 60 130 60C220 60 250 150 200 200C140 260 20 230 10 130C0 30 90 -20 170 -10"
)
CASTLE = "M0 230L0 100L70 100L70 0L180 0L180 100L250 100L250 230Z"
CUBE = (
    "M0 60L110 60", "M110 60L110 170", "M110 170L0 170", "M0 170L0 60", "M0 60L60 0",
    "M60 0L170 0", "M170 0L110 60", "M170 0L170 110", "M170 110L110 170",
)  # fmt: skip
WORD = (
    "M0 0L16 -128L30.1 -128L30.1 0L40.3 -64L67.2 -64L67.2 0L86.4 0L102.4 -32L134.4 -32L134.4 "
    "-64L102.4 -64L102.4 0L144 0L160 -128L174.1 -128L174.1 0L198.4 0L217.6 -64L224 0L246.4 0L"
    "265.6 -64L272 0L297.6 0L307.2 -64L313.6 0L332.8 0L348.8 -64L374.4 -64L374.4 0L384.6 -64L"
    "409.6 -64L409.6 0L428.8 0"
)
CUP = (
    "M10 50L140 50L140 120C140 150 120 166 96 166L54 166C30 166 10 150 10 120Z",
    "M140 66L158 66C176 66 186 78 186 94C186 112 176 122 158 122L140 122",
    "M50 24L50 4", "M100 24L100 4",
)  # fmt: skip
BOLD, ACROSS = 12.0, 6
THIN = ("Curls", "Loops", "Retraced")
"""Styles whose loops a bold line would fill."""
SCENE = (
    ("Fur", "M0 330C90 284 170 280 270 300C370 320 470 292 600 272"),
    ("Waves", "M0 400C200 392 400 408 600 398"),
    ("Waves", "M0 430C200 438 400 420 600 432"),
    ("Rampart", "M330 306L330 170L460 170L460 298"),
    ("Loose", "M312 174L395 88L478 174"),
    ("Shaky", "M372 306L372 232L416 232L416 303"),
    ("Papercut", "M432 126L432 86L452 86L452 147"),
    ("Curls", "M442 78C434 48 468 30 452 0C440 -24 466 -40 460 -66"),
    (
        "Clouds",
        "M36 150C44 88 116 60 166 96C214 132 204 222 152 236C104 248 60 246 40 214"
        "C30 196 34 172 36 150Z",
    ),
    ("Nervous", "M102 288C106 262 104 240 106 238"),
    ("Clouds", "M180 10C184 -36 262 -52 302 -24C342 4 322 40 262 40C220 40 182 44 180 10Z"),
    (
        "Thorns",
        "M590 24C590 58 562 84 530 84C498 84 470 58 470 24C470 -8 498 -36 530 -36"
        "C562 -36 590 -8 590 24Z",
    ),
)


@dataclass(frozen=True)
class Panel:
    """Lines with what they are called; ``sign`` stands before them."""

    name: str
    lines: tuple[Line, ...]
    sign: str = ""

    @property
    def box(self) -> tuple[float, float, float, float]:
        """Left, top, right and bottom."""
        points = np.array([point for line in self.lines for point in line.points])
        return (*points.min(axis=0).tolist(), *points.max(axis=0).tolist())


def drawn(data: str, width: float = WIDTH) -> Line:
    """Return a stroke of SVG path data."""
    pen = PathPen()
    parse_path(data, pen)
    ((points, closed),) = flattened(pen.path)
    return Line(tuple(map(tuple, points.tolist())), closed, width)


def before(style: LineStyle, pair: StylePair) -> Line:
    """Return A."""
    if pair.plain:
        return Line(pair.plain, pair.closed, WIDTH)
    xs = [x for x, _ in pair.styled]
    return Line(((min(xs), 0.0), (max(xs), 0.0)), False, WIDTH)


def after(pair: StylePair) -> Line:
    """Return A'."""
    return Line(pair.styled, pair.closed, WIDTH)


def alone(lines: Iterable[Line], style: Prepared, seed: int) -> tuple[Line, ...]:
    """Return lines of which none knows of the others."""
    return tuple(restyled([(line, style)], seed + n)[0] for n, line in enumerate(lines))


def together(lines: Iterable[Line], style: Prepared, seed: int) -> tuple[Line, ...]:
    """Return lines that meet where they met."""
    return tuple(restyled([(line, style) for line in lines], seed))


def analogy(style: LineStyle, pair: StylePair, plain: Sequence[Line], seed: int) -> list[Panel]:
    """Return A : A' :: B : B'."""
    return [
        Panel("A", (before(style, pair),)),
        Panel("A′", (after(pair),), ":"),
        Panel("B", tuple(plain), "::"),
        Panel("B′", together(plain, prepare(style), seed), ":"),
    ]


def figure_6() -> list[list[Panel]]:
    """Synthesis with translation invariance: much of a little."""
    style = named("Loops")
    parameters, levels = prepare(style).whole
    made = scribble(levels, 2800.0, parameters, seed=4).curve.points
    line = Line(tuple((z.real, z.imag) for z in made.tolist()), False, WIDTH)
    return [[Panel("A′", (after(style.pairs[0]),))], [Panel("B′", (line,))]]


def figure_7() -> list[list[Panel]]:
    """An analogy with rotational invariance."""
    style = named("Loops")
    panels = analogy(style, style.pairs[0], [drawn(SPIRAL)], 2)
    return [panels[:2], panels[2:]]


def figure_9() -> list[list[Panel]]:
    """An analogy with translation invariance: what lies is smooth, what stands is not."""
    style = named("Rampart")
    return [analogy(style, style.pairs[0], [drawn(CASTLE)], 1)]


def figure_10() -> list[list[Panel]]:
    """Constraints: lines that met still meet."""
    style = named("Waves")
    cube = tuple(map(drawn, CUBE))
    prepared = prepare(style, 1.2)
    separate = Panel("B′, each by itself", alone(cube, prepared, 5), ":")
    met = Panel("B′, constrained", together(cube, prepared, 5), ":")
    return [[Panel("A′", (after(style.pairs[0]),))], [Panel("B", cube), separate, met]]


def figure_11() -> list[list[Panel]]:
    """Several styles in one drawing."""
    styles = {name: prepare(named(name)) for name, _ in SCENE}
    plain = [drawn(data) for _, data in SCENE]
    made = restyled([(line, styles[name]) for line, (name, _) in zip(plain, SCENE, strict=True)], 3)
    return [[Panel("B", tuple(plain)), Panel("B′", tuple(made), ":")]]


def figure_12() -> list[list[Panel]]:
    """Handwriting: less rigid, and flowing. It slants, so that directions are not all the same."""
    style = read_style(HERE / "handwriting.json")
    panels = analogy(style, style.pairs[0], [drawn(WORD)], 6)
    return [panels[:2], panels[2:]]


def samples() -> list[list[Panel]]:
    """All bundled styles."""
    cup = tuple(drawn(data, BOLD) for data in CUP)
    thin = tuple(drawn(data) for data in CUP)
    panels = [
        Panel(style.name, together(thin if style.name in THIN else cup, prepare(style), 1))
        for style in bundled()
    ]
    return [panels[first : first + ACROSS] for first in range(0, len(panels), ACROSS)]


FIGURES = {
    "figure-6": figure_6,
    "figure-7": figure_7,
    "figure-9": figure_9,
    "figure-10": figure_10,
    "figure-11": figure_11,
    "figure-12": figure_12,
    "styles": samples,
}


def document(rows: Sequence[Sequence[Panel]]) -> str:
    """Return an SVG of rows of panels."""
    parts, bottom, right = [], GAP, 0.0
    for row in rows:
        tall = max(panel.box[3] - panel.box[1] for panel in row)
        left = GAP
        for panel in row:
            x0, y0, x1, y1 = panel.box
            middle = bottom + tall / 2
            if panel.sign:
                parts.append(_text(left, middle + 8, panel.sign, 26))
                left += GAP
            x, y = left - x0, middle - (y0 + y1) / 2
            parts.append(f'<g transform="translate({x:.2f} {y:.2f})">')
            for path, width in strokes_of(panel.lines):
                paint = f'stroke-width="{width:g}"' if width else f'fill="{INK}" stroke="none"'
                parts.append(f'<path d="{path.svg()}" {paint}/>')
            parts.append("</g>")
            parts.append(_text(left + (x1 - x0) / 2, bottom + tall + 30, panel.name, 17))
            left += x1 - x0 + GAP
        right, bottom = max(right, left), bottom + tall + 2 * GAP
    size = f"{right:.0f}", f"{bottom:.0f}"
    return (
        f'<svg xmlns="http://www.w3.org/2000/svg" width="{size[0]}" height="{size[1]}" '
        f'viewBox="0 0 {size[0]} {size[1]}">\n<rect width="100%" height="100%" fill="#fff"/>\n'
        f'<g fill="none" stroke="{INK}" stroke-linecap="round" stroke-linejoin="round">\n'
        + "\n".join(parts)
        + "\n</g>\n</svg>\n"
    )


def _text(x: float, y: float, text: str, size: int) -> str:
    return (
        f'<text x="{x:.1f}" y="{y:.1f}" font-family="serif" font-style="italic" '
        f'font-size="{size}" text-anchor="middle" fill="{INK}" stroke="none">{text}</text>'
    )


def main(names: Iterable[str]) -> None:
    """Write figures."""
    folder = resource("pictures") / "curves"
    folder.mkdir(exist_ok=True)
    for name in names:
        (folder / f"{name}.svg").write_text(document(FIGURES[name]()), "utf-8")


if __name__ == "__main__":
    main(sys.argv[1:] or FIGURES)
