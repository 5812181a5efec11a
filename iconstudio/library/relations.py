"""Which other words answer a keyword: the same thing, a kind of it, or what it is a kind of.

A relation's *rank* is added to the tier of a drawing (see ``readings``): the lower the better. A
plain miss is better than a far-fetched hit, so a word leads only through what it commonly means.
"""

from collections import Counter
from collections.abc import Iterable, Iterator

from iconstudio.library.decency import Decency
from iconstudio.library.vocabulary import TECHNICAL
from iconstudio.library.wordnet import PERSON, WordNet

SAME, NAMED, KIND, BROADER, BESIDE = 1, 2, 3, 7, 9
"""``NAMED`` are kinds that bear the word: a fingernail is nearer to a nail than a thumbtack is.
``BESIDE`` it are other kinds of the same: they do not answer, but may be proposed."""
_DEEP = 3
"""Kinds of kinds of kinds have a higher rank than kinds, by at most this."""
_FARTHER = 2
"""What is led to by another than the first meaning of a word has a rank higher by this."""

_MANY = 400
"""At most so many kinds of one thing, the commonest in the collection."""
_GENERAL = 150
"""A word with more kinds than this is too general to stand in for one of them."""
_SENSES = 3
"""At most so many meanings of a word count."""
_RARE = 8
"""A meaning is rare if another one is so many times as common."""
_DECISIVE = 3
"""One meaning comes before another in any case if it is so many times as common."""
_PROPOSED = 4
"""So many words are kept that lie beside a word that nothing answers."""

_USAGE = {
    "bike": "bicycle",
    "plane": "airplane",
    "chicken": "hen",
    "mouse": "rodent",
    "glass": "drinking glass",
    "lamb": "sheep",
    "turkey": "fowl",
    "apple": "fruit",
    "boot": "footwear",
    "crane": "lifting device",
    "tank": "vehicle",
}
"""What collections of icons mean by a word, where WordNet puts another meaning first."""


_SYNONYMS = (
    "home house", "bike bicycle", "motorbike motorcycle", "plane airplane aeroplane aircraft",
    "couch sofa settee", "puppy dog", "kitten cat", "bunny rabbit", "hare rabbit",
    "phone telephone", "tv television", "car automobile auto", "truck lorry", "hen chicken",
    "pc computer", "ship boat", "cup mug", "cow cattle", "pony horse", "lamp lantern",
    "flashlight torch", "glasses eyeglasses spectacles", "bulb lightbulb", "rocket spaceship",
    "present gift", "bag handbag", "purse handbag", "photo photograph", "film movie",
    "cactus cacti", "helicopter chopper", "ax axe", "donut doughnut", "airplane airliner",
    "sneaker trainer", "trashcan bin", "bin trash", "sailboat boat", "eggplant aubergine",
    "subway metro", "shop store", "mailbox postbox", "suitcase luggage", "gear cog cogwheel",
    "pitcher jug", "t_rex tyrannosaurus dinosaur",
)  # fmt: skip
"""Words that collections of icons use for the same drawing."""


class Relations:
    """The words of WordNet and of the collection that lead to terms of the collection.

    ``terms`` counts the drawings of each term of the collection.
    """

    def __init__(self, wordnet: WordNet, terms: Counter[str]) -> None:
        self._wordnet = wordnet
        self._decency = Decency(wordnet)
        self._terms = terms
        self._kinds_of: dict[int, dict[str, int]] = {}
        self._meanings: dict[str, tuple[int, ...]] = {}
        self._pairs: dict[str, set[str]] = {}
        for group in _SYNONYMS:
            words = [word.replace("_", " ") for word in group.split()]
            for word in words:
                self._pairs.setdefault(word, set()).update(set(words) - {word})

    def all(self) -> Iterator[tuple[str, str, int]]:
        """Yield (keyword, term, rank), keywords in order."""
        for word in sorted({*self._terms, *self._wordnet.senses, *self._pairs}):
            for term, rank in sorted(self.of(word).items()):
                yield word, term, rank

    def of(self, word: str) -> dict[str, int]:
        """Return the other terms of the collection that answer ``word``, each with its rank."""
        ranks: dict[str, int] = {}

        def add(term: str, rank: int) -> None:
            if term in self._terms and term != word:
                ranks[term] = min(rank, ranks.get(term, rank))

        for term in self._pairs.get(word, ()):
            add(term, SAME)
        meanings = self._meant(word)
        for number, key in enumerate(meanings):
            for term in self._wordnet.synsets[key].words:
                if self._stands_for(term, key):
                    add(term, min(SAME + number, NAMED))
            far = _FARTHER if number else 0
            for term, depth in self._kinds(key).items():
                named = term.endswith(word)
                deep = KIND + min(depth - 1, _DEEP) + far
                add(term, NAMED if named else min(deep, BROADER - 1))
        if len(meanings) == 1:
            for term in self._broader(meanings[0]):
                add(term, BROADER)
        if not ranks and word not in self._terms:
            for term in self._beside(word):
                add(term, BESIDE)
        return ranks

    def _meant(self, word: str) -> tuple[int, ...]:
        """Keys of what ``word`` commonly means and can be drawn, what icons mean first.

        A meaning counts that is not rare, or whose first word this is: *mug* is the first word for
        the vessel, and the last one for a fool.
        """
        known = self._meanings.get(word)
        if known is None:
            known = self._meanings[word] = self._common(word)
        return known

    def _common(self, word: str) -> tuple[int, ...]:
        wordnet = self._wordnet
        things = wordnet.things(word)
        counts = {key: wordnet.count(word, key) for key in wordnet.senses.get(word, ())}
        most = max(counts.values(), default=0)
        common = [
            key
            for key in things
            if len(counts) == 1
            or (counts[key] and counts[key] * _RARE >= most)
            or (wordnet.synsets[key].words[:1] == (word,) and wordnet.synsets[key].kind != PERSON)
            or self._is_usage(word, key)
        ]
        if not most:
            common = common or [key for key in things if wordnet.synsets[key].kind != PERSON][:1]
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
        meant = _USAGE.get(word)
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
        if self._wordnet.senses.get(word, ())[:1] == (key,):
            return True
        first = self._wordnet.synsets[key].words[:1] == (word,)
        return self._meant(word)[:1] == (key,) or (first and key in self._meant(word))

    def _surely(self, words: Iterable[str], key: int) -> list[str]:
        """Those of ``words`` that mean ``key``, and hardly ever anything else.

        A *charger* may be a horse, and a *cairn* a terrier; no collection of icons means that.
        """
        senses = self._wordnet.senses
        return [
            word
            for word in words
            if senses.get(word, ())[:1] == (key,)
            and (len(senses[word]) == 1 or self._wordnet.is_counted(word))
            and word not in TECHNICAL
        ]

    def _kinds(self, key: int) -> dict[str, int]:
        """Words of the collection for kinds of ``key``, each with its depth below it from 1.

        If there are many, the commonest.
        """
        if key in self._kinds_of:
            return self._kinds_of[key]
        found: dict[str, int] = {}
        level, depth, seen = [key], 0, {key}
        while level:
            depth += 1
            level = [
                child
                for parent in level
                for child in self._wordnet.children.get(parent, ())
                if child not in seen and not self._decency.is_private(child)
            ]
            seen.update(level)
            for child in level:
                words = (w for w in self._wordnet.synsets[child].words if w in self._terms)
                for word in self._surely(words, child):
                    found.setdefault(word, depth)
        commonest = sorted(found, key=lambda word: (-self._terms[word], word))[:_MANY]
        kinds = self._kinds_of[key] = {word: found[word] for word in commonest}
        return kinds

    def _broader(self, key: int) -> list[str]:
        return [
            word
            for parent in self._wordnet.synsets[key].parents
            if len(self._kinds(parent)) <= _GENERAL
            for word in self._wordnet.synsets[parent].words
            if self._wordnet.senses.get(word, ())[:1] == (parent,)
        ]

    def _beside(self, word: str) -> list[str]:
        """The commonest words for other kinds of what ``word`` is a kind of."""
        for key in self._meant(word)[:1]:
            for parent in self._wordnet.synsets[key].parents:
                kinds = self._kinds(parent)
                if 0 < len(kinds) <= _GENERAL and not self._decency.is_unspoken(word):
                    return list(kinds)[:_PROPOSED]
        return []
