"""Exemplars made ready for matching: from the disk cache, or prepared in worker processes."""

import struct
import zlib
from collections import deque
from collections.abc import Iterator, Sequence
from concurrent.futures import Future
from pathlib import Path

import numpy as np

from iconstudio.algorithms.iconification import sliding
from iconstudio.algorithms.iconification.matching import PreparedExemplar, prepare
from iconstudio.caches.pipeline import pipelined
from iconstudio.caches.store import Store, key_of
from iconstudio.model import CANVAS, Exemplar
from iconstudio.workers import ProcessDied, Workers

FORMAT = 1
"""To be raised when ``prepare`` or the files change; older files are then left alone."""

_CHUNK = 8
_HEAD = struct.Struct("<dIII4x")
"""Blackness, side of the fields, number of x waves and length of their terms; a multiple of 8."""


class PreparingCache:
    """Prepares exemplars for matching and remembers how in ``folder``, by content.

    A file that is broken is made again.
    """

    def __init__(self, folder: Path, workers: Workers) -> None:
        self._store = Store(folder)
        self._workers = workers

    @property
    def trouble(self) -> str | None:
        """A sentence for the user if the folder cannot be used, else None."""
        return self._store.trouble

    def prepared(
        self, exemplars: Sequence[Exemplar], scales: tuple[float, ...]
    ) -> Iterator[tuple[int, PreparedExemplar]]:
        """Yield the index of each exemplar with all that matching needs, cached ones first.

        Closing the generator leaves undone what has not begun.
        """
        missing: list[tuple[int, str]] = []
        for index, exemplar in enumerate(exemplars):
            key = _key(exemplar, scales)
            try:
                found = _decoded(self._store.read(key), exemplar, scales)
            except (OSError, ValueError, zlib.error, struct.error) as error:
                self._store.note_damage(key, error)
                missing.append((index, key))
            else:
                yield index, found
        for index, key, entry in self._prepare(missing, exemplars, scales):
            self._store.write(key, entry)
            yield index, _decoded(entry, exemplars[index], scales)

    def _prepare(
        self,
        missing: list[tuple[int, str]],
        exemplars: Sequence[Exemplar],
        scales: tuple[float, ...],
    ) -> Iterator[tuple[int, str, bytes]]:
        """Yield index, key and entry of what is missing."""
        chunks = deque(missing[start : start + _CHUNK] for start in range(0, len(missing), _CHUNK))
        ticket = self._workers.ticket()

        def submit(chunk: list[tuple[int, str]]) -> "Future[list[bytes]]":
            some = [exemplars[index] for index, _ in chunk]
            return self._workers.submit(prepared_entries, some, scales, ticket=ticket)

        try:
            for chunk, future in pipelined(chunks, submit, 2 * self._workers.count):
                entries = _entries(future, [exemplars[index] for index, _ in chunk], scales)
                for (index, key), entry in zip(chunk, entries, strict=True):
                    yield index, key, entry
        finally:
            ticket.stop()


def prepared_entries(exemplars: Sequence[Exemplar], scales: tuple[float, ...]) -> list[bytes]:
    """Prepare exemplars into cache entries; runs in a worker process."""
    return [_entry(prepare(exemplar, scales)) for exemplar in exemplars]


def _entries(
    future: "Future[list[bytes]]", exemplars: Sequence[Exemplar], scales: tuple[float, ...]
) -> list[bytes]:
    """Return what a worker has prepared; if its processes were lost, prepare it here."""
    if isinstance(future.exception(), ProcessDied):
        return prepared_entries(exemplars, scales)
    return future.result()


def _entry(ready: PreparedExemplar) -> bytes:
    waves, _, terms = ready.spectra.shape
    head = _HEAD.pack(ready.blackness, ready.squared.shape[-1], waves, terms)
    return zlib.compress(head + ready.spectra.tobytes() + ready.squared.tobytes(), 1)


def _decoded(entry: bytes, exemplar: Exemplar, scales: tuple[float, ...]) -> PreparedExemplar:
    """Return what an entry holds; zlib's checksum tells if it is damaged."""
    data = zlib.decompress(entry)
    blackness, side, waves, terms = _HEAD.unpack_from(data)
    count = waves * len(scales) * terms
    spectra = np.frombuffer(data, np.complex64, count, _HEAD.size)
    squared = np.frombuffer(data, np.int8, offset=_HEAD.size + spectra.nbytes)
    return PreparedExemplar(
        exemplar,
        blackness,
        scales,
        squared.reshape(len(scales), side, side),
        spectra.reshape(waves, len(scales), terms),
    )


def _key(exemplar: Exemplar, scales: tuple[float, ...]) -> str:
    waves = sliding.REACH, sliding.SHORTEST
    return key_of(FORMAT, CANVAS, waves, scales, exemplar.coverage.tobytes())
