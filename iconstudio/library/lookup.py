"""Which icons answer a keyword: looked up in the index of the unpacked collection.

Scores are a relation's rank and a reading's tier added up: the lower the better.
"""

from collections.abc import Iterable, Sequence

from iconstudio.library.spellings import Rows, Spellings
from iconstudio.library.words import query, symbols
from iconstudio.library.words.decency import is_insult
from iconstudio.library.words.inflections import is_irregular, singulars
from iconstudio.library.words.naming import take_apart
from iconstudio.library.words.query import Style
from iconstudio.library.words.readings import COMPOUND, EXACT, MENTION, POSED
from iconstudio.library.words.relations import BESIDE, BROADER, FORM, KIND
from iconstudio.library.words.usage import OTHER_IN_PLURAL
from iconstudio.library.words.vocabulary import ATTRIBUTES, PREPOSITIONS, STYLES

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

Scores = dict[int, int]
"""The number of an icon to its score."""
_NEVER = 99
_PLURAL = 4
"""Letters of the shortest plural, such as *eyes*."""
_FEW = 8
"""Of a keyword of many words, so many are looked up on their own.

With fewer icons of its whole name, a symbol is also what the last word of it says."""


class Lookup:
    """Looks keywords up. ``rows`` asks the database."""

    def __init__(self, rows: Rows) -> None:
        self._rows = rows
        self._spellings = Spellings(rows)

    def scores(self, keyword: str) -> Scores:
        """Return the icons that answer a keyword."""
        words = tuple(query.plain(keyword).split())
        if not words:
            return {}
        if symbols.has_symbols(keyword):
            return self._named_by(keyword.strip(), words)
        return self._answers(words)

    def style(self, keyword: str) -> Style:
        """Return the style that a keyword asks for, unless the words together name a thing."""
        words = tuple(query.plain(keyword).split())
        asked = query.style(words)
        return Style() if asked.words and self.plainly(" ".join(words)) else asked

    def _named_by(self, keyword: str, words: tuple[str, ...]) -> Scores:
        """Return the icons that answer the names of a symbol, its own before all others."""
        found = self.plainly(" ".join(words))
        if symbols.is_flag(keyword):  # a country is no kind of anything
            return found
        core = query.without_framing(words)
        for name in (" ".join(core), *symbols.other_names(keyword)):
            found = self.plainly(name) | found
        if len(found) < _FEW and not PREPOSITIONS.intersection(core):
            found = self._last(core) | found
        return found or self._answers(core)

    def _last(self, words: tuple[str, ...]) -> Scores:
        """Return the things of the last of several words, unless they together mean another."""
        if len(words) == 1 or words[-1] in ATTRIBUTES or self._is_known(" ".join(words)):
            return {}
        found = self.plainly(words[-1])
        return found if self._is_thing(words[-1]) else {}

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
                found[icon] = min(tier, found.get(icon, _NEVER))
            if answers and form in singles:
                break
        return found | called

    def _singles(self, words: str) -> list[str]:
        """Return what words are the plural of, and several of: glasses are no glass."""
        if len(words) < _PLURAL or words in OTHER_IN_PLURAL:
            return []
        return [one for one in singulars(words) if is_irregular(words) or self._is_drawn(one)]

    def beside(self, keyword: str) -> tuple[str, ...]:
        """Return words for things of the same kind as one that nothing answers."""
        sql = f"SELECT term FROM relation WHERE word = ? AND rank = {BESIDE}"
        for form in query.forms(query.plain(keyword)):
            if found := self._rows(sql, (form,)):
                return tuple(row[0] for row in found)
        return ()

    def proposals(self) -> list[str]:
        """Return the words that may be proposed to somebody who has misspelt one."""
        return [row[0] for row in self._rows("SELECT word FROM proposal", ())]

    def _answers(self, words: tuple[str, ...]) -> Scores:
        """Return the icons that answer plain words, however they are spelt, or what is near.

        What is called as it is typed comes first, and what informal words stand for last.
        """
        formal = query.spelt_out(words)
        _, *others = self._spellings.of(words)
        meant = self._spellings.of(formal) if formal != words else []
        found = _merged(
            (
                self._together(words),
                *(_at_least(0, self._together(one)) for one in others),
                *(_at_least(1, self._together(one)) for one in meant),
            )
        )
        return found or next(filter(None, map(self._near, (words, *others, *meant))), {})

    def _together(self, words: tuple[str, ...]) -> Scores:
        """Return the icons that answer words together, or have all that tell in their names."""
        found = self.plainly(" ".join(words))
        told = query.telling(words)
        if len(told) == 1 or (not found and query.without_style(words) != words):
            return found
        return _merged((found, self._all_of(told)))

    def _near(self, words: tuple[str, ...]) -> Scores:
        """Return the icons of the words that tell most of those which together find nothing."""
        for fewer in (query.without_style(words), query.telling(words)):
            if fewer != words:
                return self._answers(fewer)
        if len(words) == 1:
            return self._parted(words[0])
        return self._head(words) or self._without_attribute(words)

    def _without_attribute(self, words: tuple[str, ...]) -> Scores:
        """Return the things of the words before one for a view, say: a swing set is swings."""
        if words[-1] in ATTRIBUTES and not self._is_known(" ".join(words)):
            return self._answers(words[:-1])
        return {}

    def parts(self, keyword: str) -> tuple[str, ...]:
        """Return the words of a keyword that icons answer on their own."""
        words = list(dict.fromkeys(query.plain(keyword).split()))[:_FEW]
        return tuple(word for word in words if len(words) > 1 and self.plainly(word))

    def _all_of(self, words: Sequence[str]) -> Scores:
        """Return the icons that answer the last word, and have all others in their names."""
        named = [self._named(word) for word in words[:-1]]
        last = self.plainly(words[-1]) if all(named) else {}
        return {icon: last[icon] for icon in set(last).intersection(*named)}

    def _named(self, word: str) -> set[int]:
        return {icon for form in query.forms(word) for icon, _ in self._rows(_READ, (form,))}

    def _head(self, words: tuple[str, ...]) -> Scores:
        """Return the things of the last words: nothing is an old red house, so show houses.

        Not where the words together mean something of their own, nor where another word is a thing
        as well: a sea lion is no lion, and a swing set no set.
        """
        if self._is_known(" ".join(words)):
            return {}
        for start in range(1, len(words)):
            if words[start - 1] not in ATTRIBUTES and self._is_thing(words[start - 1]):
                return {}
            if start == len(words) - 1 and self._is_no_noun(words[start]):
                return {}
            found = self.plainly(" ".join(words[start:]))
            if found and min(found.values()) < COMPOUND:
                return found
        return {}

    def _is_thing(self, word: str) -> bool:
        return any(map(self._is_drawn, query.forms(word)))

    def _is_drawn(self, term: str) -> bool:
        """Whether an icon is just a thing of this term."""
        sql = f"SELECT 1 FROM reading WHERE term = ? AND tier = {EXACT} LIMIT 1"
        return bool(self._rows(sql, (term,)))

    def _is_no_noun(self, word: str) -> bool:
        """Whether a word is a verb that names nothing to draw, or only says how a thing is."""
        sql = f"SELECT 1 FROM relation WHERE term = ? AND rank = {FORM} LIMIT 1"
        return word in ATTRIBUTES or any(self._rows(sql, (word,)))

    def _is_known(self, words: str) -> bool:
        sql = "SELECT 1 FROM relation WHERE word = ? LIMIT 1"
        return any(self._rows(sql, (form,)) for form in query.forms(words))

    def _parted(self, word: str) -> Scores:
        """Return the icons whose names have both words that ``word`` is joined from.

        Or those of the one, if the other only says how they are drawn.
        """
        pairs = list(query.halves(word))
        for first, second in pairs:
            name = f"{first}-{second}"
            if {first, second} & STYLES and self._is_name(name):
                return self.plainly(" ".join(take_apart(name).words))
        known = set(self._listed(part for pair in pairs for part in pair if len(part) > 2))
        for first, second in pairs:
            if {first, second} <= known and (found := self._all_of((first, second))):
                return found
        return {}

    def _is_name(self, name: str) -> bool:
        """Whether an icon is called so: *heart-line* is one, *head-line* is none."""
        return bool(self._rows("SELECT 1 FROM icon WHERE id GLOB ? LIMIT 1", (f"*:{name}",)))

    def _listed(self, terms: Iterable[str]) -> list[str]:
        wanted = list(terms)
        marks = ",".join("?" * len(wanted))
        sql = f"SELECT DISTINCT term FROM reading WHERE term IN ({marks})"
        return [row[0] for row in self._rows(sql, wanted)]


def _at_least(least: int, scores: Scores) -> Scores:
    return {icon: max(score, least) for icon, score in scores.items()}


def _merged(parts: Iterable[Scores]) -> Scores:
    """Return the icons of all, each with its best score."""
    merged: Scores = {}
    for part in parts:
        for icon, score in part.items():
            merged[icon] = min(score, merged.get(icon, _NEVER))
    return merged
