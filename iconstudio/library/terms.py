"""Which icons a term has: looked up in the index of the unpacked collection.

Scores are a relation's rank and a reading's tier added up: the lower the better.
"""

import re
from collections.abc import Callable, Iterable, Sequence
from typing import Any

from iconstudio.library.words import query
from iconstudio.library.words.decency import is_insult
from iconstudio.library.words.inflections import is_irregular, singulars
from iconstudio.library.words.naming import take_apart
from iconstudio.library.words.readings import COMPOUND, EXACT, MENTION, POSED
from iconstudio.library.words.relations import BESIDE, BROADER, BROADEST, FORM, KIND, SAME, SPELLING
from iconstudio.library.words.usage import FEELINGS, OTHER_IN_PLURAL, UNDRAWN
from iconstudio.library.words.vocabulary import ATTRIBUTES

Rows = Callable[[str, Sequence[Any]], list[tuple[Any, ...]]]
"""Runs a query with values, and returns its rows."""

Scores = dict[int, int]
"""The number of an icon to its score."""

_CALLED = """
SELECT icon, 0 FROM wording JOIN naming USING (phrase) WHERE wording.joined = ?
"""
"""Icons whose name consists of the words."""

_READ = """
SELECT icon, MIN(tier) FROM reading JOIN naming USING (phrase) WHERE term = ? GROUP BY icon
"""
"""Icons that are one of a thing, or mention it."""

_RARELY_ALONE = 4
"""A word that names so many times more icons with other words than alone says something of these:
*auto* is a car, but *hdr-auto* is none."""

_RELATED = f"""
WITH used(term, alone, along) AS (
    SELECT term, SUM(tier = {EXACT}), SUM(tier BETWEEN {POSED} AND {COMPOUND})
    FROM reading JOIN naming USING (phrase)
    WHERE term = ?1 OR term IN (
        SELECT term FROM relation WHERE word = ?1 AND rank > {FORM} AND rank < {BROADER})
    GROUP BY term),
vague(term) AS (
    SELECT term FROM used
    WHERE along > {_RARELY_ALONE} * (alone + 2)
        AND alone < (SELECT alone FROM used WHERE term = ?1))
SELECT icon, MIN(relation.rank + reading.tier)
FROM relation JOIN reading USING (term) JOIN naming USING (phrase)
WHERE relation.word = ?1
    AND (reading.tier = {EXACT} OR term NOT IN vague)
    AND (relation.rank < {KIND} AND reading.tier < {MENTION}
        OR relation.rank < {BESIDE} AND reading.tier < {COMPOUND})
GROUP BY icon
"""
"""Icons of other words. The less a word has to do with the keyword, the more plainly must the
drawing be one of it: of a kind, and of what is broader, only the thing itself is wanted. So it is
of *vague* words, if the keyword itself has more drawings."""

NEVER = 99
"""A score that is worse than any."""
FEW = 8
"""A word with fewer icons that are just it has few."""
_PLURAL = 4
"""Letters of the shortest plural, such as *eyes*."""
_ALIAS = MENTION + 1
"""Of a word with few icons, those that only an alias calls so stand behind all others, as the set
that calls a picture of an account a *selfie* is alone; and those whose own name says more than the
word, as *wifi-tag* does, behind those that are just it."""


class Terms:
    """Looks terms up. ``rows`` asks the database."""

    def __init__(self, rows: Rows) -> None:
        self._rows = rows

    def plainly(self, words: str) -> Scores:
        """Return the icons that answer plain words taken together, in the plural or not."""
        called: Scores = {}
        found: Scores = {}
        singles = self._singles(words)
        for form in query.forms(words):
            if found and form not in singles:
                break
            called = dict.fromkeys(called, -1)  # called just so, in the plural: before all others
            called |= dict(self._rows(_CALLED, (query.joined(form),)))
            related = () if is_insult(form) else self._rows(_RELATED, (form,))
            answers = (*related, *self._rows(_READ, (form,)))
            for icon, tier in answers:
                found[icon] = min(tier, found.get(icon, NEVER))
            if answers and form in singles:
                break
        found |= called
        return self._own_names_first(words, found)

    def _own_names_first(self, words: str, found: Scores) -> Scores:
        """Return icons with those behind that only an alias calls so, if few are called so."""
        called = {icon for icon, score in found.items() if score <= EXACT}
        if not 0 < len(called) < FEW:
            return found
        forms = set(map(query.joined, query.forms(words)))
        things = [icon for icon, score in found.items() if score <= COMPOUND]
        names = {
            icon: take_apart(identifier.partition(":")[2]).words
            for icon, identifier in self.identifiers(things).items()
        }
        own = {icon for icon, name in names.items() if _holds(name, words.split(), forms)}
        more = {icon for icon in own if len(names[icon]) > len(words.split())}
        if not own - called and not called & own - more:
            return found
        behind = dict.fromkeys(called - own, _ALIAS) | dict.fromkeys(called & more, COMPOUND)
        return found | behind

    def numbered(self, found: Scores, word: str, bare: str) -> tuple[Scores, bool]:
        """Return icons with those of another number behind, and whether any has that of ``word``.

        Of *mp3*, whose ``bare`` word is *mp*, *mp-4* has another number. If any has the number, all
        others are behind.
        """
        number = str(int(word.removeprefix(bare).lstrip("x")))
        having = re.compile(rf"(?<![a-z]){bare}-?0*(\d+)(?!\d)")
        numbers = {
            icon: having.findall(identifier.partition(":")[2])
            for icon, identifier in self.identifiers(found).items()
        }
        has_it = any(number in own for own in numbers.values())
        behind = {
            icon: max(found[icon], MENTION + 1)
            for icon, own in numbers.items()
            if number not in own and (own or has_it)
        }
        return found | behind, has_it

    def _singles(self, words: str) -> list[str]:
        """Return what words are the plural of, and several of: glasses are no glass."""
        if len(words) < _PLURAL or words in OTHER_IN_PLURAL:
            return []
        return [one for one in singulars(words) if is_irregular(words) or self.is_drawn(one)]

    def named(self, word: str) -> set[int]:
        """Return the icons that have a word in their names, in any form."""
        return {icon for form in query.forms(word) for icon, _ in self._rows(_READ, (form,))}

    def is_thing(self, word: str) -> bool:
        """Whether an icon is just a thing of this word, in any form."""
        return any(map(self.is_drawn, query.forms(word)))

    def is_drawn(self, term: str) -> bool:
        """Whether an icon is just a thing of this term."""
        sql = f"SELECT 1 FROM reading WHERE term = ? AND tier = {EXACT} LIMIT 1"
        return bool(self._rows(sql, (term,)))

    def is_no_noun(self, word: str) -> bool:
        """Whether a word is a verb that names nothing to draw, or only says how a thing is."""
        sql = f"SELECT 1 FROM relation WHERE term = ? AND rank = {FORM} LIMIT 1"
        return word in ATTRIBUTES or any(self._rows(sql, (word,)))

    def is_activity(self, word: str) -> bool:
        """Whether a word says what somebody does: *running*."""
        sql = f"SELECT 1 FROM relation WHERE word = ? AND rank = {FORM} LIMIT 1"
        return word.endswith("ing") and (any(self._rows(sql, (word,))) or not self.is_thing(word))

    def is_known(self, words: str) -> bool:
        """Whether words together lead to others, or to icons that are just so."""
        sql = f"SELECT 1 FROM relation WHERE word = ? AND rank <> {SPELLING} LIMIT 1"
        return any(self._rows(sql, (form,)) for form in query.forms(words))

    def beside(self, words: str) -> tuple[str, ...]:
        """Return words for things of the same kind as one that nothing answers."""
        sql = f"SELECT term FROM relation WHERE word = ? AND rank = {BESIDE}"
        for form in query.forms(words):
            if found := self._rows(sql, (form,)):
                return tuple(row[0] for row in found)
        return ()

    def same(self, words: str) -> tuple[str, ...]:
        """Return other words for the thing of the words."""
        sql = f"SELECT term FROM relation WHERE word = ? AND rank = {SAME} ORDER BY term"
        return tuple(row[0] for form in query.forms(words) for row in self._rows(sql, (form,)))

    def broader(self, words: str) -> tuple[str, ...]:
        """Return what the thing of the words is a kind of, the nearest first."""
        sql = f"SELECT term FROM relation WHERE word = ? AND rank BETWEEN {BROADER} AND {BROADEST}"
        for form in query.forms(words):
            if found := self._rows(f"{sql} ORDER BY rank", (form,)):
                return tuple(row[0] for row in found)
        return ()

    def spelling(self, word: str) -> tuple[str, ...]:
        """Return the words that one that few icons are called by is a misspelling of."""
        sql = f"SELECT term FROM relation WHERE word = ? AND rank = {SPELLING}"
        return tuple(row[0] for row in self._rows(sql, (word,)))

    def proposals(self) -> list[str]:
        """Return the words that may be proposed to somebody who has misspelt one.

        What has a number in it names one of several drawings: *electricity2x*.
        """
        ask = "SELECT word FROM proposal WHERE word NOT GLOB '*[0-9]*'"
        named = (row[0] for row in self._rows(ask, ()))
        return list(dict.fromkeys((*named, *UNDRAWN, *FEELINGS)))

    def identifiers(self, icons: Iterable[int]) -> dict[int, str]:
        """Return the identifiers of icons."""
        listed = ",".join(map(str, icons))
        return dict(self._rows(f"SELECT number, id FROM icon WHERE number IN ({listed})", ()))

    def is_name(self, name: str) -> bool:
        """Whether an icon is called so: *heart-line* is one, *head-line* is none."""
        return bool(self._rows("SELECT 1 FROM icon WHERE id GLOB ? LIMIT 1", (f"*:{name}",)))

    def listed(self, terms: Iterable[str]) -> set[str]:
        """Return those of some terms that icons are read by."""
        return self._among(terms, "SELECT term FROM reading WHERE term IN ({0})")

    def leading(self, terms: Iterable[str]) -> set[str]:
        """Return those of some terms that icons are read by, or that lead to such."""
        read = "SELECT term FROM reading WHERE term IN ({0})"
        other = f"SELECT word FROM relation WHERE word IN ({{0}}) AND rank <> {SPELLING}"
        wanted = list(terms)
        return self._among(wanted, read) | self._among(wanted, other)

    def _among(self, terms: Iterable[str], sql: str) -> set[str]:
        wanted = list(dict.fromkeys(terms))
        marks = ",".join("?" * len(wanted))
        return {row[0] for row in self._rows(sql.format(marks), wanted)}


def _holds(name: Sequence[str], words: Sequence[str], forms: set[str]) -> bool:
    """Whether a name has words in it, in any order, or in one of their forms."""
    joined = "".join(name)
    return set(words) <= set(name) or any(form in joined for form in forms)
