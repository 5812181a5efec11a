"""Which other words answer a keyword: the same thing, a kind of it, or what it is a kind of.

A relation's *rank* is added to the tier of a drawing (see ``readings``): the lower the better. A
plain miss is better than a far-fetched hit, so a word leads only through what it commonly means.
"""

from collections import Counter
from collections.abc import Iterator

from iconstudio.library.decency import Decency
from iconstudio.library.vocabulary import PARTS, TECHNICAL
from iconstudio.library.wordnet import PERSON, WordNet

SAME, NAMED, KIND, BROADER, BESIDE = 1, 2, 3, 7, 9
"""``NAMED`` are kinds that bear the word: a fingernail is nearer to a nail than a thumbtack is.
``BESIDE`` it are other kinds of the same: they do not answer, but may be proposed."""
_FARTHER = 2
"""What is led to by another than the first meaning of a word has a rank higher by this."""

_MANY = 400
"""At most so many kinds of one thing, the commonest in the collection."""
_GENERAL = 64
"""A word with more kinds than this is too general to stand in for one of them."""
_SENSES = 3
"""At most so many meanings of a word count."""
_RARE = 2
"""A person is meant only if nothing else is so many times as common."""
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
    "pitcher jug", "tap faucet", "t_rex tyrannosaurus dinosaur",
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
        self._kinds_of: dict[int, list[str]] = {}
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
            for term in self._kinds(key):
                add(term, NAMED if term.endswith(word) else KIND + far)
        for term in self._broader(word):
            add(term, BROADER)
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
        if word not in _USAGE and self._wordnet.senses.get(word, ())[:1] == (key,):
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
        wordnet = self._wordnet
        found: list[str] = []
        head = word.rpartition(" ")[2]
        if head != word and wordnet.is_kind_of(word, head):
            found.append(head)
        meanings = self._meant(word)
        often = [wordnet.count(word, key) for key in meanings]
        if len(often) == 1 or (often and often[0] > often[1]):
            for parent in wordnet.synsets[meanings[0]].parents:
                if len(self._kinds(parent)) <= _GENERAL and not self._decency.is_private(parent):
                    words = wordnet.synsets[parent].words
                    found += (
                        term
                        for term in words
                        if wordnet.senses.get(term, ())[:1] == (parent,) and term not in TECHNICAL
                    )
        return found

    def _beside(self, word: str) -> list[str]:
        """Words for what ``word`` is a kind of, and the commonest for other kinds of it."""
        if self._decency.is_unspoken(word):
            return []
        for key in self._meant(word):
            for parent in self._wordnet.synsets[key].parents:
                if len(self._kinds(parent)) > _GENERAL:
                    continue
                words = self._wordnet.synsets[parent].words
                whole = [term for term in words if self._stands_for(term, parent)]
                siblings = self._wordnet.children[parent]
                near = {term for sibling in siblings for term in self._surely(sibling)}
                by_number = sorted(near, key=lambda term: (-self._terms[term], term))
                found = [term for term in (*whole, *by_number) if term in self._terms]
                if found:
                    return list(dict.fromkeys(found))[:_PROPOSED]
        return []
