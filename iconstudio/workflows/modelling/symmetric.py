"""Symmetric results of an outline that is nearly symmetric, where these are more plausible.

An addition to section 3.4: the recommended result of each row is cut again so that places that
mirror each other have one source (equation 9). This comes after all of the rows.
"""

from collections.abc import Callable, Generator
from contextlib import closing
from dataclasses import replace
from functools import partial

from iconstudio.model import Axis, Remix, Source
from iconstudio.workflows.events import Event, Progress, Recommended, Result
from iconstudio.workflows.remixing import Remixing
from iconstudio.workflows.solving import CutSeries, Posed

Pose = Callable[[tuple[Source, ...]], Posed]


def with_symmetric(
    events: Generator[Event], axis: Axis | None, pose: Pose, remixing: Remixing
) -> Generator[Event]:
    """Pass on the events of a grid, and then yield symmetric results that are more plausible.

    Each is a ``Result`` that takes the place of the recommended one of its row, and whose composite
    says that it was held to a symmetry. Closing the generator cancels what is left.

    Parameters
    ----------
    axis
        About which the outline is nearly symmetric, if about any.
    pose
        Makes of a style's sources the problem that is to be solved; must be picklable.
    remixing
        Solves the symmetric ones.
    """
    made: dict[tuple[str, float | None], Remix] = {}
    best: dict[str, Remix] = {}
    with closing(events):
        for event in events:
            yield event
            match event:
                case Result(icon=Remix() as icon, preview=False):
                    made[icon.composite.style, icon.composite.lambda_s] = icon
                case Recommended(style, lambda_s) if lambda_s is not None:
                    best[style] = made[style, lambda_s]
    if axis is None:
        return
    try:
        for icon in best.values():
            one = icon.composite
            posed = partial(pose_symmetric, pose, axis, one.sources)
            remixing.start(CutSeries(one.style, one.sources, posed, (one.lambda_s,), symmetry=axis))
        while remixing.busy:
            for event in remixing.ready(wanted=True):
                match event:
                    case Result(icon=Remix() as icon):
                        if _plausible(icon) > _plausible(best[icon.composite.style]):
                            yield event
                    case Progress():
                        yield Progress("symmetry", event.done, "Making symmetric ones")
    finally:
        remixing.cancel()


def pose_symmetric(pose: Pose, axis: Axis, sources: tuple[Source, ...]) -> Posed:
    """Pose a row's problem with a symmetry. What a labelling costs is the same."""
    posed = pose(sources)
    return replace(posed, problem=replace(posed.problem, symmetry=axis))


def _plausible(icon: Remix) -> float:
    """Return how plausible a result that shows what is inside is; if nothing judges, how good."""
    score = icon.score
    return score.total if score.plausible is None else score.plausible * score.inside
