"""Draws a batch of hybrids: what a workspace's thread does, so that the window's need not."""

from collections.abc import Generator, Sequence
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from iconstudio.algorithms.iconification.energy import joined_ink
from iconstudio.algorithms.iconification.ranking import Gallery
from iconstudio.gui.gallery.pictures import Picture, pictured
from iconstudio.model import CANVAS, Composite, Drawing, Mix, Remix
from iconstudio.session import Session
from iconstudio.workflows.events import Event
from iconstudio.workflows.hybrids.spec import HYBRIDS

SIDE = 2 * CANVAS
"""Side of what is kept of a hybrid's pixels: there may be hundreds."""
CODED = CANVAS
"""Side of its colour-coded picture."""


class Seen:
    """All hybrids on a sheet, to know repeats in later batches. For one thread at a time.

    Parameters
    ----------
    shown
        Those that are there from the beginning.
    """

    def __init__(self, shown: Sequence[Picture] = ()) -> None:
        self._gallery = Gallery()
        self._shown = shown
        self.count = len(shown)

    def add(self, composite: Composite) -> bool:
        """Note a hybrid; return whether it is new."""
        shown, self._shown = self._shown, ()
        for picture in shown:  # only now: this takes a while
            self._gallery.add(_ink(picture.icon.composite))
        new = self._gallery.add(_ink(composite))
        self.count += new
        return new


def batch(session: Session, mix: Mix, title: str, seen: Seen) -> Generator[Event | Picture]:
    """Yield the progress of a mix, and a picture of each hybrid that ``seen`` has not.

    Their titles have numbers, in the order of the draws.
    """

    def new(icon: Remix) -> Remix | None:
        if not seen.add(icon.composite):
            return None
        return replace(icon, drawing=_reduced(icon.drawing), title=f"{title} {seen.count}")

    return pictured(session.run(HYBRIDS, mix), new, CODED)


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
