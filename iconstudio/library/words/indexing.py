"""The index of a collection: under which words each icon is found."""

from collections import Counter, defaultdict
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

from iconstudio.library.words.decency import Decency
from iconstudio.library.words.misspellings import common_forms, misspellings
from iconstudio.library.words.naming import Name
from iconstudio.library.words.readings import EXACT, MENTION, readings
from iconstudio.library.words.relations import SAME, SPELLING, Relations
from iconstudio.library.words.wordnet import WordNet

_OFTEN, _LONG = 3, 4
"""A word of so many letters, in the names of so many drawings, may be proposed."""


@dataclass(frozen=True, slots=True)
class Index:
    """What leads from a word to icons. A *phrase* is what several icons are called."""

    phrases: list[list[int]] = field(default_factory=list)
    """Numbers of the phrases that name each icon."""
    wordings: list[str] = field(default_factory=list)
    """The words of each phrase, joined by hyphens."""
    readings: dict[str, list[int]] = field(default_factory=dict)
    """Term to phrase, tier, phrase, tier, ... (see ``readings``)."""
    relations: dict[str, list[Any]] = field(default_factory=dict)
    """Keyword to term, rank, term, rank, ... (see ``relations``)."""
    proposals: list[str] = field(default_factory=list)
    """Words in use that may be proposed to somebody who has misspelt one."""


def index(namings: Sequence[Sequence[Name]], wordnet: WordNet) -> Index:
    """Return the index of icons, given all names of each."""
    numbers: dict[tuple[str, ...], int] = {}
    phrases: list[list[int]] = []
    drawings: Counter[int] = Counter()
    for names in namings:
        own = sorted({numbers.setdefault(name.words, len(numbers)) for name in names})
        phrases.append(own)
        drawings.update(own)
    terms: Counter[str] = Counter()
    exact: set[str] = set()
    found: defaultdict[str, list[int]] = defaultdict(list)
    for words, number in numbers.items():
        for term, tier in readings(words, wordnet).items():
            found[term] += (number, tier)
            if tier < MENTION:
                terms[term] += drawings[number]
            if tier == EXACT:
                exact.add(term)
    relations: defaultdict[str, list[Any]] = defaultdict(list)
    proposals = {term for term in exact if " " not in term or wordnet.is_noun(term)}
    counts = _counts(numbers, drawings)
    common = {word for word, count in counts.items() if count >= _OFTEN and len(word) >= _LONG}
    proposals |= common & (wordnet.used | common_forms(wordnet))
    for word, term, rank in Relations(wordnet, terms).all():
        relations[word] += (term, rank)
        if rank == SAME and wordnet.is_counted(word):
            proposals.add(word)
    wrong = misspellings(counts, wordnet)
    for word, right in wrong.items():
        relations[word] += (right, SPELLING)
    decency = Decency(wordnet)
    return Index(
        phrases=phrases,
        wordings=["-".join(words) for words in numbers],
        readings=dict(sorted(found.items())),
        relations=dict(sorted(relations.items())),
        proposals=sorted(
            word for word in proposals - wrong.keys() if not decency.is_unspoken(word)
        ),
    )


def _counts(numbers: Mapping[tuple[str, ...], int], drawings: Counter[int]) -> Counter[str]:
    """Return how many drawings have each word in a name."""
    counts: Counter[str] = Counter()
    for words, number in numbers.items():
        for word in set(words):
            counts[word] += drawings[number]
    return counts
