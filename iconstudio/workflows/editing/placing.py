"""An edit on the canvas: what it takes off, what it adds, what it keeps (section 4.2)."""

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from iconstudio.algorithms.iconification.energy import distance_field, remix_problem
from iconstudio.algorithms.iconification.guidance import (
    EDIT_REACH,
    HELD,
    edit_penalty,
    scribble,
    truncated_distance,
)
from iconstudio.algorithms.iconification.guide import (
    UNGUIDED,
    Guide,
    check_inner,
    filled_polygons,
    inner_aims,
)
from iconstudio.algorithms.iconification.keeping import Kept, kept
from iconstudio.algorithms.iconification.overhang import seen
from iconstudio.algorithms.iconification.symmetry import reflected
from iconstudio.algorithms.iconification.taking_off import meant, taken_off
from iconstudio.algorithms.raster import Bitmap, overlap, placed_ink, solid
from iconstudio.model import (
    CANVAS,
    MARGIN,
    Axis,
    Drawing,
    Edit,
    Exemplar,
    Frame,
    IconstudioError,
    Inner,
    Placement,
    Polygon,
    Source,
    Stroke,
)
from iconstudio.workers import Workers, answer
from iconstudio.workflows.drawing import Render
from iconstudio.workflows.editing.emptying import Emptied, begin_emptying
from iconstudio.workflows.editing.fitting import ALIKE
from iconstudio.workflows.solving import Posed

OFF_CANVAS = Placement(dx=4 * CANVAS)
"""Where an icon shows nothing."""
_CLEAR = 8
"""Units at the border of the canvas that stay free, lest what is added goes on beyond it."""
_ENCLOSED = 0.98
"""So much of an added area lies inside the icon's outline at least where it adds nothing to it."""


@dataclass(frozen=True, eq=False)
class PlacedEdit:
    """An edit on a canvas of any side m: what is wanted, and where.

    If something is added beyond the canvas, or at its border, all is made smaller so that it fits.
    """

    edit: Edit
    icon: Exemplar
    """The icon E_0."""
    base: Source
    """It without what was emptied: label 0 of the graph cut."""
    ink: Bitmap
    """(m, m): its own drawing."""
    removed: Bitmap
    added: Bitmap
    """(m, m): the red and the green areas."""
    left: Bitmap
    """(m, m): the red areas without those that are emptied."""
    keeps: Bitmap
    """(m, m): what the icon keeps of its own outline, filled."""
    silhouette: Bitmap
    """(m, m): the outline that is wanted, filled."""
    mask: NDArray[np.float32]
    """D_E, (m, m): the distance from the changed area, from 0 to 1."""
    unmarked: Kept
    """What stays as it is."""
    guide: Guide = UNGUIDED
    """What is drawn inside the outline."""
    emptied: Emptied | None = None

    def at(self, side: int) -> "PlacedEdit":
        """Return the same on a canvas of another side."""
        return place_edit(self.edit, self.icon, side, self.emptied)

    @property
    def enclosed(self) -> tuple[int, ...]:
        """Which green areas, from 1, lie inside the outline of what the icon keeps."""
        whole = solid(self.keeps)
        return tuple(
            number
            for number, area in enumerate(self.areas, start=1)
            if area.any() and whole[area].mean() > _ENCLOSED
        )

    @property
    def areas(self) -> tuple[Bitmap, ...]:
        """(m, m) each: what is added, area by area."""
        side = len(self.added)
        return tuple(_union([one], self.base.placement, side) for one in self.edit.add)

    @property
    def wanted(self) -> Bitmap:
        """(m, m): what is to be filled that the icon alone does not fill."""
        return self.silhouette & ~solid(self.keeps)

    @property
    def kept(self) -> NDArray[np.float32]:
        """D_E of what is added, and 0 where something is removed, (m, m)."""
        reach = EDIT_REACH * len(self.mask) / CANVAS
        return np.where(self.left, 0, truncated_distance(self.added, reach)).astype(np.float32)

    def penalty(self, data: NDArray[np.float32], sources: Sequence[Source]) -> NDArray[np.float32]:
        """Return P_E of labels, (K, m, m), given their data cost F_D, (K, m, m)."""
        penalty = edit_penalty(self.mask, self.kept, len(data))
        for number, source in enumerate(sources):
            if source.placement == OFF_CANVAS:
                # Within the outline, nothing fits what only goes as well as the icon did.
                within = self.left & self.silhouette & ~self.added
                penalty[number, within] = np.minimum(data[0] - data[number], 0)[within]
        return penalty

    def whole(self, filled: Bitmap) -> NDArray[np.bool_]:
        """Return which sources, (K, m, m) filled, fit an added area as a whole, (K,); not E_0."""
        fit = [any(overlap(one, area) >= ALIKE for area in self.areas) for one in filled[1:]]
        return np.array([False, *fit])

    def pose(self, symmetry: Axis | None, sources: tuple[Source, ...]) -> Posed:
        """Pose the graph cut of ``sources``, the first of which is the icon itself."""
        problem = remix_problem(distance_field(self.silhouette), sources, symmetry)
        data = self.guide.guided(problem)
        whole = self.whole(problem.solid)
        data = data + self.penalty(data, sources) + self.unmarked.cost(problem.ink, whole)
        others = {one.exemplar.id for one, fits in zip(sources, whole, strict=True) if not fits}
        if others == {self.icon.id}:
            # Whatever comes, comes whole: the icon goes on only where it was.
            theirs = problem.solid[whole].any(axis=0) & ~solid(self.keeps)
            data[~whole] += np.where(theirs, np.float32(HELD), np.float32(0))
        problem = replace(problem, data=data)
        # All but the change stays as it is.
        return Posed(
            problem, self.silhouette, near=self.mask < 1, inner=self.guide.inner, heal=False
        )

    def unchanged(self, edited: Drawing, own: Drawing) -> float:
        """Return the part of the pixels beyond the reach of the change that equal the icon's."""
        size = len(edited.coverage)
        far = seen(self.mask >= 1, edited.frame, size, True)
        same = (edited.coverage > 127) == (_shown(own.coverage, edited.frame) > 127)
        return float(same[far].mean()) if far.any() else 1.0


def place_edit(
    edit: Edit, icon: Exemplar, side: int = CANVAS, emptied: Emptied | None = None
) -> PlacedEdit:
    """Put an edit of ``icon`` on a canvas of that side; what is ``emptied`` is done already.

    Raises
    ------
    IconstudioError
        If nothing is changed, or not on the icon.
    """
    if not (edit.remove or edit.add or edit.inner != Inner()):
        raise IconstudioError(
            "Nothing is changed. Enclose what should go (remove), "
            "or sketch what should come (add), or both."
        )
    for polygon in (*edit.remove, *edit.add):
        polygon.check_area()
    placement = _room(edit, icon)
    ink, filled = placed_ink(icon, placement, side)
    removed, added = (_union(polygons, placement, side) for polygons in (edit.remove, edit.add))
    if edit.remove and not (removed & filled).any():
        raise IconstudioError(
            "The area to remove lies beside the icon. Enclose a part of the icon itself."
        )
    if edit.add and not added.any():
        raise IconstudioError(
            "What should be added is too small to be seen. Sketch it larger, in the "
            f"icon's canvas of {CANVAS} units."
        )
    base = Source(icon if emptied is None else emptied.icon, placement)
    done = () if emptied is None else emptied.areas
    own, whole = placed_ink(base.exemplar, placement, side)
    some = [one for one in edit.remove if one not in done]
    left = meant(own, _union(some, placement, side))
    gone = taken_off(own, whole, left)
    keeps = whole & ~gone
    silhouette = solid(keeps | added)
    if not silhouette.any():
        raise IconstudioError("Nothing of the icon would be left. Remove less, or add something.")
    inner = edit.inner.moved(placement.transform.transformPoint)
    inner.check()
    check_inner(inner, silhouette, gone)
    lines = scribble([Stroke(0, one) for one in inner.lines], side)
    drawn = filled_polygons(inner.holes, side) | lines
    mask = truncated_distance(removed | added | drawn, EDIT_REACH * side / CANVAS)
    guide = Guide(inner, aims=inner_aims(inner, side))
    holes = [one for one in edit.inner.holes if one not in done]
    going, coming, drawn = gone, added, _union(holes, placement, side) | lines
    if edit.symmetry is not None:  # pixels that mirror each other change together
        every = going, coming, drawn
        going, coming, drawn = (one | reflected(one, edit.symmetry) for one in every)
    unmarked = kept(own, going, coming, drawn, silhouette)
    return PlacedEdit(
        edit,
        icon,
        base,
        ink,
        removed,
        added,
        left,
        keeps,
        silhouette,
        mask,
        unmarked,
        guide,
        emptied,
    )


def place_edited(edit: Edit, icon: Exemplar, workers: Workers, render: Render) -> PlacedEdit:
    """Put an edit of ``icon`` on the canvas, what its areas enclose inside the icon taken out.

    Raises
    ------
    IconstudioError
        As ``place_edit``.
    """
    change = place_edit(edit, icon)
    if not (edit.remove or edit.inner.holes):
        return change
    emptying = begin_emptying(edit, icon, workers, render)
    emptied = answer(emptying, f"Drawing “{icon.name}”")
    return change if emptied is None else place_edit(edit, icon, CANVAS, emptied)


def paper(icon: Source) -> Source:
    """Return the icon moved off the canvas: a source that shows nothing.

    With it, what is taken off needs no other icon that happens to be white there.
    """
    return Source(icon.exemplar, OFF_CANVAS)


def _shown(coverage: NDArray[np.uint8], frame: Frame) -> NDArray[np.uint8]:
    """Return a drawing of the canvas as a frame shows it, of the same size."""
    if frame.size == CANVAS:
        return coverage
    from PIL import Image

    size = len(coverage)
    step = frame.size / CANVAS
    moved = (step, 0, frame.x * size / CANVAS, 0, step, frame.y * size / CANVAS)
    picture = Image.fromarray(coverage).transform(
        (size, size), Image.Transform.AFFINE, moved, resample=Image.Resampling.BILINEAR
    )
    return np.asarray(picture)


def _room(edit: Edit, icon: Exemplar) -> Placement:
    """Return where the icon must lie so that all that is added has room on the canvas."""
    if not edit.add:
        return Placement()
    boxes = np.array([polygon.bounds for polygon in edit.add])
    left, top = boxes[:, :2].min(axis=0)
    right, bottom = boxes[:, 2:].max(axis=0)
    if min(right, bottom) <= 0 or max(left, top) >= CANVAS:
        raise IconstudioError(
            "What should be added lies beside the canvas. The icon lies between "
            f"{MARGIN} and {CANVAS - MARGIN}; draw near it."
        )
    if min(left, top) >= _CLEAR and max(right, bottom) <= CANVAS - _CLEAR:
        return Placement()
    ys, xs = np.nonzero(icon.ink)
    left, right = min(left, xs.min()), max(right, xs.max() + 1)
    top, bottom = min(top, ys.min()), max(bottom, ys.max() + 1)
    scale = (CANVAS - 2 * MARGIN) / max(right - left, bottom - top)
    half = CANVAS / 2
    return Placement(
        scale,
        False,
        round(scale * (half - (left + right) / 2)),
        round(scale * (half - (top + bottom) / 2)),
    )


def _union(polygons: Sequence[Polygon], placement: Placement, side: int) -> Bitmap:
    """Return what polygons enclose once they are moved with the icon, (side, side) bool."""
    move = placement.transform.transformPoint
    return filled_polygons([Polygon(tuple(map(move, one.vertices))) for one in polygons], side)
