"""Which other words answer a keyword: the same thing, a kind of it, or what it is a kind of.

A relation's *rank* is added to the tier of a drawing (see ``readings``): the lower the better. A
plain miss is better than a far-fetched hit, so a word leads only through what it commonly means.
"""

from collections import Counter
from collections.abc import Iterator, Sequence, Set

from iconstudio.library.words.decency import Decency
from iconstudio.library.words.inflections import verb_forms
from iconstudio.library.words.usage import STAND_INS, SYNONYMS, USAGE
from iconstudio.library.words.vocabulary import FALSE_FRIENDS, PARTS, TECHNICAL
from iconstudio.library.words.wordnet import (
    ACT,
    ANIMAL,
    ARTIFACT,
    COMMUNICATION,
    FOOD,
    PERSON,
    PLANT,
    THINGS,
    TOPS,
    WordNet,
)

FORM, SAME, NAMED, KIND, BROADER, BROADEST, BESIDE, SPELLING = 0, 1, 2, 3, 7, 8, 9, 10
"""``FORM``: the word is an inflected form of a verb. ``NAMED`` are kinds that bear the word: a
fingernail is nearer to a nail than a thumbtack is. ``BROADEST`` is the nearest of all that it is a
kind of that has drawings: a reptile for a crocodile, if nothing is nearer.
``BESIDE`` it are other kinds of the same: they do not answer, but may be proposed. So may what it
is a misspelling of: its right ``SPELLING``."""
_FARTHER = 2
"""What is led to by another than the first meaning of a word has a rank higher by this."""

_MANY = 400
"""At most so many kinds of one thing, the commonest in the collection."""
_GENERAL = 64
"""A word with more kinds than this is too general to stand in for one of them."""
_BASIC = 40
"""The same, for what is not next above the word: birds, fish, trees, but no animals, no plants."""
_GROWN = (ANIMAL, FOOD, PLANT)
"""What is alive or eaten: of these, kinds look alike."""
_SENSES = 3
"""At most so many meanings of a word count."""
_RARE = 2
"""A person is meant only if nothing else is so many times as common."""
_COMMON = 2
"""A meaning that is counted less often is not surely what a word commonly means."""
_DECISIVE = 3
"""One meaning comes before another in any case if it is so many times as common."""
_PROPOSED, _SHOWN = 4, 3
"""So many words are kept that lie beside a word that nothing answers; each has so many drawings."""


class Relations:
    """The words of WordNet and of the collection that lead to terms of the collection.

    ``terms`` counts the drawings of each term of the collection.
    """

    def __init__(self, wordnet: WordNet, terms: Counter[str]) -> None:
        self._wordnet = wordnet
        self._decency = Decency(wordnet)
        self._terms = terms
        self._kinds_of: dict[int, list[str]] = {}
        self._meanings: dict[str, tuple[int, ...]] = {}
        self._pairs: dict[str, set[str]] = {}
        for group in SYNONYMS:
            words = [word.replace("_", " ") for word in group.split()]
            for word in words:
                self._pairs.setdefault(word, set()).update(set(words) - {word})

    def all(self) -> Iterator[tuple[str, str, int]]:
        """Yield (keyword, term, rank), keywords in order."""
        forms = self._forms()
        for word in sorted({*self._terms, *self._wordnet.senses, *self._pairs, *STAND_INS, *forms}):
            ranks = self.of(word) | dict.fromkeys(forms.get(word, ()), FORM)
            for term, rank in sorted(ranks.items()):
                yield word, term, rank

    def _forms(self) -> dict[str, list[str]]:
        """Return the inflected forms of the verbs of the collection, each with its verbs.

        Only of verbs that name nothing that can be drawn: fishing is no fish. And a wedding is no
        form of *to wed*: a noun counts as a form if it is an act, as writing and dancing are.
        """
        wordnet = self._wordnet
        forms: dict[str, list[str]] = {}
        for verb in sorted(wordnet.verbs.intersection(self._terms)):
            if self._meant(verb):
                continue
            for form in verb_forms(verb):
                meant = wordnet.senses.get(form, ())[:1]
                if all(wordnet.synsets[key].kind in (ACT, COMMUNICATION) for key in meant):
                    forms.setdefault(form, []).append(verb)
        return forms

    def of(self, word: str) -> dict[str, int]:
        """Return the other terms of the collection that answer ``word``, each with its rank."""
        ranks: dict[str, int] = {}

        def add(term: str, rank: int) -> None:
            if term in self._terms and term != word and term not in FALSE_FRIENDS:
                ranks[term] = min(rank, ranks.get(term, rank))

        for term in self._pairs.get(word, ()):
            add(term, SAME)
        meanings = self._meant(word)
        for number, key in enumerate(meanings):
            for term in self._wordnet.synsets[key].words:
                if self._stands_for(term, key):
                    add(term, min(SAME + number, NAMED))
            far = _FARTHER if number else 0
            for term in self._kinds(key):
                add(term, NAMED if term.endswith(word) else KIND + far)
        for term in (*self._broader(word), *STAND_INS.get(word, ())):
            add(term, BROADER)
        if not ranks and word not in self._terms:
            for term in self._broadest(word):
                add(term, BROADEST)
        if not ranks and word not in self._terms:
            for term in self._beside(word):
                add(term, BESIDE)
        return ranks

    def _meant(self, word: str) -> tuple[int, ...]:
        """Keys of what ``word`` commonly means and can be drawn, what icons mean first.

        The commonest meaning counts, and those whose first word this is: *mug* is the first word
        for the vessel, and the last one for a fool.
        """
        known = self._meanings.get(word)
        if known is None:
            known = self._meanings[word] = self._common(word)
        return known

    def _common(self, word: str) -> tuple[int, ...]:
        wordnet = self._wordnet
        senses = wordnet.senses.get(word, ())
        counts = {key: wordnet.count(word, key) for key in senses}
        most = max(counts.values(), default=0)

        def is_first_word(key: int) -> bool:
            return wordnet.synsets[key].words[:1] == (word,)

        common = [
            key
            for key in wordnet.things(word)
            if len(senses) == 1
            or (counts[key] and counts[key] == most)
            or (wordnet.synsets[key].kind == PERSON and counts[key] * _RARE > most)
            or (wordnet.synsets[key].kind != PERSON and is_first_word(key))
            or self._is_usage(word, key)
        ]
        order = {key: place for place, key in enumerate(common)}
        common.sort(
            key=lambda key: (
                not self._is_usage(word, key),
                counts[key] * _DECISIVE < most,
                wordnet.synsets[key].kind == PERSON,
                -self._drawings(key),
                order[key],
            )
        )
        return tuple(common[:_SENSES])

    def _is_usage(self, word: str, key: int) -> bool:
        meant = USAGE.get(word)
        return meant is not None and self._descends(key, set(self._wordnet.things(meant)))

    def _descends(self, key: int, targets: set[int]) -> bool:
        return key in targets or any(
            self._descends(parent, targets) for parent in self._wordnet.synsets[key].parents
        )

    def _drawings(self, key: int) -> int:
        """How many drawings of kinds of ``key`` the collection has."""
        return sum(self._terms[word] for word in self._kinds(key))

    def _stands_for(self, word: str, key: int) -> bool:
        """Whether ``word`` means ``key`` before anything else, or is the first word for it."""
        if self._decency.is_private(key):
            return False
        if word not in USAGE and self._wordnet.senses.get(word, ())[:1] == (key,):
            return True
        first = self._wordnet.synsets[key].words[:1] == (word,)
        return self._meant(word)[:1] == (key,) or (first and key in self._meant(word))

    def _surely(self, key: int) -> list[str]:
        """Words of the collection that mean ``key``, and hardly ever anything else.

        A *charger* may be a horse, and a *cairn* a terrier; no collection of icons means that.
        """
        senses = self._wordnet.senses
        return [
            word
            for word in self._wordnet.synsets[key].words
            if word in self._terms
            and senses.get(word, ())[:1] == (key,)
            and (len(senses[word]) == 1 or self._wordnet.is_counted(word))
            and word not in TECHNICAL
            and not (" " in word and word.split()[-1] in PARTS)  # a horse head is no fish
        ]

    def _kinds(self, key: int) -> list[str]:
        """Words of the collection for kinds of ``key``, the commonest first."""
        if key in self._kinds_of:
            return self._kinds_of[key]
        found: set[str] = set()
        stack, seen = list(self._wordnet.children.get(key, ())), {key}
        while stack:
            child = stack.pop()
            if child in seen or self._decency.is_private(child):
                continue
            seen.add(child)
            stack += self._wordnet.children.get(child, ())
            found.update(self._surely(child))
        kinds = sorted(found, key=lambda word: (-self._terms[word], word))[:_MANY]
        self._kinds_of[key] = kinds
        return kinds

    def _broader(self, word: str) -> list[str]:
        """Words for what ``word`` is a kind of: those that mean it first, if ``word`` is clear."""
        found: list[str] = []
        head = word.rpartition(" ")[2]
        if head != word and self._wordnet.is_kind_of(word, head):
            found.append(head)
        if self._is_clear(word):
            for parent in self._wordnet.synsets[self._meant(word)[0]].parents:
                found += self._general(parent)
        return found

    def _is_clear(self, word: str) -> bool:
        """Whether ``word`` commonly means one thing, or one more often than another."""
        meant = self._meant(word)
        if any(self._is_usage(word, key) for key in meant[:1]):
            return True
        often = [self._wordnet.count(word, key) for key in meant]
        return len(often) == 1 or (len(often) > 1 and often[0] >= max(_COMMON, often[1] + 1))

    def _general(self, key: int, most: int = _GENERAL) -> list[str]:
        """Words that mean ``key`` first, if it is not too general to stand in for its kinds."""
        if len(self._kinds(key)) > most or self._decency.is_private(key):
            return []
        return [
            term
            for term in self._wordnet.synsets[key].words
            if self._wordnet.senses.get(term, ())[:1] == (key,) and term not in TECHNICAL
        ]

    def _broadest(self, word: str) -> list[str]:
        """Words for the nearest thing with drawings that a living being, or a food, is a kind of.

        A word that may mean an artifact, too, leads nowhere: a nutcracker is a bird, but not often.
        """
        wordnet = self._wordnet
        if any(wordnet.synsets[key].kind == ARTIFACT for key in wordnet.senses.get(word, ())):
            return []
        for kind in _GROWN:
            keys = [key for key in self._meant(word) if wordnet.synsets[key].kind == kind]
            for ancestor in self._above(keys, {kind}):
                words = self._terms.keys() & set(wordnet.synsets[ancestor].words)
                if words & TECHNICAL:
                    return []
                if found := [word for word in self._general(ancestor, _BASIC) if word in words]:
                    return found
        return []

    def _beside(self, word: str) -> list[str]:
        """Words for what ``word`` is a kind of, and the commonest for other kinds of it."""
        if self._decency.is_unspoken(word):
            return []
        meanings = self._meant(word) or self._wordnet.things(word)[:1]
        if meanings[:1] == self._wordnet.senses.get(word, ())[:1] or self._meant(word):
            for key in self._above(meanings, THINGS - {TOPS}):
                found = self._around(key)
                if len(found) > 1 or self._stands_for("".join(found), key):
                    return found[:_PROPOSED]
        return []

    def _above(self, keys: Sequence[int], kinds: Set[int]) -> Iterator[int]:
        """Yield all of ``kinds`` that ``keys`` are kinds of, the nearest first."""
        while keys:
            keys = [
                parent
                for key in keys
                for parent in self._wordnet.synsets[key].parents
                if self._wordnet.synsets[parent].kind in kinds
            ]
            yield from keys

    def _around(self, key: int) -> list[str]:
        """Words of the collection that mean ``key``, and the commonest kinds next below it."""
        if self._decency.is_private(key):
            return []
        words = self._wordnet.synsets[key].words
        whole = [term for term in words if self._stands_for(term, key)]
        kind = self._wordnet.synsets[key].kind
        near: set[str] = set()
        if len(self._kinds(key)) <= _GENERAL and kind != PERSON:  # a janitor is like no fireman
            for child in self._wordnet.children[key]:
                if not self._decency.is_private(child):
                    near.update(self._surely(child))
        elif kind == ARTIFACT:
            return []  # a device, say
        by_number = sorted(near.difference(whole), key=lambda term: (-self._terms[term], term))
        return [term for term in (*whole, *by_number) if self._terms[term] >= _SHOWN]
