"""Samples of line styles: what they make of a few lines, kept on disk."""

import zlib
from pathlib import Path as File

from iconstudio.caches.store import Store, key_of
from iconstudio.inputs.line_style import written
from iconstudio.model import LineStyle, Path
from iconstudio.svg.geometry import outline
from iconstudio.svg.lengths import IDENTITY

FORMAT = 1
"""To be raised when samples are drawn in another way; older files are then left alone."""


class SampleCache:
    """Remembers samples in ``folder``, by the content of their styles. One that is broken is gone.

    >>> SampleCache(File("/nowhere")).read(LineStyle("none", ())) is None
    True
    """

    def __init__(self, folder: File) -> None:
        self._store = Store(folder)

    def read(self, style: LineStyle) -> Path | None:
        """Return the sample of a style, if it is kept."""
        key = _key(style)
        try:
            data = zlib.decompress(self._store.read(key)).decode("ascii")
        except (OSError, ValueError, zlib.error) as error:
            self._store.note_damage(key, error)
            return None
        return outline(data, IDENTITY) if data else Path()

    def write(self, style: LineStyle, sample: Path) -> None:
        """Keep the sample of a style, if the folder can be written."""
        self._store.write(_key(style), zlib.compress(sample.svg().encode("ascii")))


def _key(style: LineStyle) -> str:
    return key_of("sample", FORMAT, written(style))
