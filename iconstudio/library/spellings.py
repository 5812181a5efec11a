"""How else a keyword may be spelt: joined or parted, as icons are called, or rightly."""

from collections.abc import Iterator
from itertools import chain, islice, product

from iconstudio.library.terms import Terms
from iconstudio.library.words import negation, query, symbols
from iconstudio.library.words.decency import is_rude, is_unkind
from iconstudio.library.words.inflections import verbs
from iconstudio.library.words.nearness import is_surely, nearest
from iconstudio.library.words.regional import other_spellings
from iconstudio.library.words.usage import INFORMAL
from iconstudio.library.words.vocabulary import FAMILIAR

_SHORT = 4
"""Of a keyword of so many words each, and each two together, are spelt as icons spell them."""

_MISSPELT = 4
"""Letters of the shortest word that is taken for another, misspelt."""

_MOST = 9
"""At most so many ways to spell a keyword rightly are tried."""

Words = tuple[str, ...]


class Spellings:
    """Spells keywords."""

    def __init__(self, terms: Terms) -> None:
        self._terms = terms

    def of(self, words: Words) -> list[Words]:
        """Return words as they are, and as icons have them, in one or parted.

        So a word with a hyphen finds what it finds joined and in several words.
        """
        found = [words, ("".join(words),)]
        if len(words) <= _SHORT:
            joined = [*query.joinings(words), *query.phrasal(words)]
            known = self._terms.leading(set(chain(*joined)).difference(words))
            found += (one for one in joined if not known.isdisjoint(one))
            found += self._otherwise(words)
            for place, word in enumerate(words):
                for parted in sorted(self._terms.leading(query.partings(word))):
                    found.append((*words[:place], *parted.split(), *words[place + 1 :]))
        return list(dict.fromkeys(found))

    def _otherwise(self, words: Words) -> Iterator[Words]:
        """Yield words as they are spelt elsewhere."""
        spelt = {word: list(other_spellings(word)) for word in words}
        known = self._terms.leading(other for others in spelt.values() for other in others)
        choices = ((word, *(one for one in spelt[word] if one in known)) for word in words)
        yield from islice(product(*choices), 1, _MOST)

    @staticmethod
    def same(words: Words) -> Iterator[Words]:
        """Yield what names of icons say for words that mean a thing switched off, or alone."""
        if len(words) <= _SHORT:
            yield from negation.drawn_as(words)

    def corrected(self, words: Words) -> list[dict[str, str]]:
        """Return what the misspelt ones of several words may stand for, the likeliest first."""
        meant = {word: self._meant(word) for word in words if self._is_misspelt(word)}
        meant = {word: right for word, right in meant.items() if right}
        if not meant:
            return []
        choices = islice(product(*meant.values()), _MOST)
        return [dict(zip(meant, choice, strict=True)) for choice in choices]

    def is_sure(self, word: str, right: str) -> bool:
        """Whether a misspelt word is so like a right one that no phrase need tell that it is it."""
        known = (*self._terms.spelling(word), *symbols.english(word))
        return right in known or is_surely(word, right)

    def _is_misspelt(self, word: str) -> bool:
        """Whether no icon has a word in its name, nor leads it to any, or few do by mistake."""
        if len(word) < _MISSPELT or not word.isalpha() or word in FAMILIAR or word in INFORMAL:
            return False
        if is_rude(word):
            return False
        if self._terms.spelling(word):
            return True
        terms = self._terms
        if terms.named(word) or terms.is_known(word) or terms.plainly(word):
            return False
        return not any(map(terms.named, verbs(word)))

    def _meant(self, word: str) -> tuple[str, ...]:
        right = (*self._terms.spelling(word), *symbols.english(word))
        near = nearest(word, self._terms.proposals())
        return right or tuple(one for one in near if not is_unkind(word, one))
