"""Motifs on a canvas become an exemplar: its layers, and which elements they have (section 3).

Motifs that always keep the same company move together, and those that lie on another one are
details of it. Others that overlap are in
different layers, the upper ones first; those that do not touch share one, so that they keep clear
of each other in the pattern, too.
"""

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from iconstudio.algorithms.patterns.exemplar import MOST_LAYERS, Exemplar
from iconstudio.algorithms.patterns.periods import Period, rows_apart
from iconstudio.algorithms.raster import solid
from iconstudio.model import (
    Fill,
    Frame,
    IconstudioError,
    Motif,
    Path,
    Patterning,
    Pictogram,
    Transform,
    levels_of,
)
from iconstudio.model.patterning import GROUND
from iconstudio.svg.resvg import render_coverage
from iconstudio.workflows.pattern.companions import companies
from iconstudio.workflows.pattern.density import denser

Mask = NDArray[np.float32]
"""(n, n), how much of each pixel is covered, from 0 to 1."""

_INK = 0.5
"""What covers a pixel by more has it."""
_SEEN = 0.02
"""What changes no pixel by more, of a range from 0 to 1, is not to be seen."""
_DETAIL = 0.9
"""What lies with so much of its ink on another element is a detail of it."""


@dataclass(frozen=True, slots=True, eq=False)
class Shape:
    """A motif as it lies on the canvas."""

    icon: Pictogram
    fill: Fill
    mask: Mask


@dataclass(frozen=True, slots=True, eq=False)
class Layout:
    """An exemplar, and the shapes of its elements."""

    exemplar: Exemplar
    elements: tuple[tuple[tuple[Fill, ...], ...], ...]
    """Of each layer of the exemplar, the elements by their labels, from 1; each from back to front,
    in pixels of the exemplar; none if they are not known."""
    ground: str
    """The colour behind all layers, ``#rrggbb``; empty for none."""
    period: Period = (None, None)
    """After how many pixels it repeats, or rows follow each other, down and to the right."""
    remark: str = ""
    """A sentence for the user about how it was made, if there is anything to say."""


@dataclass(frozen=True, slots=True)
class Arrangement:
    """Motifs on a canvas."""

    motifs: tuple[Motif, ...]
    paths: tuple[Path, ...]
    """Those of their icons, in units of their own canvases."""
    side: float
    """Of the canvas, in its units."""
    ground: str
    """``#rrggbb``; empty for none."""

    @classmethod
    def of(cls, work: Patterning, paths: Sequence[Path]) -> "Arrangement":
        """Return the motifs of some work as dense as it says, turned."""
        motifs, side = denser(work.motifs, work.density)
        turned = tuple(replace(one, turn=one.turn + work.turn) for one in motifs)
        return cls(turned, tuple(paths), side, work.ground)

    def layout(self, samples: float) -> Layout:
        """Return the motifs as an exemplar.

        Parameters
        ----------
        samples
            Pixels of the exemplar to a unit of the canvas.

        Raises
        ------
        IconstudioError
            If they cannot be an exemplar.
        """
        pixels = round(self.side * samples)
        shapes = []
        for motif, path in zip(self.motifs, self.paths, strict=True):
            drawn = path.transformed(motif.transform).transformed(Transform().scale(samples))
            mask = rasterised(drawn, pixels)
            if mask.max() > _INK:
                shapes.append(Shape(motif.icon, Fill(drawn, motif.colour), mask))
        if not shapes:
            raise IconstudioError("No ink of the icons lies on the canvas. Move them onto it.")
        layers = _layers(_elements(shapes))
        if len(layers) > MOST_LAYERS:
            raise IconstudioError(
                f"The icons overlap in {len(layers)} layers. "
                f"Move some apart: there may be at most {MOST_LAYERS}."
            )
        masks = np.stack([_united(shape for one in layer for shape in one) for layer in layers])
        labels = np.stack([_labels(layer, pixels) for layer in layers])
        colours, seen = _colours(shapes, pixels, self.ground or GROUND)
        exemplar = Exemplar(colours, masks, labels)
        elements = tuple(tuple(map(_fills, layer)) for layer in layers)
        places = np.array([(one.y, one.x) for one in self.motifs]).T * samples
        down, across = (rows_apart(one, self.side * samples) for one in places)
        remark = _said_of_unseen(seen) if self.ground else ""
        return Layout(exemplar, elements, self.ground, (down, across), remark)


def rasterised(path: Path, width: int, height: int | None = None) -> Mask:
    """Return how much of each pixel a path in pixels covers, (height, width)."""
    height = height or width
    side = max(width, height)
    svg = (
        f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {side} {side}">'
        f'<path d="{path.svg()}"/></svg>'
    )
    coverage = render_coverage(svg, Frame(0, 0, side), side, (0, 0, width, height))
    return (coverage / np.float32(255)).astype(np.float32)


def channels(colour: str) -> NDArray[np.float32]:
    """Return the red, green and blue of ``#rrggbb``, from 0 to 1.

    >>> channels("#ff0000").tolist()
    [1.0, 0.0, 0.0]
    """
    return np.array(levels_of(colour), np.float32) / np.float32(255)


def _elements(shapes: Sequence[Shape]) -> list[list[Shape]]:
    """Return shapes by element, from back to front.

    What keeps company is one; and a detail goes with what it lies on.
    """
    groups = companies([one.icon for one in shapes], [one.mask > _INK for one in shapes])
    elements: list[list[Shape]] = []
    for group in ([shapes[number] for number in numbers] for numbers in groups):
        under = next((one for one in reversed(elements) if _is_detail(group, one)), None)
        if under is None:
            elements.append(group)
        else:
            under.extend(group)
    return elements


def _is_detail(shapes: Sequence[Shape], element: Sequence[Shape]) -> bool:
    ground, own = solid(_united(element) > _INK), _united(shapes)
    return bool((own * ground).sum() > _DETAIL * own.sum())


def _layers(elements: Sequence[list[Shape]]) -> list[list[list[Shape]]]:
    """Return the fewest layers in which no elements overlap, the one above all others first."""
    height: list[int] = []
    masks = [_united(one) > _INK for one in elements]
    for number, mask in enumerate(masks):
        below = [height[k] for k in range(number) if (mask & masks[k]).any()]
        height.append(max(below, default=-1) + 1)
    return [
        [one for one, its in zip(elements, height, strict=True) if its == level]
        for level in reversed(range(max(height) + 1))
    ]


def _united(shapes: Iterable[Shape]) -> Mask:
    united: Mask = np.maximum.reduce([shape.mask for shape in shapes])
    return united


def _labels(elements: Sequence[Sequence[Shape]], pixels: int) -> NDArray[np.int32]:
    """Return which element each pixel belongs to, from 1; 0 where there is none."""
    none = np.zeros((pixels, pixels), np.float32)
    labels: NDArray[np.int32] = np.argmax([none, *map(_united, elements)], axis=0).astype(np.int32)
    return labels


def _colours(
    shapes: Iterable[Shape], pixels: int, ground: str
) -> tuple[NDArray[np.float32], list[bool]]:
    """Return the picture of shapes on a ground, (pixels, pixels, 3), from 0 to 1.

    And whether each can be told from what lies behind it.
    """
    picture: NDArray[np.float32] = np.broadcast_to(channels(ground), (pixels, pixels, 3))
    seen = []
    for shape in shapes:
        below, over = picture, shape.mask[..., None]
        picture = over * channels(shape.fill.colour) + (1 - over) * below
        seen.append(bool(np.abs(picture - below).max() > _SEEN))
    return picture.astype(np.float32), seen


def _said_of_unseen(seen: Sequence[bool]) -> str:
    """Return a sentence about the shapes that cannot be seen; empty if all can."""
    unseen = seen.count(False)
    if not unseen:
        return ""
    if unseen == len(seen):
        return (
            "Nothing of the pattern can be seen: it has the colour of its ground. "
            "Change one of the two."
        )
    they_have, them = ("it has", "it") if unseen == 1 else ("they have", "them")
    return (
        f"{unseen} of the {len(seen)} icons cannot be seen: "
        f"{they_have} the colour of what lies behind {them}."
    )


def _fills(element: Iterable[Shape]) -> tuple[Fill, ...]:
    return tuple(shape.fill for shape in element)
