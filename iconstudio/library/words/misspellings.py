"""Words that some names of icons misspell: few icons are called so, many by the right word."""

import re
from collections import Counter, defaultdict
from collections.abc import Iterator

from iconstudio.library.words.inflections import singulars, verb_forms
from iconstudio.library.words.nearness import is_one_mistake
from iconstudio.library.words.wordnet import WordNet

_RARE = 5
"""Most drawings of a word that is misspelt."""
_OFTENER = 10
"""The right word has at least so many times as many."""
_SHORTEST = 5
"""Letters of the shortest word that is known to be misspelt: shorter ones are too much alike."""
_LISTED = 7
"""The same, if WordNet lists it."""
_ENDINGS = ("d", "ed", "r", "er", "st", "est", "n", "y", "ly")
_BEGINNINGS = ("re", "un")
"""Of words that are made of others."""
_VOWELS = re.compile("[aeiouy]+")


def common_forms(wordnet: WordNet) -> frozenset[str]:
    """Return the forms of common verbs: *swimming* is in many names, but no noun of its own."""
    verbs = wordnet.verbs & wordnet.used
    return frozenset(form for verb in verbs for form in verb_forms(verb))


def misspellings(counts: Counter[str], wordnet: WordNet) -> dict[str, str]:
    """Return the misspelt ones of words, counted by their drawings, each with the right word.

    Both differ by one mistake: a letter too few, too many or wrong, or two that changed places. Of
    a word that WordNet lists, but nobody has been counted to use, one vowel is wrong: a *calender*
    smooths paper, but on icons it is a calendar.
    """
    known = _Known(wordnet)
    right = {word for word, count in counts.items() if count >= _OFTENER and known.has(word)}
    by_gap: defaultdict[str, set[str]] = defaultdict(set)
    for word in right:
        for gap in _gaps(word):
            by_gap[gap].add(word)
    found: dict[str, str] = {}
    for word, count in counts.items():
        if not (word.isalpha() and len(word) >= _SHORTEST and 0 < count <= _RARE):
            continue
        alike = {other for gap in _gaps(word) for other in by_gap.get(gap, ())} - {word}
        meant = [
            other
            for other in alike
            if counts[other] >= _OFTENER * count
            and word[0] == other[0]
            and is_one_mistake(word, other)
            and not known.tells_apart(word, other)
        ]
        if meant:
            found[word] = max(sorted(meant), key=counts.__getitem__)
    return found


class _Known:
    """Tells misspelt words from other words."""

    def __init__(self, wordnet: WordNet) -> None:
        self._wordnet = wordnet
        self._forms = common_forms(wordnet)

    def has(self, word: str) -> bool:
        """Whether a word is a right one."""
        return word in self._forms or self._wordnet.is_noun(self._wordnet.lemma(word))

    def tells_apart(self, word: str, other: str) -> bool:
        """Whether a word is one of its own, or another's plural or form."""
        wordnet = self._wordnet
        if word in wordnet.used or word in self._forms:
            return True
        bases = {*singulars(word), *(word.removesuffix(end) for end in _ENDINGS)} - {word}
        bases |= {word.removeprefix(start) for start in _BEGINNINGS} - {word}
        if other in bases or not bases.isdisjoint(wordnet.used | wordnet.senses.keys()):
            return True
        if word not in wordnet.listed:
            return False
        same_consonants = _VOWELS.sub("-", word) == _VOWELS.sub("-", other)
        return len(word) < _LISTED or len(word) != len(other) or not same_consonants


def _gaps(word: str) -> Iterator[str]:
    """Yield a word, and what is left of it without one letter: shared by all that is near."""
    yield word
    for i in range(len(word)):
        yield word[:i] + word[i + 1 :]
