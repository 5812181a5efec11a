"""Collections of other sizes than the bundled one: parts of it, or it several times over.

A copy has the words of its original, other identifiers, and mirrored or turned shapes, so that the
search takes it for another drawing.
"""

import json
from collections.abc import Callable, Container, Iterator
from dataclasses import fields
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from iconstudio.library import archive
from iconstudio.library.archive import Archive, Contents
from iconstudio.library.fingerprint import SIDE
from iconstudio.library.iconify import IconSet
from iconstudio.library.words.indexing import Index
from iconstudio.resources import resource

_TURNS: tuple[Callable[[NDArray[np.uint8]], NDArray[np.uint8]], ...] = (
    lambda cells: cells,
    lambda cells: cells[:, :, ::-1],
    lambda cells: cells[:, ::-1],
    lambda cells: cells.transpose(0, 2, 1),
)


def write_collection(folder: Path, count: int) -> None:
    """Write a collection of about ``count`` icons, packed less tightly than the bundled one."""
    bundled = Archive.at(resource("collection"))
    columns = json.loads(bundled.read("index.json.xz"))
    bodies = bundled.read("bodies.txt.xz").decode().split("\n")
    shapes = np.frombuffer(bundled.read("shapes.bin.xz"), dtype=np.uint8)
    if count < bundled.icons:
        # A smaller part is part of the larger ones: what it has, they have too.
        chosen = np.sort(np.random.default_rng(11).permutation(bundled.icons)[:count])
        copies = 1
    else:
        chosen = np.arange(bundled.icons)
        copies = round(count / bundled.icons)
    cells = shapes[: -bundled.icons].reshape(bundled.icons, -1)[chosen]
    blackness = shapes[-bundled.icons :][chosen]

    def column(name: str) -> list[Any]:
        return [columns[name][number] for number in chosen]

    contents = Contents(
        sets=tuple(_icon_set(one) for one in columns["sets"]),
        set_of=column("set_of") * copies,
        names=[f"{name}~{n}" if n else name for n in range(copies) for name in column("names")],
        view_boxes=column("view_boxes") * copies,
        bodies=[bodies[number] for number in chosen] * copies,
        cells=b"".join(_turned(cells, turn).tobytes() for turn in _TURNS[:copies]),
        blackness=blackness.tobytes() * copies,
        index=_index(columns, column("phrases"), copies),
    )
    folder.mkdir(parents=True)
    tightly, archive._FILTERS = archive._FILTERS, [{"id": archive.lzma.FILTER_LZMA2, "preset": 1}]
    try:
        archive.write(contents, folder)
    finally:
        archive._FILTERS = tightly


def _index(columns: dict[str, Any], phrases: list[list[int]], copies: int) -> Index:
    """Return what leads to icons with these phrases, and to nothing else, so many times over."""
    kept = sorted({phrase for own in phrases for phrase in own})
    numbers = {phrase: number for number, phrase in enumerate(kept)}
    readings = {
        term: [value for phrase, tier in pairs for value in (numbers[phrase], tier)]
        for term, pairs in _pruned(columns["readings"], numbers)
    }
    relations = {
        word: [value for pair in pairs for value in pair]
        for word, pairs in _pruned(columns["relations"], readings)
    }
    return Index(
        phrases=[[numbers[phrase] for phrase in own] for own in phrases] * copies,
        wordings=[columns["wordings"][phrase] for phrase in kept],
        readings=readings,
        relations=relations,
        proposals=[word for word in columns["proposals"] if word in readings or word in relations],
    )


def _pruned(
    table: dict[str, list[Any]], wanted: Container[Any]
) -> Iterator[tuple[str, list[tuple[Any, Any]]]]:
    """Yield the rows of a table of flat pairs, with those pairs alone whose first is wanted."""
    for word, flat in table.items():
        pairs = [pair for pair in zip(flat[::2], flat[1::2], strict=True) if pair[0] in wanted]
        if pairs:
            yield word, pairs


def _turned(cells: NDArray[np.uint8], turn: Callable[..., NDArray[np.uint8]]) -> NDArray[np.uint8]:
    """Return fingerprints (n, bytes) mirrored or turned."""
    bits = np.unpackbits(cells, axis=1).reshape(-1, SIDE, SIDE)
    return np.packbits(turn(bits).reshape(len(cells), -1), axis=1)


def _icon_set(found: dict[str, Any]) -> IconSet:
    return IconSet(**{one.name: found[one.name] for one in fields(IconSet)})
