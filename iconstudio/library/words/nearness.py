"""Which words are spelt alike."""

from collections.abc import Sequence

_LIKE = 0.75
"""So much of a word's letters is in its place if it is only misspelt: another word is no hint."""

_LIKER = 0.85
"""The same if it begins with another letter, unless no more than one letter is wrong."""

_BEHIND = 0.1
"""Words that are less like it than the most like one, by more than this, are no hints either."""

_SHORT = 4
"""Letters of a short word."""

_SUFFIXES = (
    "ness", "ment", "tion", "sion", "ship", "hood", "less", "able", "ible", "ical", "ity", "ing",
    "ful", "ous",
)  # fmt: skip
"""Ends that so many words have that they say nothing: without it, both must be as much alike."""

_FEWEST = 3
"""Letters of a word that another may be like."""


def nearest(keyword: str, words: Sequence[str], count: int = 3) -> tuple[str, ...]:
    """Return the words that are spelt most nearly like ``keyword``, if it is long enough to tell.

    Letters that have changed places are one mistake.
    """
    from difflib import SequenceMatcher

    length, letters = len(keyword), sorted(keyword)
    if length < _FEWEST:
        return ()
    matcher = SequenceMatcher(b=keyword)
    one_wrong = 1 - 1 / length
    likely = [
        word
        for word in words
        if abs(len(word) - len(keyword)) <= 2
        and (word[:2] == keyword[:2] or word[-2:] == keyword[-2:] or word[:1] == keyword[1:2])
    ]
    alike: dict[str, float] = {}
    for word in likely:
        least = _LIKE if word[0] == keyword[0] else max(_LIKE, min(_LIKER, one_wrong))
        matcher.set_seq1(word)
        if sorted(word) == letters:
            alike[word] = one_wrong
        elif matcher.quick_ratio() >= least and (ratio := matcher.ratio()) >= least:
            alike[word] = ratio
    alike = {
        word: much
        for word, much in alike.items()
        if _are_alike_within(word, keyword)
        and (min(len(word), length) >= _SHORT or is_one_mistake(word, keyword))
    }
    best = max(alike.values(), default=0)
    close = [word for word in alike if alike[word] >= best - _BEHIND]
    close.sort(
        key=lambda word: (
            word[0] != keyword[0],
            sorted(word) != letters,
            not is_one_mistake(word, keyword),
            -alike[word],
        )
    )
    return tuple(close[:count])


def _are_alike_within(word: str, other: str) -> bool:
    """Whether what words have before a suffix is alike, if both have it."""
    from difflib import SequenceMatcher

    for suffix in _SUFFIXES:
        if word.endswith(suffix) and other.endswith(suffix):
            stem, wanted = word.removesuffix(suffix), other.removesuffix(suffix)
            return (
                is_one_mistake(stem, wanted) or SequenceMatcher(a=stem, b=wanted).ratio() >= _LIKE
            )
    return True


def is_surely(word: str, other: str) -> bool:
    """Whether one word is so like another that it may be read as that, and not only hint at it.

    Short words are too much alike, unless letters have changed places.
    """
    from difflib import SequenceMatcher

    return sorted(word) == sorted(other) or (
        len(word) > _SHORT
        and (is_one_mistake(word, other) or SequenceMatcher(a=word, b=other).ratio() >= _LIKER)
    )


def is_one_mistake(word: str, other: str) -> bool:
    """Whether one letter is too few, too many or wrong, or two neighbours changed places."""
    start = next(
        (i for i, (a, b) in enumerate(zip(word, other, strict=False)) if a != b),
        min(len(word), len(other)),
    )
    rest, wanted = word[start:], other[start:]
    return (
        rest[1:] == wanted
        or rest == wanted[1:]
        or rest[1:] == wanted[1:]
        or (rest[1::-1] == wanted[:2] and rest[2:] == wanted[2:])
    )
