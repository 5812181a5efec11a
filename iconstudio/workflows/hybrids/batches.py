"""A batch of hybrids as a sheet takes it in: none that looks like one that is there already."""

from collections.abc import Generator, Sequence
from contextlib import closing
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from iconstudio.algorithms.iconification.energy import joined_ink
from iconstudio.algorithms.iconification.ranking import Gallery
from iconstudio.model import CANVAS, Composite, Drawing, Remix
from iconstudio.workflows.events import Event, Result

SIDE = 2 * CANVAS
"""Side of what is kept of a hybrid's pixels: there may be hundreds."""


class Seen:
    """All hybrids on a sheet, to know repeats in later batches. For one thread at a time.

    Parameters
    ----------
    shown
        Those that are there from the beginning.
    """

    def __init__(self, shown: Sequence[Remix] = ()) -> None:
        self._gallery = Gallery()
        self._shown = shown
        self.count = len(shown)

    def add(self, composite: Composite) -> bool:
        """Note a hybrid; return whether it is new."""
        shown, self._shown = self._shown, ()
        for icon in shown:  # only now: this takes a while
            self._gallery.add(_ink(icon.composite))
        new = self._gallery.add(_ink(composite))
        self.count += new
        return new


def new_hybrids(draws: Generator[Event], title: str, seen: Seen) -> Generator[Event]:
    """Pass on the events of a mix but the hybrids that ``seen`` has; their titles get numbers."""
    with closing(draws):
        for event in draws:
            match event:
                case Result(Remix() as icon):
                    if seen.add(icon.composite):
                        named = f"{title} {seen.count}"
                        small = replace(icon, drawing=_reduced(icon.drawing), title=named)
                        yield replace(event, icon=small)
                case _:
                    yield event


def _ink(composite: Composite) -> NDArray[np.bool_]:
    """Return the joined ink of a composite whose icons lie where they are."""
    inks = np.stack([source.exemplar.ink for source in composite.sources])
    return joined_ink(inks, composite.labels)


def _reduced(drawing: Drawing) -> Drawing:
    if len(drawing.coverage) <= SIDE:
        return drawing
    from PIL import Image

    picture = Image.fromarray(drawing.coverage).resize((SIDE, SIDE), Image.Resampling.BOX)
    return replace(drawing, coverage=np.asarray(picture))
