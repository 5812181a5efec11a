"""Exemplars of many pictograms: from the disk cache, or rasterised in worker processes."""

import struct
import zlib
from collections import deque
from collections.abc import Iterator, Sequence
from concurrent.futures import Future
from pathlib import Path

import numpy as np

from iconstudio.caches.pipeline import pipelined
from iconstudio.caches.store import Store, key_of
from iconstudio.model import CANVAS, Exemplar, Frame, IconstudioError, Pictogram
from iconstudio.svg.rasterise import rasterise
from iconstudio.svg.resvg import VERSION
from iconstudio.workers import Workers, loss

FORMAT = 2
"""To be raised when the drawing or the files change; older files are then left alone."""

_CHUNK = 8
_CHUNK_SECONDS = 10.0
_ONE_SECONDS = 5.0
_MEMORY = 1 << 30
"""Bytes that drawing may take."""

_FRAME = struct.Struct("<3d")
_DRAWN, _REFUSED = b"D", b"R"


class RasterCache:
    """Rasterises pictograms and remembers the exemplars in ``folder``, by content.

    A file that is broken is made again.
    """

    def __init__(self, folder: Path, workers: Workers) -> None:
        self._store = Store(folder)
        self._workers = workers
        self._refusals: dict[str, str] = {}

    @property
    def trouble(self) -> str | None:
        """A sentence for the user if the folder cannot be used, else None."""
        return self._store.trouble

    def exemplars(
        self, pictograms: Sequence[Pictogram]
    ) -> Iterator[tuple[int, Exemplar | IconstudioError]]:
        """Yield the index of each pictogram with its exemplar, cached ones first.

        A pictogram that is empty or refused, or crashes or hangs the renderer, yields the error
        instead. Closing the generator leaves undone what has not begun.
        """
        missing: list[tuple[int, str]] = []
        for index, pictogram in enumerate(pictograms):
            key = _key(pictogram.svg)
            found = self._read(key, pictogram)
            if found is None:
                missing.append((index, key))
            else:
                yield index, found
        for index, key, entry in self._render(missing, pictograms):
            yield index, self._keep(key, entry, pictograms[index])

    def _render(
        self, missing: list[tuple[int, str]], pictograms: Sequence[Pictogram]
    ) -> Iterator[tuple[int, str, bytes | str]]:
        """Yield index, key and entry, or the reason why the renderer did not survive."""
        chunks = deque(
            (missing[start : start + _CHUNK], _CHUNK_SECONDS)
            for start in range(0, len(missing), _CHUNK)
        )

        def submit(work: tuple[list[tuple[int, str]], float]) -> "Future[list[bytes]]":
            chunk, seconds = work
            documents = [pictograms[index].svg for index, _ in chunk]
            return self._workers.submit(draw_entries, documents, timeout=seconds, memory=_MEMORY)

        # Few at once, so that nothing need be cancelled, which would kill workers.
        for (chunk, _), future in pipelined(chunks, submit, 2 * self._workers.count):
            error = future.exception()
            failure = loss(error, "Drawing it")
            if error is not None and failure is None:
                raise error
            if failure is None:
                for (index, key), entry in zip(chunk, future.result(), strict=True):
                    yield index, key, entry
            elif len(chunk) == 1:
                yield *chunk[0], failure
            else:  # find the culprit
                chunks.extend(([member], _ONE_SECONDS) for member in chunk)

    def _read(self, key: str, pictogram: Pictogram) -> Exemplar | IconstudioError | None:
        if key in self._refusals:
            return _refusal(pictogram, self._refusals[key])
        try:
            return _decoded(self._store.read(key), pictogram)
        except (OSError, ValueError, zlib.error, struct.error) as error:
            self._store.note_damage(key, error)
            return None

    def _keep(
        self, key: str, entry: bytes | str, pictogram: Pictogram
    ) -> Exemplar | IconstudioError:
        if isinstance(entry, str):
            # Not written down: on a quieter day it may be drawn in time.
            self._refusals[key] = entry
            return _refusal(pictogram, entry)
        self._store.write(key, entry)
        return _decoded(entry, pictogram)


def draw_entries(documents: Sequence[str]) -> list[bytes]:
    """Rasterise documents into cache entries; runs in a worker process."""
    return [_entry(svg) for svg in documents]


def _entry(svg: str) -> bytes:
    try:
        frame, coverage = rasterise(svg)
    except IconstudioError as error:
        data = _REFUSED + str(error).encode()
    else:
        data = _DRAWN + _FRAME.pack(frame.x, frame.y, frame.size) + coverage.tobytes()
    return zlib.compress(data, 1)


def _decoded(entry: bytes, pictogram: Pictogram) -> Exemplar | IconstudioError:
    """Return what an entry holds; zlib's checksum tells if it is damaged."""
    data = zlib.decompress(entry)
    if data[:1] == _REFUSED:
        return _refusal(pictogram, data[1:].decode())
    frame = Frame(*_FRAME.unpack_from(data, 1))
    coverage = np.frombuffer(data, np.uint8, offset=1 + _FRAME.size)
    return Exemplar(pictogram, frame, coverage.reshape(CANVAS, CANVAS))


def _refusal(pictogram: Pictogram, reason: str) -> IconstudioError:
    return IconstudioError(f"{pictogram.name} cannot be used. {reason}")


def _key(svg: str) -> str:
    return key_of(FORMAT, VERSION, CANVAS, svg)
