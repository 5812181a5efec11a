"""Whether what is removed from an icon leaves an outline open, which nothing then closes."""

from iconstudio.algorithms.raster import Bitmap, solid

OPENED = (
    "What you remove leaves the outline open. Sketch in green how it goes on there, or remove "
    "all of the line."
)
_MUCH = 0.25
"""How much of what an icon's lines enclose lies open then, at least."""


def is_opened(ink: Bitmap, removed: Bitmap, added: Bitmap) -> bool:
    """Return whether much of what ink encloses is open once some is removed; all (m, m)."""
    enclosed = solid(ink) & ~ink
    lost = enclosed & ~removed & ~solid((ink & ~removed) | added)
    return bool(lost.sum() > _MUCH * enclosed.sum())
