"""What the words of a name mean: which things an icon may be found under, and how surely.

The *tier* of a term says how far the drawing is one **of** the thing: a dog is ``EXACT``,
a sitting dog ``POSED``, a police dog ``COMPOUND``, a dog with a plus sign ``BADGED``, a man
walking his dog a ``SCENE``; a dog bowl only ``MENTION``s it. The lower the better.
"""

from collections.abc import Iterator

from iconstudio.library.words.vocabulary import (
    ATTRIBUTES,
    BADGES,
    FIGURATIVE,
    INTERFACE,
    PARTS,
    PEOPLE,
    PREPOSITIONS,
)
from iconstudio.library.words.vocabulary import words as word_set
from iconstudio.library.words.wordnet import WordNet

EXACT, POSED, COMPOUND, PART, BADGED, SCENE, MENTION = 0, 1, 2, 2, 6, 7, 12

_WORDY = 6
"""A name of so many words is a list of keywords, led by a category and by the thing itself."""

_POSES = ATTRIBUTES - word_set("animal vehicle transport pet farm baby")
"""Words that name nothing, but say how a thing is."""


def readings(words: tuple[str, ...], wordnet: WordNet) -> dict[str, int]:
    """Return the terms that a name stands for, each with its tier."""
    found: dict[str, int] = {}

    def add(term: str, tier: int) -> None:
        found[term] = min(tier, found.get(term, tier))

    for word in words:
        if word not in PREPOSITIONS:
            add(wordnet.lemma(word), MENTION)
    if len(words) >= _WORDY:
        add(wordnet.lemma(words[1]), SCENE)
        return found
    if len(words) > 1 and words[-1] in PARTS:
        whole = " ".join(words)
    else:
        whole = wordnet.lemma(" ".join(words))
    add(whole, EXACT)
    if len(words) == 1 or wordnet.things(whole) or whole in FIGURATIVE:
        return found
    if len(words) == 2:
        turned = f"{words[1]} {words[0]}"
        if wordnet.things(turned):
            add(turned, EXACT)
            return found
    for term, tier in _heads(words, wordnet):
        add(term, tier)
    return found


def _heads(words: tuple[str, ...], wordnet: WordNet) -> Iterator[tuple[str, int]]:
    """Yield the things that several words name, which are no word of WordNet together."""
    tier = EXACT
    cut = next((i for i, word in enumerate(words) if i and word in PREPOSITIONS), len(words))
    if cut < len(words):
        tier = SCENE if words[cut] == "and" else COMPOUND
    core = words[:cut]
    if PEOPLE & set(core[:-1]):
        tier = SCENE
    core, badged = _strip(core, BADGES - ATTRIBUTES)
    core, posed = _strip(core, ATTRIBUTES)
    core, badged_inside = _strip(core, BADGES - ATTRIBUTES)
    if badged or badged_inside:
        tier = max(tier, BADGED)
    elif posed:
        tier = max(tier, POSED)
    if len(core) > 1 and core[-1] in PARTS:
        core, tier = core[:-1], max(tier, PART)
    yield from _compound(core, tier, wordnet)


def _strip(words: tuple[str, ...], extras: frozenset[str]) -> tuple[tuple[str, ...], bool]:
    """Return ``words`` without the ``extras`` at either end, and whether there were any.

    They are none if nothing but a pose or a view is left: *wifi low* is a wifi, no *low*.
    """
    left = words
    while len(left) > 1 and left[-1] in extras:
        left = left[:-1]
    while len(left) > 1 and left[0] in extras:
        left = left[1:]
    if left == words or (extras.isdisjoint(ATTRIBUTES) and _POSES.issuperset(left)):
        return words, False
    return left, True


def _compound(words: tuple[str, ...], tier: int, wordnet: WordNet) -> Iterator[tuple[str, int]]:
    if len(words) == 1:
        yield wordnet.lemma(words[0]), tier
        return
    for start in range(len(words) - 1):
        head = wordnet.lemma(" ".join(words[start:]))
        if wordnet.things(head):
            yield head, max(tier, COMPOUND if start else EXACT)
            return
    first, last = wordnet.lemma(words[0]), wordnet.lemma(words[-1])
    if len(words) == 2 and first != last and wordnet.is_kind_of(last, first):
        yield last, max(tier, POSED)
        yield first, max(tier, POSED)
    elif wordnet.things(last):
        nouns = any(wordnet.is_noun(wordnet.lemma(word)) for word in words[:-1])
        yield last, max(tier, COMPOUND if nouns else POSED)
    elif wordnet.things(first):
        yield first, max(tier, SCENE)


def is_thing(term: str, wordnet: WordNet) -> bool:
    """Whether a term can mean something with a shape, and is no mark of an interface."""
    return term not in INTERFACE and bool(wordnet.things(term))
