"""The results of a grid to look at first, once all are there.

Each row names its best result as soon as it is whole. Symmetric results and others come after that,
and two rows may name the same picture: at the end each row's best is asked for again.
"""

from collections import defaultdict
from collections.abc import Generator
from contextlib import closing

from iconstudio.algorithms.iconification.overhang import drawn_ink
from iconstudio.algorithms.iconification.ranking import Gallery
from iconstudio.algorithms.iconification.style import STYLES
from iconstudio.model import Remix
from iconstudio.workflows.events import Event, Recommended, Result
from iconstudio.workflows.recommending import best_of

NEARLY = 0.85
"""A picture that no other row names comes before one that is, from this part of its score on."""


def with_best(events: Generator[Event]) -> Generator[Event]:
    """Pass on the events of a grid; at its end name again the best result of rows that changed.

    Of two rows whose best results look the same, the darker one names its next best, if that is
    nearly as good. Closing the generator cancels what is left.
    """
    made: dict[str, dict[float, Remix]] = defaultdict(dict)
    named: dict[str, float | None] = {}
    with closing(events):
        for event in events:
            yield event
            match event:
                case Result(icon=Remix() as icon, preview=False):
                    made[icon.composite.style][icon.composite.lambda_s] = icon
                case Recommended(style, lambda_s):
                    named[style] = lambda_s
    seen: list[Remix] = []
    for style in (one.name for one in STYLES if one.name in named):
        best = _best(list(made[style].values()), seen)
        if best is not None:
            seen.append(best)
            if best.composite.lambda_s != named[style]:
                yield Recommended(style, best.composite.lambda_s)


def _best(row: list[Remix], seen: list[Remix]) -> Remix | None:
    first = best_of(row)
    if first is None:
        return None
    gallery = Gallery()
    for one in seen:
        gallery.add(drawn_ink(one.drawing))
    new = best_of([one for one in row if gallery.is_new(drawn_ink(one.drawing))])
    if new is None or new.score.total < NEARLY * first.score.total:
        return first
    return new
