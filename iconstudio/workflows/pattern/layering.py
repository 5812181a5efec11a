"""The layers of an image, to be looked at and corrected before, and while, it is continued."""

from collections.abc import Generator
from concurrent.futures import wait
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from iconstudio.model import Separation, hex_colour
from iconstudio.workers import answer
from iconstudio.workflows.workflow import Resources

_SECONDS, _MEMORY = 60.0, 2 << 30
_PATIENCE = 0.05
"""Seconds that pass at most before it can be stopped."""


@dataclass(frozen=True, slots=True, eq=False)
class ImageLayers:
    """An image, and which layer each of its pixels is of."""

    image: Separation
    separated: NDArray[np.uint8]
    """(h, w), from the ground, 0, up; before corrections."""
    numbers: NDArray[np.uint8]
    """(h, w), corrected."""
    colours: tuple[str, ...]
    """The mean colour of each layer, ``#rrggbb``."""


def layers_of(
    resources: Resources, image: Separation, before: ImageLayers | None = None
) -> Generator[None, None, ImageLayers]:
    """Return the layers of an image; yield now and then, where it can be closed.

    Parameters
    ----------
    before
        What was found before: where only the corrections are others, nothing is separated anew.

    Raises
    ------
    IconstudioError
        If it cannot be separated.
    """
    from iconstudio.workflows.pattern.imaging import ImageExemplar, corrected

    plain = ImageExemplar.of(replace(image, corrections=()))
    if before is not None and replace(before.image, corrections=()) == replace(
        image, corrections=()
    ):
        separated, colours = before.separated, before.colours
    else:
        ticket = resources.workers.ticket()
        try:
            task = resources.workers.submit(
                ImageExemplar.layers, plain, timeout=_SECONDS, memory=_MEMORY, ticket=ticket
            )
            while not wait([task], _PATIENCE).done:
                yield
        finally:
            ticket.stop()
        separated = answer(task, "Separating the colours", "Give an image of flat colours.")
        colours = _means(plain.pixels, separated)
    numbers = corrected(separated, image.corrections, plain.reduction)
    return ImageLayers(image, separated, numbers, colours)


def _means(pixels: NDArray[np.uint8], numbers: NDArray[np.uint8]) -> tuple[str, ...]:
    """Return the mean colour of each layer."""
    count = int(numbers.max()) + 1
    means = [pixels[numbers == number].mean(axis=0) for number in range(count)]
    return tuple(hex_colour(np.rint(mean)) for mean in means)
