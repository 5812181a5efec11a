"""Icons, photos and picked results in a project: parts of their own, which pages refer to."""

import itertools
import re
from collections.abc import Generator, Mapping
from dataclasses import asdict, fields, replace
from functools import lru_cache
from pathlib import Path as FilePath
from typing import Any, Protocol, cast

from iconstudio.images.photo import photo_of
from iconstudio.images.reading import Image
from iconstudio.inputs.fields import Fields, plain_text
from iconstudio.model import Credit, Exemplar, Icon, IconstudioError, Photo, Pictogram
from iconstudio.model.pictogram import OWN, UNCOLLECTED
from iconstudio.project import results
from iconstudio.project.archive import part_name
from iconstudio.svg.check import check
from iconstudio.workflows.workflow import Resources

_LARGEST = 10_000_000
"""No photo has more pixels a side."""

_REFERENCE = re.compile(r"[^:/\\]+:[^:/\\]+")


_photo_name = lru_cache(1)(part_name)
"""Each edit names the same photo again, which may be large."""


class Finder(Protocol):
    """A ``Session``, as far as projects know it."""

    def icon(self, reference: str) -> Pictogram:
        """Return an icon of the collection."""
        ...

    def icon_from(self, data: bytes, name: str) -> Pictogram:
        """Return an icon of SVG markup from outside, which may be hostile."""
        ...

    def exemplar(self, pictogram: Pictogram) -> Exemplar:
        """Return an icon on the canvas."""
        ...

    def image(self, source: FilePath | bytes) -> Generator[None, None, Image]:
        """Return the image in a file, or in bytes."""
        ...


class Parts:
    """Collects the parts of a project while its pages are written."""

    def __init__(self) -> None:
        self.contents: dict[str, bytes] = {}
        """By the names of the parts."""
        self.icons: dict[str, dict[str, Any]] = {}
        """What is known of the icons, all but their drawings, by their references."""
        self._pictograms: dict[str, Pictogram] = {}

    def icon(self, pictogram: Pictogram) -> str:
        """Take an icon in, and return the reference by which a page names it."""
        wanted = _reference(pictogram.id)
        names = itertools.chain([wanted], (f"{wanted}-{number}" for number in itertools.count(2)))
        for name in names:
            other = self._pictograms.setdefault(name, pictogram)
            if other is pictogram or _alike(other, pictogram):
                break
        if name not in self.icons:
            part = self._add("icons", pictogram.id, ".svg", pictogram.svg.encode(errors="replace"))
            made_of = [_described(one) for one in pictogram.made_of]
            remarks = [plain_text(one) for one in pictogram.remarks]
            told = {"made_of": made_of, "remarks": remarks}
            self.icons[name] = {"part": part} | _described(pictogram) | told
        return name

    def photo(self, photo: Photo) -> dict[str, Any]:
        """Take a photo in, and return what a page says of it."""
        part = _photo_name("photos", "photo", photo.suffix, photo.data)
        self.contents[part] = photo.data
        return {"part": part, "width": photo.width, "height": photo.height}

    def result(self, icon: Icon) -> str:
        """Take a picked result in, and return the name of its part."""
        written = results.write(icon, self.icon)
        self.contents |= written.parts
        return written.name

    def _add(self, folder: str, name: str, suffix: str, data: bytes) -> str:
        part = part_name(folder, name, suffix, data)
        self.contents[part] = data
        return part


class StoredParts:
    """The parts of a project that is read.

    Everything in them comes from outside: drawings go through the gate of ``session.icon_from``,
    and photos through that of photos.
    """

    def __init__(self, index: Fields, contents: Mapping[str, bytes], session: Finder) -> None:
        self.session = session
        self.complaints: list[str] = []
        """What could not be read, where the rest was; a sentence for the user each."""
        self._icons = index.object("icons")
        self._contents = contents
        self._found: dict[str, Pictogram] = {}
        self._drawn: dict[str, Exemplar] = {}

    @property
    def resources(self) -> Resources:
        """The session, which knows the icons of the project, too."""
        return cast(Resources, _Resources(self))

    def icon(self, reference: str) -> Pictogram:
        """Return an icon that a page names: of the collection, or as it was stored.

        Raises
        ------
        IconstudioError
            If there is none, or it is no good.
        """
        if reference not in self._found:
            self._found[reference] = self._read_icon(reference)
        return self._found[reference]

    def exemplar(self, pictogram: Pictogram) -> Exemplar:
        """Return an icon on the canvas; the same one for the same icon.

        Raises
        ------
        IconstudioError
            If it cannot be drawn.
        """
        if pictogram.svg not in self._drawn:
            self._drawn[pictogram.svg] = self.session.exemplar(pictogram)
        drawn = self._drawn[pictogram.svg]
        return drawn if drawn.pictogram == pictogram else replace(drawn, pictogram=pictogram)

    def content(self, part: str) -> bytes:
        """Return a part as it was stored.

        Raises
        ------
        IconstudioError
            If it is missing.
        """
        if part not in self._contents:
            raise IconstudioError(f"“{part}” is missing in the file.")
        return self._contents[part]

    def drawn(self, part: str) -> Pictogram:
        """Return an SVG of the file, which went through the gate.

        Raises
        ------
        IconstudioError
            If it is missing, or no good.
        """
        return self.session.icon_from(self.content(part), part)

    def photo(self, entry: Fields) -> Generator[None, None, Photo]:
        """Return the photo of which a page says ``entry``; yield while it is decoded.

        Raises
        ------
        IconstudioError
            If it is missing, or no good.
        """
        part = entry.text("part")
        data = self.content(part)
        image = yield from self.session.image(data)
        width = entry.whole("width", image.width, 1, _LARGEST)
        height = entry.whole("height", image.height, 1, _LARGEST)
        photo = photo_of(replace(image, width=width, height=height), data=data)
        return replace(photo, suffix=FilePath(part).suffix)

    def results(self, names: tuple[str, ...]) -> Generator[None, None, tuple[Icon, ...]]:
        """Return those results that can be read; complain about the others."""
        found = []
        for name in names:
            try:
                found.append(results.read(name, self))
            except IconstudioError as error:
                self.complaints.append(f"A result that was picked could not be read. {error}")
            yield
        return tuple(found)

    def _read_icon(self, reference: str) -> Pictogram:
        stored = reference in self._icons.keys
        if not reference.startswith(UNCOLLECTED):
            if not _REFERENCE.fullmatch(reference):
                raise IconstudioError(f"“{reference}” is outside of the file, and is not opened.")
            try:
                return self.session.icon(reference)
            except IconstudioError:
                if not stored:
                    raise
        elif not stored:
            raise IconstudioError(f"The icon “{reference}” is missing in the file.")
        entry = self._icons.object(reference)
        part = entry.text("part")
        return replace(
            _as_stored(self.drawn(part), self.content(part)),
            id=entry.text("id") or reference,
            credit=_credit(entry),
            made_of=tuple(map(_origin, entry.objects("made_of", "origin"))),
            remarks=entry.texts("remarks"),
        )


class _Resources:
    """A session that finds the icons of a project, too."""

    def __init__(self, parts: StoredParts) -> None:
        self._parts = parts

    def icon(self, reference: str) -> Pictogram:
        return self._parts.icon(reference)

    def exemplar(self, pictogram: Pictogram) -> Exemplar:
        return self._parts.exemplar(pictogram)

    def __getattr__(self, name: str) -> Any:
        return getattr(self._parts.session, name)


def _reference(identifier: str) -> str:
    """Return what a page may call an icon: what its fields read as it is, and take for no path."""
    fits = identifier == plain_text(identifier).strip() and _REFERENCE.fullmatch(identifier)
    return identifier if fits and not identifier.lower().endswith(".svg") else f"{OWN}drawing"


def _as_stored(drawn: Pictogram, data: bytes) -> Pictogram:
    """Return a drawing as it was stored, if that is safe to draw, too.

    The gate puts another box around it, which would move it by a part of a pixel.
    """
    try:
        svg = data.decode()
        check(svg)
    except (UnicodeDecodeError, IconstudioError):
        return drawn
    return replace(drawn, svg=svg)


def _alike(one: Pictogram, other: Pictogram) -> bool:
    return (one.id, one.svg, one.credit) == (other.id, other.svg, other.credit)


def _described(pictogram: Pictogram) -> dict[str, Any]:
    """Describe an icon, and whom to thank for it."""
    credit = {key: plain_text(text) for key, text in asdict(pictogram.credit).items()}
    return {"id": plain_text(pictogram.id)} | credit


def _origin(entry: Fields) -> Pictogram:
    return Pictogram(entry.text("id"), "", _credit(entry))


def _credit(entry: Fields) -> Credit:
    return Credit(*(entry.text(one.name) for one in fields(Credit)))
