"""Which names say that an icon shows something else than the keyword, or more.

Of *car*, ``car-garage`` is a garage, ``car-with-key`` a car and a key, ``car-plus`` a car and a
sign, and ``man-in-car`` a scene.
"""

from collections.abc import Iterable
from itertools import pairwise

from iconstudio.library.words.naming import take_apart
from iconstudio.library.words.vocabulary import (
    ATTRIBUTES,
    BADGES,
    CARRIERS,
    INTERFACE,
    NEGATIONS,
    PEOPLE,
    PREPOSITIONS,
)

_ARTICLES = frozenset({"a", "an", "the", "o"})
_SIGNS = (BADGES | NEGATIONS | CARRIERS) - ATTRIBUTES
_BEHIND = frozenset({"up", "down", "forward", "off"})
"""Behind a thing, these are arrows beside it, or a line across it."""
_IDIOMS = (("cross", "country"),)
"""Words that are no signs together."""
_TELLING = _SIGNS | PEOPLE


def shows_more(name: str, keyword: Iterable[str]) -> bool:
    """Whether an icon's name says that more is in it than a thing of the words of a keyword.

    It does if, beside the keyword, its style and size, it has a word for a sign, a frame or what
    else things are shown on; for a person; a preposition; or, behind a thing that is no mark of an
    interface, a direction or *off*. Words of other kinds tell nothing: a *police car* is a car.

    >>> [shows_more(name, ["car"]) for name in ("car-key-plus", "car-with-key", "laptop-car")]
    [True, True, True]
    >>> [shows_more(name, ["car"]) for name in ("car-24-filled", "sports-car", "car-side", "plus")]
    [False, False, False, False]
    """
    words = take_apart(name).words
    wanted = set(keyword)
    beside = [word for word in words if word not in wanted]
    if len(words) == 1 or (len(beside) == len(words) and _TELLING.issuperset(words)):
        return False
    inside = (PREPOSITIONS - _ARTICLES).intersection(words[:-1])  # a lamp on is just one
    idiom = {word for pair in pairwise(words) if pair in _IDIOMS for word in pair}
    if not _TELLING.isdisjoint(set(beside) - idiom) or inside - wanted:
        return True
    is_mark = not INTERFACE.isdisjoint(wanted)  # an arrow up is one arrow
    return not is_mark and bool(_BEHIND.intersection(words[1:]) - wanted)
