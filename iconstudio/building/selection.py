"""Which icons of IconifyJSON sets belong in the bundled collection.

Monochrome pictograms whose licence allows derivative and commercial work; no logos, pixel art,
animations or national flags; of several sizes of one drawing, one.
"""

import re
from collections import defaultdict
from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from pathlib import Path

from iconstudio.building.logos import LOGOS
from iconstudio.library.iconify import IconSet, RawIcon, read_set
from iconstudio.library.words.naming import Name, is_negated, take_apart
from iconstudio.library.words.vocabulary import words
from iconstudio.library.words.wordnet import WordNet

LICENCES = frozenset(
    {
        "Apache-2.0",
        "BSD-2-Clause",
        "BSD-3-Clause",
        "CC-BY-3.0",
        "CC-BY-4.0",
        "CC0-1.0",
        "ISC",
        "MIT",
        "Unlicense",
    }
)
"""SPDX identifiers of the licences that allow derivative and commercial work."""

_UNWANTED_CATEGORIES = frozenset({"Logos", "Programming"})
_UNWANTED_NAMES = re.compile(
    r"pixel|8-?bit|\bdinkie|\bmemory\b|brand|logo|devicon|spinner", re.IGNORECASE
)
"""Sets of pixel art, of logos and of animations that their category does not tell."""
_LOGO_CATEGORY = re.compile(
    r"brand|logo|flags?$|social (media|network)|social(media|bookmark)", re.I
)
_LOGO_SET = re.compile(r"brand|logo|devicon")
_LOGO_WORDS = words("logo logos logotype wordmark brand brands social")
_COMPANIES = words(
    "twitter amazon slack discord dropbox android skype reddit google facebook github python"
)
"""Companies whose names WordNet lists as common nouns, or that name many products after them."""
MAKERS = 4
"""A name that so many authors draw is common. Sets of one author count once."""
_TO_ONE = 3
"""A name is common, whatever logos have it, if so many authors draw it as a thing to one that draws
it as a logo. So *wifi*, 47 to 4, and *bluetooth*, 49 to 10, are; *facebook*,
28 to 35, and *copilot*, 4 to 2, are not."""
_FLAGS = re.compile(r"^(circle-)?flags?-(for|of)-|^flag-[a-z]{2}(-[a-z]+)?$")
_PIXEL_ART = re.compile(r"^pixel-|\b8-?bit\b")
"""Pixel art among the drawings of a set that is none."""
_MOVING = re.compile(r"<(animate|set\b|script|image|foreignObject|text\b|style)")
_COLOURED = re.compile(
    r"(?:fill|stroke|stop-color|color)\s*[=:]\s*[\"']?\s*"
    r"(?!none|currentColor|#0{3,8}\b|black|transparent|inherit|url\()[a-z#]",
    re.IGNORECASE,
)
_MASK = re.compile(r"<mask.*?</mask>", re.DOTALL)
"""A mask's colours are no ink."""
MAX_BODY = 3_500
"""Longest body in characters: longer ones are engravings that eat the space of ten others."""
_BEST_SIZE = 24


def wanted_sets(folder: Path) -> Iterator[tuple[IconSet, tuple[RawIcon, ...]]]:
    """Yield the usable sets of an unpacked ``@iconify/json``, in the order of their prefixes."""
    for path in sorted((folder / "json").glob("*.json")):
        icon_set, icons = read_set(path)
        if is_wanted(icon_set):
            yield icon_set, icons


def is_wanted(icon_set: IconSet) -> bool:
    """Whether a set may be used, and holds pictograms."""
    return (
        icon_set.monochrome
        and icon_set.license in LICENCES
        and icon_set.category not in _UNWANTED_CATEGORIES
        and "Contains Animations" not in icon_set.tags
        and not _UNWANTED_NAMES.search(f"{icon_set.prefix} {icon_set.name}")
    )


@dataclass(frozen=True, slots=True)
class Brands:
    """What sets of logos call their icons, but for what many sets draw as a thing."""

    names: frozenset[str]
    """Names that are no common nouns: an icon so called is a logo."""
    logos: tuple[tuple[RawIcon, str], ...]
    """Logos with names that are: an icon called *apple* is a logo if it looks like one of these."""


def brands(folder: Path, wordnet: WordNet) -> Brands:
    """Return the names and the logos of an unpacked ``@iconify/json``."""
    names: set[str] = set()
    logos: list[tuple[RawIcon, str]] = []
    as_logo: defaultdict[str, set[str]] = defaultdict(set)
    as_thing: defaultdict[str, set[str]] = defaultdict(set)
    for path in sorted((folder / "json").glob("*.json")):
        icon_set, icons = read_set(path)
        only_logos = icon_set.category == "Logos" or bool(_LOGO_SET.search(icon_set.prefix))
        usable = is_wanted(icon_set)
        for icon in icons:
            spoken = take_apart(icon.name).words
            name = " ".join(word for word in spoken if word not in _LOGO_WORDS)
            is_called_logo = only_logos or not _LOGO_WORDS.isdisjoint(spoken)
            if is_called_logo or _is_among_logos(icon):
                as_logo[name].add(icon_set.author)
            elif usable:
                as_thing[name].add(icon_set.author)
            if not is_called_logo:
                continue
            if not wordnet.is_noun(wordnet.lemma(name)):
                names.add(name)
            elif icon_set.monochrome and len(icon.body) <= MAX_BODY:
                logos.append((icon, name))
    common = {
        name
        for name, makers in as_logo.items()
        if len(as_thing[name]) >= max(MAKERS, _TO_ONE * len(makers))
    }
    return Brands(
        frozenset(names - common), tuple((icon, name) for icon, name in logos if name not in common)
    )


def _is_among_logos(icon: RawIcon) -> bool:
    """Whether the set of an icon sorts it under its logos, or its flags."""
    return any(_LOGO_CATEGORY.search(category) for category in icon.categories)


def select(icons: Iterable[RawIcon], logos: frozenset[str]) -> Iterator[tuple[RawIcon, Name]]:
    """Yield the wanted icons of one set, with their names taken apart; of several sizes, one.

    ``logos`` are names that only logos have.
    """
    best: dict[tuple[str, ...], tuple[int, RawIcon, Name]] = {}
    for icon in icons:
        name = take_apart(icon.name)
        if not _is_pictogram(icon, name, logos):
            continue
        size = name.size or _BEST_SIZE
        distance = abs(size - _BEST_SIZE)
        known = best.get(name.drawing)
        if known is None or distance < known[0]:
            best[name.drawing] = distance, icon, name
    for _, icon, name in best.values():
        yield icon, name


def _is_pictogram(icon: RawIcon, name: Name, logos: frozenset[str]) -> bool:
    spoken = set(name.words)
    return not (
        len(icon.body) > MAX_BODY
        or _MOVING.search(icon.body)
        or _COLOURED.search(_MASK.sub("", icon.body))
        or is_negated(name.words)
        or spoken & (_LOGO_WORDS | _COMPANIES)
        or name.phrase in logos
        or icon.id in LOGOS
        or _FLAGS.match(icon.name)
        or _PIXEL_ART.search(icon.name)
        or _is_among_logos(icon)
    )


def namings(icon: RawIcon, name: Name) -> list[Name]:
    """Return all names of an icon, its own first; of its aliases none that names a company.

    Who asks for *twitter* does not mean the arrows that one set calls *twitter-retweet*, too.
    """
    aliases = map(take_apart, icon.aliases)
    return [name, *(alias for alias in aliases if _COMPANIES.isdisjoint(alias.words))]


def normal_body(body: str) -> str:
    """Return a body without what does not change its drawing: copies have the same."""
    body = re.sub(r"\bid=\"[^\"]*\"|url\(#[^)]*\)|href=\"#[^\"]*\"", "", body)
    return re.sub(r"\s+|stroke-width=\"[^\"]*\"|class=\"[^\"]*\"", "", body)
