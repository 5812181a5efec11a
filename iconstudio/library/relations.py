"""Which other words answer a keyword: the same thing, a kind of it, or what it is a kind of.

A relation's *rank* is added to the tier of a drawing (see ``readings``): the lower the better.
"""

from collections import Counter
from collections.abc import Iterable, Iterator

from iconstudio.library.vocabulary import TECHNICAL
from iconstudio.library.wordnet import PERSON, WordNet

SAME, ALSO, KIND, BROADER = 0, 1, 3, 7

_MANY = 400
"""At most so many kinds of one thing, the commonest in the collection."""
_GENERAL = 150
"""A word with more kinds than this is too general to stand in for one of them."""

_USAGE = {
    "bike": "bicycle",
    "plane": "airplane",
    "chicken": "hen",
    "mouse": "rodent",
    "nail": "tack",
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
)  # fmt: skip
"""Words that collections of icons use for the same drawing."""


class Relations:
    """The words of WordNet and of the collection that lead to terms of the collection.

    ``terms`` counts the drawings of each term of the collection.
    """

    def __init__(self, wordnet: WordNet, terms: Counter[str]) -> None:
        self._wordnet = wordnet
        self._terms = terms
        self._kinds_of: dict[int, list[str]] = {}
        self._pairs: dict[str, set[str]] = {}
        for group in _SYNONYMS:
            words = group.split()
            for word in words:
                self._pairs.setdefault(word, set()).update(set(words) - {word})

    def all(self) -> Iterator[tuple[str, str, int]]:
        """Yield (keyword, term, rank), keywords in order."""
        for word in sorted({*self._terms, *self._wordnet.senses, *self._pairs}):
            for term, rank in sorted(self.of(word).items()):
                yield word, term, rank

    def of(self, word: str) -> dict[str, int]:
        """Return the terms of the collection that answer ``word``, each with its rank."""
        ranks: dict[str, int] = {}

        def add(terms: Iterable[str], rank: int) -> None:
            for term in terms:
                if term in self._terms:
                    ranks[term] = min(rank, ranks.get(term, rank))

        add([word], SAME)
        add(self._pairs.get(word, ()), ALSO)
        for number, key in enumerate(self._senses(word)[:3]):
            synset = self._wordnet.synsets[key]
            if number and synset.kind == PERSON:
                continue
            far = 2 if number else 0
            add(self._first(synset.words, key), SAME + far)
            add(self._kinds(key), KIND + far)
            if not number:
                add(self._broader(key), BROADER)
        return ranks

    def _senses(self, word: str) -> tuple[int, ...]:
        """Keys of the drawable meanings of ``word``, the one that icons mean first."""
        senses = self._wordnet.things(word)
        meant = _USAGE.get(word)
        if meant is None:
            return senses
        targets = set(self._wordnet.things(meant))
        return tuple(sorted(senses, key=lambda key: not self._descends(key, targets)))

    def _all_senses(self, word: str) -> tuple[int, ...]:
        """Keys of all meanings of ``word``, the one that icons mean first."""
        return self._senses(word) if word in _USAGE else self._wordnet.senses.get(word, ())

    def _descends(self, key: int, targets: set[int]) -> bool:
        return key in targets or any(
            self._descends(parent, targets) for parent in self._wordnet.synsets[key].parents
        )

    def _first(self, words: Iterable[str], key: int) -> list[str]:
        """Those of ``words`` that mean ``key`` before anything else."""
        return [word for word in words if self._all_senses(word)[:1] == (key,)]

    def _surely(self, words: Iterable[str], key: int) -> list[str]:
        """Those of ``words`` that mean ``key``, and hardly ever anything else.

        A *charger* may be a horse, and a *cairn* a terrier; no collection of icons means that.
        """
        return [
            word
            for word in self._first(words, key)
            if (word in self._wordnet.counted or len(self._wordnet.senses[word]) == 1)
            and word not in TECHNICAL
        ]

    def _kinds(self, key: int) -> list[str]:
        """Words of the collection for kinds of ``key``, the commonest first."""
        if key in self._kinds_of:
            return self._kinds_of[key]
        found: set[str] = set()
        stack, seen = list(self._wordnet.children.get(key, ())), {key}
        while stack:
            child = stack.pop()
            if child in seen:
                continue
            seen.add(child)
            stack += self._wordnet.children.get(child, ())
            words = (w for w in self._wordnet.synsets[child].words if w in self._terms)
            found.update(self._surely(words, child))
        kinds = sorted(found, key=lambda word: (-self._terms[word], word))[:_MANY]
        self._kinds_of[key] = kinds
        return kinds

    def _broader(self, key: int) -> list[str]:
        found: list[str] = []
        for parent in self._wordnet.synsets[key].parents:
            words = self._first(self._wordnet.synsets[parent].words, parent)
            if words and len(self._kinds(parent)) <= _GENERAL:
                found += words
        return found
