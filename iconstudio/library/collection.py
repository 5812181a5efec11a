"""The bundled collection, opened: icons by keyword and by identifier."""

import logging
import os
import sqlite3
import threading
from collections.abc import Callable, Generator, Iterable
from dataclasses import replace
from functools import wraps
from pathlib import Path
from typing import Any, TypeVar

import numpy as np
from numpy.typing import NDArray

from iconstudio.library import database, messages, misses, search
from iconstudio.library.archive import Archive
from iconstudio.library.fingerprint import stack
from iconstudio.library.iconify import document
from iconstudio.library.identifiers import Identifiers, glob
from iconstudio.library.lookup import Lookup
from iconstudio.library.phrases import Answer
from iconstudio.library.words import coded, query, symbols
from iconstudio.library.words.naming import take_apart
from iconstudio.library.words.query import Style
from iconstudio.library.words.strangers import shows_more
from iconstudio.model import Credit, IconstudioError, Pictogram
from iconstudio.model.progress import Progress
from iconstudio.resources import resource

log = logging.getLogger(__name__)
T = TypeVar("T")

LIMIT = 200
"""Most pictograms for a keyword (section 3.1)."""

_PART = 500
"""Icons that are asked for at a time: a question has room for so many."""
_DAMAGED = "The unpacked icon collection is damaged, and unpacked anew: %s"
_FEW = 20
"""With fewer drawings, a keyword lends no parts to choose from."""
_ANY = Style()


def cache_folder() -> Path:
    """Return the folder in which the program keeps what it can make again."""
    if named := os.environ.get("ICONSTUDIO_CACHE"):
        return Path(named)
    from platformdirs import user_cache_path

    return user_cache_path("iconstudio", appauthor=False)


def _mended(method: Callable[..., T]) -> Callable[..., T]:
    """Ask again if it fails because the unpacked file is damaged: it is unpacked anew."""

    @wraps(method)
    def ask(self: "Collection", *args: Any, **options: Any) -> T:
        before = self._database
        try:
            return method(self, *args, **options)
        except IconstudioError:
            raise
        except Exception:
            if not self._mend(before):
                raise
            return method(self, *args, **options)

    return ask


class Collection:
    """Icons with their credits. May be used by several threads at once.

    Made by ``open`` or ``opening``; ``close`` it, or use it in a ``with`` block.
    """

    def __init__(self, archive: Archive, path: Path) -> None:
        self._lock = threading.RLock()
        self._archive = archive
        self._path = path
        self._closed = False
        self._open()

    def _open(self) -> None:
        self._database = sqlite3.connect(
            f"{self._path.absolute().as_uri()}?mode=ro&immutable=1",
            uri=True,
            check_same_thread=False,
        )
        try:
            ((cells, blackness),) = self._rows("SELECT cells, blackness FROM shapes")
            self._sets = {row[0]: row[1:] for row in self._rows("SELECT * FROM icon_set")}
        except BaseException:
            self._database.close()
            raise
        self.sets = frozenset(credits[0] for credits in self._sets.values())
        """The names of all sets."""
        self._lookup = Lookup(self._rows)
        self._identifiers = Identifiers(self._rows, self._lookup, self.sets, self._choose)
        self._cells: NDArray[np.uint64] = stack([cells])
        self._blackness = np.frombuffer(blackness, dtype=np.uint8)

    @classmethod
    def opening(
        cls, folder: Path | None = None, cache: Path | None = None
    ) -> "Generator[Progress, None, Collection]":
        """Open a collection, yielding progress; the generator's return value is the collection.

        Parameters
        ----------
        folder:
            Where the builder wrote it; without it, the bundled one.
        cache:
            Where to unpack it the first time; without it, ``cache_folder()``.

        Raises
        ------
        IconstudioError
            If the collection is damaged, or the cache is full or cannot be written.
        """
        archive = Archive.at(folder or resource("collection"))
        path = (cache or cache_folder()) / f"collection-{archive.digest}-{database.FORMAT}.sqlite"
        database.remove_abandoned(path.parent)
        if not database.is_sound(path):
            if os.path.lexists(path):
                log.warning(_DAMAGED, path)
            yield from database.unpack(archive, path)
        try:
            return cls(archive, path)
        except (sqlite3.Error, ValueError):
            log.warning(_DAMAGED, path)
            yield from database.unpack(archive, path)
            return cls(archive, path)

    @classmethod
    def open(cls, folder: Path | None = None, cache: Path | None = None) -> "Collection":
        """Open a collection without showing progress; see ``opening``."""
        steps = cls.opening(folder, cache)
        while True:
            try:
                next(steps)
            except StopIteration as stop:
                opened: Collection = stop.value
                return opened

    def close(self) -> None:
        """Close the file."""
        with self._lock:
            self._closed = True
            self._database.close()

    def _mend(self, before: sqlite3.Connection) -> bool:
        """Unpack the collection anew if it is damaged; whether it was ``before``."""
        with self._lock:
            if self._closed:
                return False
            if self._database is not before:  # another thread has mended it
                return True
            if database.is_sound(self._path, thorough=True):
                return False
            log.warning(_DAMAGED, self._path)
            self._database.close()
            for _ in database.unpack(self._archive, self._path):
                pass
            self._open()
            return True

    def __enter__(self) -> "Collection":
        return self

    def __exit__(self, *exc: object) -> None:
        self.close()

    def __len__(self) -> int:
        return len(self._blackness)

    @_mended
    def search(
        self, keyword: str, limit: int = LIMIT, exclude: frozenset[str] = frozenset()
    ) -> tuple[Pictogram, ...]:
        """Return drawings of a thing, the best first, no two alike.

        Raises
        ------
        IconstudioError
            If the keyword is empty, or nothing answers it; the message names what is near.
        """
        if not query.plain(keyword):
            raise IconstudioError(f"There is no word in {messages.said(keyword)}. {messages.THING}")
        scores = self._answer(keyword).scores
        excluded = self._identifiers.numbers(exclude)
        for number in excluded:
            scores.pop(number, None)
        found = self._choose(scores, limit, self._lookup.style(keyword))
        called = self._lookup.called(keyword)
        found = search.with_called(found, called, excluded)[:limit]
        if not found:
            if exclude and self._answer(keyword).scores:
                raise IconstudioError(messages.all_excluded(keyword))
            near = self._identifiers.near_to(keyword)
            raise IconstudioError(misses.told(keyword, self._lookup, near))
        return self._pictograms(found)

    @_mended
    def strangers(
        self, keyword: str, icons: Iterable[str]
    ) -> tuple[frozenset[str], frozenset[str]]:
        """Return which icons of a keyword show more than it by their names, and which may do so.

        The first are those with words for more (``shows_more``), the others those that the search
        holds for no more than related. ``icons`` are identifiers.
        """
        scores = self._answer(keyword).scores
        known = {name: scores[one] for one, name in self._lookup.identifiers(scores).items()}
        words = {
            form for one in query.plain(query.name(keyword)).split() for form in query.forms(one)
        }
        found = frozenset(icons)
        more = frozenset(one for one in found if shows_more(one.partition(":")[2], words))
        related = frozenset(one for one in found if known.get(one, search.MORE) >= search.MORE)
        return more, related - more

    @_mended
    def remark(self, keyword: str) -> str:
        """Return how a keyword was read where not as typed, and what is near, or finds more."""
        answer = self._lookup.truly(self._answer(keyword))
        name, count = query.name(keyword), len(answer.scores)
        wider = self._lookup.wider(name, 0 if answer.left_out else count)
        if answer and symbols.is_flag(keyword.strip()):
            return messages.FLAGS
        unheeded = self._lookup.unheeded(keyword, answer)
        near = self._lookup.spelling(name) or self._lookup.foreign(keyword, answer)
        missing = self._identifiers.missing(keyword) if answer else ""
        said = messages.remark(answer, () if missing else near, wider, unheeded)
        return f"{missing} {said}".strip()

    @_mended
    def get(self, identifier: str) -> Pictogram:
        """Return the pictogram ``set:name``; other spellings, such as ``set-name``, are read.

        Raises
        ------
        IconstudioError
            If there is none; the message names what is near.
        """
        spelt = list(query.identifiers(identifier, self.sets))
        numbers = self._identifiers.numbers([identifier]) or self._identifiers.numbers(spelt)
        if not numbers:
            raise IconstudioError(self._identifiers.unknown(spelt[0] if spelt else identifier))
        return self._pictograms(numbers[:1])[0]

    @_mended
    def of_set(self, name: str) -> tuple[Pictogram, ...]:
        """Return all icons of a set, in the order of their names."""
        rows = self._rows(
            "SELECT number FROM icon WHERE id GLOB ? ORDER BY id", (f"{glob(name)}:*",)
        )
        numbers = [row[0] for row in rows]
        parts = (numbers[start : start + _PART] for start in range(0, len(numbers), _PART))
        return tuple(icon for part in parts for icon in self._pictograms(part))

    @_mended
    def suggest(self, keyword: str) -> tuple[str, ...]:
        """Return keywords near to ``keyword`` in spelling that do have results."""
        return self._lookup.suggestions(keyword)

    @_mended
    def keyword(self, title: str) -> str:
        """Return what icons like the one of that title are looked for by; empty if nothing is.

        That is as many of the title's words, from the first on, as enough drawings answer; if none
        do, the first word that enough answer.
        """
        words = take_apart(title.removesuffix(".svg") or "-").words
        leading = [" ".join(words[:count]) for count in range(len(words), 0, -1)]
        enough = (
            name
            for name in (*leading, *words[1:])
            if len(self._lookup.plainly(query.plain(name))) >= _FEW
        )
        return next(enough, "")

    def _answer(self, keyword: str) -> Answer:
        """Return the icons that answer a keyword, and how it was read.

        If the keyword is an identifier, its icon comes first, then what has the same name.
        """
        spelt = list(query.identifiers(keyword, self.sets))
        meant = dict.fromkeys(self._identifiers.numbers(spelt)[:1], -1)
        if coded.names_set(keyword):
            answer = self._lookup.answer(query.name(keyword))
            return replace(answer, scores=answer.scores | meant)
        found = self._lookup.answer(keyword) or Answer(meant)
        return found or (self._lookup.answer(query.name(spelt[0])) if spelt else found)

    def _choose(self, scores: dict[int, int], limit: int, style: Style = _ANY) -> list[int]:
        found = self._in_order(scores, search.RELEVANT, style)
        chosen: list[int] = []
        if len(found) >= search.PLENTY:  # or else there are too few in any case
            chosen = search.different(self._cells[found], limit)
        if len(found) >= search.ENOUGH and len(chosen) < search.PLENTY:
            most = max(len(chosen), min(limit, search.PLENTY))
            chosen = search.different(self._cells[found], most, search.NEARLY_EQUAL)
        if len(chosen) < search.ENOUGH:
            found = self._in_order(scores, max(scores.values(), default=0), style)
            most = max(len(chosen), min(limit, search.ENOUGH))
            chosen = search.different(self._cells[found], most, search.NEARLY_EQUAL)
        return [int(found[i]) for i in chosen]

    def _in_order(self, scores: dict[int, int], worst: int, style: Style) -> NDArray[np.int64]:
        """Return the icons that score at most ``worst``, the best and those of a style first."""
        known = {icon: score for icon, score in scores.items() if score <= worst}
        icons, values = np.array(list(known.items()), dtype=np.int64).reshape(-1, 2).T
        found = search.in_order(icons, values, self._blackness)
        if not style.words:
            return found
        names, order = self._lookup.identifiers(known), found.tolist()
        said = np.array([style.distance(names[icon]) for icon in order])
        parts = [take_apart(query.name(names[icon])) for icon in order]
        strange = np.array([style.strangeness(one) for one in parts])
        adds = np.array([style.adds(one) for one in parts], dtype=np.bool_)
        seen = search.seen_style(self._blackness[found], style.solid)
        ranks = np.array([known[icon] for icon in order])
        return search.nearest_style(found, ranks, said, seen, strange, adds)

    def _pictograms(self, numbers: list[int]) -> tuple[Pictogram, ...]:
        marks = ",".join("?" * len(numbers))
        rows = self._rows(
            f"SELECT number, id, set_number, view_box, body FROM icon WHERE number IN ({marks})",
            numbers,
        )
        found = {row[0]: self._pictogram(*row[1:]) for row in rows}
        return tuple(found[number] for number in numbers)

    def _pictogram(self, identifier: str, set_number: int, view_box: str, body: str) -> Pictogram:
        _, author, licence, licence_url, url = self._sets[set_number]
        title = identifier.partition(":")[2].replace("-", " ")
        credit = Credit(title, author, licence, licence_url, url)
        return Pictogram(identifier, document(body, view_box), credit)

    def _rows(self, query: str, values: Iterable[Any] = ()) -> list[tuple[Any, ...]]:
        with self._lock:
            return self._database.execute(query, tuple(values)).fetchall()
