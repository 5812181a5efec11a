"""Which icons answer a keyword, and what is near: looked up in the unpacked collection."""

import re
from collections.abc import Iterable
from dataclasses import replace

from iconstudio.library.phrases import Answer, Phrases, at_least
from iconstudio.library.search import ITSELF
from iconstudio.library.terms import FEW, Rows, Scores, Terms
from iconstudio.library.words import negation, query, symbols
from iconstudio.library.words.decency import MEANT, is_insult, is_rude, is_unkind
from iconstudio.library.words.inflections import qualities
from iconstudio.library.words.naming import is_negated, take_apart
from iconstudio.library.words.nearness import nearest
from iconstudio.library.words.query import Style
from iconstudio.library.words.usage import BRANDS
from iconstudio.library.words.vocabulary import ATTRIBUTES, PREPOSITIONS

_FEWEST, _MORE = 8, 16
"""If fewer icons answer several words together, those words are named that so many answer."""
_MOST = 8
"""Of a keyword of more words, so many are looked up: what others cost grows much faster."""


class Lookup:
    """Looks keywords up. ``rows`` asks the database."""

    def __init__(self, rows: Rows) -> None:
        self._rows = rows
        self._terms = Terms(rows)
        self._phrases = Phrases(self._terms)

    def scores(self, keyword: str) -> Scores:
        """Return the icons that answer a keyword."""
        return self.answer(keyword).scores

    def answer(self, keyword: str) -> Answer:
        """Return the icons that answer a keyword, and how it was read."""
        words = tuple(query.plain(keyword).split())
        if not words:
            return Answer()
        if len(words) > _MOST:
            different = tuple(dict.fromkeys(words))
            answer = self._phrases.answer(different[:_MOST])
            cut = len(different) > _MOST
            return replace(answer, looked_up=_MOST) if cut else answer
        if symbols.has_symbols(keyword):
            return self._named_by(keyword.strip(), words)
        core = " ".join(query.without_style(words))
        if meant := next((MEANT[form] for form in query.forms(core) if form in MEANT), ""):
            return Answer(self.plainly(meant), read_as=((core, meant),))
        if (answer := self._phrases.answer(words)) or is_insult(" ".join(words)):
            return answer
        symbol = symbols.called(" ".join(words))
        return self._named_by(symbol, words) if symbol else answer

    def style(self, keyword: str) -> Style:
        """Return the style that a keyword asks for, unless the words together name a thing."""
        words = query.spelt_out(tuple(query.plain(keyword).split())[:_MOST])
        asked = query.style(words)
        return Style() if asked.words and self._phrases.names_thing(words) else asked

    def truly(self, answer: Answer) -> Answer:
        """Return an answer without those of the words left out that icons of it bear after all."""
        found = self.identifiers(answer.scores) if answer.left_out else {}
        borne = {part for one in found.values() for part in re.split("[:-]", one)}
        left_out = tuple(w for w in answer.left_out if w not in borne or is_negated((w,)))
        return replace(answer, left_out=left_out)

    def unheeded(self, keyword: str, answer: Answer) -> tuple[str, ...]:
        """Return words for a style that no name of a thing that answers has, nor can be seen."""
        style = self.style(keyword)
        asked = tuple(word for word in query.plain(keyword).split() if word in style.words)
        if answer.left_out or not (asked and style.others) or style.solid is not None:
            return ()
        things = (icon for icon, score in answer.scores.items() if score <= ITSELF)
        names = (one.partition(":")[2] for one in self.identifiers(things).values())
        of_it = any(style.distance(one) <= 1 and not style.adds(take_apart(one)) for one in names)
        return () if of_it else asked

    def foreign(self, keyword: str, answer: Answer) -> tuple[str, ...]:
        """Return in English what a keyword means elsewhere, if it was read as another word.

        Or if no icon that answers is the thing itself: in French, *lit* is a bed.
        """
        if not answer or (not answer.read_as and min(answer.scores.values()) <= ITSELF):
            return ()
        known = {query.plain(keyword), *(right for _, right in answer.read_as)}
        return tuple(one for one in symbols.english(keyword) if one not in known)

    def _named_by(self, keyword: str, words: tuple[str, ...]) -> Answer:
        """Return the icons that answer the names of a symbol, its own before all others."""
        found = self.plainly(" ".join(words))
        if symbols.is_flag(keyword):  # a country is no kind of anything
            return Answer(found)
        core = query.without_framing(words)
        if symbols.is_joined(keyword):
            core = query.without_people(core)
        called, core = core, query.spelt_out(core)
        names = dict.fromkeys((" ".join(called), " ".join(core), *symbols.other_names(keyword)))
        for name in names:
            found = self.plainly(name) | found
        if not found:
            found = self._phrases.whole(core) or self.plainly(query.headed(core))
        left_out: tuple[str, ...] = ()
        if len(found) < FEW and not PREPOSITIONS.intersection(core):
            last = at_least(1 + max(found.values(), default=-1), self._last(core))
            left_out = core[:-1] if last and not found else ()
            found = last | found
        return Answer(found, left_out) if found else self._phrases.answer(core)

    def _last(self, words: tuple[str, ...]) -> Scores:
        """Return the things of the last of several words, unless they together mean another.

        Or say that there are to be none: who forbids smoking means no pipe.
        """
        if is_negated(words) or words[-1] in ATTRIBUTES or self._terms.is_known(" ".join(words)):
            return {}
        if len(words) == 1:
            return {}
        found = self.plainly(words[-1])
        return found if self._terms.is_thing(words[-1]) else {}

    def plainly(self, words: str) -> Scores:
        """Return the icons that answer plain words taken together, in the plural or not."""
        return self._terms.plainly(words)

    def beside(self, keyword: str) -> tuple[str, ...]:
        """Return words for things of the same kind as one that nothing answers."""
        words = query.plain(keyword)
        return () if is_rude(words) or words in BRANDS else self._terms.beside(words)

    def suggestions(self, keyword: str) -> tuple[str, ...]:
        """Return words near to a keyword in spelling, unless that is no misspelling.

        First comes the quality that it is the noun of: of *sadness*, *sad*.
        """
        words = query.plain(keyword)
        if is_rude(words) or words in BRANDS:
            return ()
        near = nearest(words, self._terms.proposals())
        kind = (one for one in near if not is_unkind(keyword.strip(), one))
        return tuple(filter(self.scores, dict.fromkeys((*qualities(words), *kind))))

    def spelling(self, keyword: str) -> tuple[str, ...]:
        """Return the words that a keyword is a misspelling of, though few icons are called so."""
        return self._terms.spelling(query.plain(keyword))

    def called(self, keyword: str) -> dict[int, bool]:
        """Return the icons that are called just so in their sets, or else but for hyphens.

        And whether it is just so.
        """
        name = query.plain(keyword).replace(" ", "-")
        ask = "SELECT number, id FROM icon WHERE joined = ? ORDER BY id"
        found = {
            number: identifier.endswith(f":{name}")
            for number, identifier in self._rows(ask, (name.replace("-", ""),))
        }
        exactly = {number: True for number, so in found.items() if so}
        return exactly or found

    def identifiers(self, icons: Iterable[int]) -> dict[int, str]:
        """Return the identifiers of icons."""
        return self._terms.identifiers(icons)

    def parts(self, keyword: str) -> tuple[str, ...]:
        """Return the words of a keyword that icons answer on their own, spelt rightly."""
        words = tuple(dict.fromkeys(query.plain(keyword).split()))[:_MOST]
        right = dict(self.read_as(keyword))
        spelt = " ".join(right.get(word, word) for word in words).split()
        return self._phrases.parts(spelt) if len(words) > 1 else ()

    def wider(self, keyword: str, count: int) -> tuple[str, ...]:
        """Return two or more words of a keyword each of which far more than ``count`` answer."""
        if not 0 < count < _FEWEST:
            return ()
        words = tuple(dict.fromkeys(query.plain(keyword).split()))[:_MOST]
        told = filter(query.tells, negation.without(words))
        found = tuple(word for word in told if len(self.plainly(word)) >= _MORE)
        return found if len(found) > 1 else ()

    def read_as(self, keyword: str) -> tuple[tuple[str, str], ...]:
        """Return those of several words that are surely misspelt, each with the right one."""
        return self._phrases.read_as(tuple(query.plain(keyword).split())[:_MOST])
