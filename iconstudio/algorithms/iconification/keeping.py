"""What an edit leaves as it is, and what it takes off (section 4.2).

The paper only favours E_0 where nothing is marked (equation 11), the less the nearer to a mark, and
other icons in all that is marked. Strong seams outweigh that: lines beside an addition give way,
what comes in is wider than its mark, and another icon puts back what was taken off. Here a mark is
an order, as in a montage, and so is what was not marked: it keeps its looks, whoever owns it, so
that seams may run there where their sources agree.
"""

from dataclasses import dataclass

import numpy as np
import scipy
from numpy.typing import NDArray

from iconstudio.algorithms.iconification.guidance import HELD
from iconstudio.algorithms.iconification.guide import INK, thin
from iconstudio.algorithms.raster import Bitmap
from iconstudio.model import CANVAS

JOIN = 4
"""Canvas units beyond an added area in which a part may still join the icon."""


@dataclass(frozen=True, eq=False)
class Kept:
    """What must be ink, and what must be paper; both (m, m)."""

    ink: Bitmap
    paper: Bitmap

    def cost(self, ink: NDArray[np.bool_], whole: NDArray[np.bool_]) -> NDArray[np.float32]:
        """Return what sources (K, m, m) bool cost where they show anything else, (K, m, m).

        Those that are ``whole`` (K,), a hat that was sketched roughly, may have ink on paper.
        """
        paper = self.paper & ~whole[:, None, None]
        return np.where(np.where(ink, paper, self.ink), np.float32(HELD), np.float32(0))


def kept(ink: Bitmap, removed: Bitmap, added: Bitmap, drawn: Bitmap, silhouette: Bitmap) -> Kept:
    """Return what an edit keeps of an icon; all are (m, m).

    Lines that an added area covers stay, too, and those that are taken off stay away. What is wide
    there, a body, may become the ground of a part, such as a wheel with its hub, or fill the gap
    that one leaves. Where the outline is left open, a line may close it.

    Parameters
    ----------
    ink
        The icon's.
    drawn
        What is drawn inside the outline.
    silhouette
        The outline that is wanted, filled.
    """
    unit = len(ink) / CANVAS
    joining, inside = _within(added, JOIN * unit), _within(drawn, INK / 2 * unit)
    wide = ink & ~thin(ink, round(INK * unit))
    stays = ink & ~removed & ~inside & ~(added & wide)
    edge = silhouette & ~stays & _within(removed & ~silhouette, 1.5)
    closing = silhouette & _within(edge, INK * unit)
    return Kept(stays, (removed & ~wide | ~ink) & ~(joining | inside | closing))


def _within(marked: Bitmap, reach: float) -> Bitmap:
    """Return what lies no further than ``reach`` pixels from what is marked."""
    if not marked.any():
        return marked
    near: Bitmap = scipy.ndimage.distance_transform_edt(~marked) <= reach
    return near
