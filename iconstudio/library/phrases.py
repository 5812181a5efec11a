"""Which icons answer several words: all of them if any do, else those of the words that tell most.

Nothing is left out, or read otherwise, without being told of.
"""

from collections.abc import Iterable, Mapping, Sequence, Set
from dataclasses import dataclass, field, replace

from iconstudio.library.spellings import Spellings, Words
from iconstudio.library.terms import NEVER, Scores, Terms
from iconstudio.library.words import negation, query
from iconstudio.library.words.decency import is_insult
from iconstudio.library.words.naming import is_negated, take_apart, without_number
from iconstudio.library.words.readings import COMPOUND
from iconstudio.library.words.relations import BROADER
from iconstudio.library.words.vocabulary import ATTRIBUTES, PEOPLE, PREPOSITIONS, STYLES

_LONGEST = 3
"""At most so many words are told of as one that icons answer on its own."""

_JOINED = 48
"""Most letters of a word that is taken for two."""


@dataclass(frozen=True, slots=True)
class Answer:
    """The icons that answer words, and how these were read."""

    scores: Scores = field(default_factory=dict)
    left_out: Words = ()
    """Words that the icons were found without."""
    read_as: tuple[tuple[str, str], ...] = ()
    """Words that are misspelt, each with the one it was taken for."""
    looked_up: int = 0
    """Only so many words were looked up; 0 if all were."""

    def __bool__(self) -> bool:
        return bool(self.scores)


@dataclass(frozen=True, slots=True)
class _Rightly:
    """Words, the misspelt ones among which are spelt rightly."""

    words: Words
    read_as: tuple[tuple[str, str], ...]

    @classmethod
    def of(cls, words: Words, choice: Mapping[str, str]) -> "_Rightly":
        right = (part for word in words for part in choice.get(word, word).split())
        return cls(tuple(right), tuple(choice.items()))

    def answer(self, scores: Scores) -> Answer:
        return Answer(scores, read_as=self.read_as)

    def near(self, answer: Answer) -> Answer:
        """Return an answer with those of the words that it was found with."""
        used = [pair for pair in self.read_as if not {*pair[1].split()} <= {*answer.left_out}]
        typed = {right: typed for typed, right in self.read_as}
        left_out = tuple(typed.get(word, word) for word in answer.left_out)
        return replace(answer, left_out=left_out, read_as=tuple(used))


class Phrases:
    """Looks several words up."""

    def __init__(self, terms: Terms) -> None:
        self._terms = terms
        self._spellings = Spellings(terms)

    def answer(self, words: Words) -> Answer:
        """Return the icons that answer plain words, however they are spelt, or what is near."""
        found = self.whole(words)
        if found and (query.without_style(words) == words or min(found.values()) < BROADER):
            return Answer(found, read_as=self._taken_for(words, found))
        if is_insult(" ".join(words)):
            return Answer()
        rightly = self._rightly(words)
        if all_of_them := self._best(one.answer(self.whole(one.words)) for one in rightly):
            return all_of_them
        surely = list(filter(self._is_sure, rightly))
        if not surely:
            return self._fewer(words)
        return self._best(one.near(self._fewer(one.words)) for one in surely)

    def names_thing(self, words: Words) -> bool:
        """Whether words with one for a style name a thing together, and not only a kind of it."""
        found = self._terms.plainly(" ".join(words))
        return bool(found) and min(found.values()) < BROADER

    def _taken_for(self, words: Words, found: Scores) -> tuple[tuple[str, str], ...]:
        """Return words that few of the best icons are called by, with what the others are."""
        typed, best = " ".join(words), min(found.values())
        first = {icon for icon, score in found.items() if score == best}
        formal, own = query.spelt_out(words), self._terms.named(typed)
        if formal != words and first.isdisjoint(self._together(words) if len(words) > 1 else own):
            return ((typed, " ".join(formal)),)
        if 2 * len(first & own) >= len(first):
            return ()
        if best >= BROADER and not own:
            return tuple((typed, term) for term in self._terms.broader(typed)[:1])
        same = (*self._terms.same(typed), *([" ".join(formal)] if formal != words else ()))
        name = max(same, key=lambda term: len(first & self._terms.named(term)), default="")
        return ((typed, name),) if name and first & self._terms.named(name) else ()

    def read_as(self, words: Words) -> tuple[tuple[str, str], ...]:
        """Return those of several words that are surely misspelt, each with the right one."""
        return next((one.read_as for one in self._rightly(words) if self._is_sure(one)), ())

    def _rightly(self, words: Words) -> list[_Rightly]:
        choices = self._spellings.corrected(words) if len(words) > 1 else []
        return [_Rightly.of(words, choice) for choice in choices]

    def _is_sure(self, rightly: _Rightly) -> bool:
        return all(self._spellings.is_sure(*pair) for pair in rightly.read_as)

    @staticmethod
    def _best(answers: Iterable[Answer]) -> Answer:
        """Return the answer with the surest icons, the first among equals."""
        return min(
            filter(None, answers), key=lambda one: min(one.scores.values()), default=Answer()
        )

    def parts(self, words: Sequence[str]) -> Words:
        """Return the words, or few together, that icons answer on their own."""
        found: list[str] = []
        start = 0
        while start < len(words):
            for end in range(min(start + _LONGEST, len(words)), start, -1):
                part = words[start:end]
                bare = " ".join(map(without_number, part))
                tells = any(map(query.tells, part)) and PREPOSITIONS.isdisjoint((part[0], part[-1]))
                if tells and self._terms.plainly(bare):
                    found.append(" ".join(part))
                    break
            start = end
        return tuple(found)

    def whole(self, words: Words) -> Scores:
        """Return the icons that answer all words.

        What is called as it is typed comes first, and what informal words stand for last.
        """
        formal = query.spelt_out(words)
        _, *others = self._spellings.of(words)
        meant = self._spellings.of(formal) if formal != words else []
        return merged(
            (
                self._together(words),
                *(at_least(0, self._together(one)) for one in others),
                *(at_least(1, self._together(one)) for one in self._spellings.same(words)),
                *(at_least(1, self._together(one)) for one in meant),
            )
        )

    def _together(self, words: Words) -> Scores:
        """Return the icons that answer words together, or have all that tell in their names."""
        found = self._terms.plainly(" ".join(words))
        told = query.telling(words)
        if len(told) == 1 or (not found and query.without_style(words) != words):
            return found
        return merged((found, self._all_of(told)))

    def _all_of(self, words: Sequence[str]) -> Scores:
        """Return the icons that answer one of the words, and have all others in their names."""
        named = [self._terms.named(word) for word in words]
        if sum(map(bool, named)) < len(words) - 1:
            return {}
        found: list[Scores] = []
        for place, word in enumerate(words):
            others = named[:place] + named[place + 1 :]
            if all(others):
                answers = self._terms.plainly(word)
                found.append({icon: answers[icon] for icon in set(answers).intersection(*others)})
        return merged(found)

    def _fewer(self, words: Words) -> Answer:
        """Return the icons of the words that tell most of those which together find nothing."""
        formal = query.spelt_out(words)
        spelt = [*self._spellings.of(formal), *self._spellings.of(words)]
        return next(filter(None, map(self._near, dict.fromkeys(spelt))), Answer())

    def _near(self, words: Words) -> Answer:
        if (core := query.without_style(words)) != words:
            return self._without_style(words, core)
        if (told := query.telling(words)) != words:
            return _leaving(set(words).difference(told), words, self.answer(told))
        if len(words) == 1:
            return Answer(self._parted(words[0]))
        if (thing := negation.without(words)) != words:
            return _leaving(set(words).difference(thing), words, self.answer(thing))
        return self._activity(words) or self._head(words) or self._without_attribute(words)

    def _without_style(self, words: Words, core: Words) -> Answer:
        """Return the icons of words without a style; those with their numbers come first."""
        answer = self.answer(core)
        numbered = {
            word: bare for word in words if (bare := without_number(word)) != word and bare in core
        }
        left_out = set(words).difference(core, numbered)
        for word, bare in numbered.items():
            scores, found = self._terms.numbered(answer.scores, word, bare)
            read_as = answer.read_as if found else (*answer.read_as, (word, bare))
            answer = replace(answer, scores=scores, read_as=read_as)
        return _leaving(left_out, words, answer)

    def _activity(self, words: Words) -> Answer:
        """Return the drawings of what people do: somebody is in them in any case."""
        rest = tuple(word for word in words if word not in PEOPLE)
        if rest == words or not rest or not all(map(self._terms.is_activity, rest)):
            return Answer()
        return _leaving(set(words).difference(rest), words, Answer(self.whole(rest)))

    def _without_attribute(self, words: Words) -> Answer:
        """Return the things of the words before one for a view, say: a swing set is swings.

        Or before one that names nothing by itself: *eco friendly* tells of what is eco.
        """
        last = words[-1]
        only_says_how = last in ATTRIBUTES
        if not only_says_how and not is_negated(words[:-1]):
            only_says_how = bool(self._terms.named(last)) and not self._leads(last)
        if only_says_how and not self._terms.is_known(" ".join(words)):
            return _leaving({last}, words, self.answer(words[:-1]))
        return Answer()

    def _head(self, words: Words) -> Answer:
        """Return the things of the last words: nothing is an old red house, so show houses.

        Not where the words together mean something of their own, nor where another word is a thing
        as well, or says no: a sea lion is no lion, a swing set no set, and no smoking no smoking.
        """
        if self._terms.is_known(" ".join(words)):
            return Answer()
        for start in range(1, len(words)):
            before = words[start - 1]
            if is_negated((before,)) or (before not in ATTRIBUTES and self._terms.is_thing(before)):
                return Answer()
            is_last = start == len(words) - 1
            if is_last and (self._terms.is_no_noun(words[start]) or not self._leads(words[start])):
                return Answer()
            found = self._terms.plainly(" ".join(words[start:]))
            if found and min(found.values()) < COMPOUND:
                return _leaving({*words[:start]}, words, Answer(found))
        return Answer()

    def _leads(self, word: str) -> bool:
        """Whether a word names a thing, and does not only say of what kind others are."""
        return self._terms.is_thing(word) or self._terms.is_known(word)

    def _parted(self, word: str) -> Scores:
        """Return the icons whose names have both words that ``word`` is joined from.

        Or those of the one, if the other only says how they are drawn.
        """
        pairs = list(query.halves(word)) if len(word) <= _JOINED else []
        for first, second in pairs:
            name = f"{first}-{second}"
            if {first, second} & STYLES and self._terms.is_name(name):
                return self._terms.plainly(" ".join(take_apart(name).words))
        known = self._terms.listed(part for pair in pairs for part in pair if len(part) > 2)
        for first, second in pairs:
            if {first, second} <= known and (found := self._all_of((first, second))):
                return found
        return {}


def _leaving(some: Set[str], words: Words, answer: Answer) -> Answer:
    """Return an answer that was found without some of the words; what tells nothing is no loss."""
    left_out = {*some, *answer.left_out}
    told = tuple(word for word in words if word in left_out and query.tells(word))
    return replace(answer, left_out=told) if answer else answer


def at_least(least: int, scores: Scores) -> Scores:
    """Return icons with none better than a score."""
    return {icon: max(score, least) for icon, score in scores.items()}


def merged(parts: Iterable[Scores]) -> Scores:
    """Return the icons of all, each with its best score."""
    found: Scores = {}
    for part in parts:
        for icon, score in part.items():
            found[icon] = min(score, found.get(icon, NEVER))
    return found
