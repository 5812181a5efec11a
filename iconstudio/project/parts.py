"""Icons, photos and picked results in a project: parts of their own, which pages refer to."""

import itertools
import re
from collections.abc import Generator, Iterable, Mapping
from dataclasses import replace
from functools import lru_cache
from pathlib import Path as FilePath
from typing import Any, Protocol, cast

from iconstudio.grammar import was
from iconstudio.images.photo import photo_of
from iconstudio.images.reading import Image
from iconstudio.inputs import json
from iconstudio.inputs.formats import Many, Reference, Text, plain_text
from iconstudio.inputs.together import quoted_list
from iconstudio.model import Exemplar, Icon, IconstudioError, Photo, Pictogram
from iconstudio.model.pictogram import OWN, UNCOLLECTED
from iconstudio.project import results
from iconstudio.project.archive import INDEX, part_name
from iconstudio.svg.check import check
from iconstudio.workflows.pages import StoredOrigin, StoredPhoto
from iconstudio.workflows.workflow import Resources

_REFERENCE = re.compile(r"[^:/\\]+:[^:/\\]+")

_SHOWN = 60
"""Most characters of a field's name that are shown."""

_photo_name = lru_cache(1)(part_name)
"""Each edit names the same photo again, which may be large."""


class StoredIcon(StoredOrigin, frozen=True):
    """An icon whose drawing is a part."""

    part: Text = ""
    made_of: Many[StoredOrigin] = ()
    remarks: Many[Text] = ()


class ProjectSession(Protocol):
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

    def __init__(self, others: Iterable[str] = ()) -> None:
        """``others`` are the references of icons on pages that are stored as they were."""
        self._taken = {name for name in others if name.startswith(UNCOLLECTED)}
        self.contents: dict[str, bytes] = {}
        """By the names of the parts."""
        self.icons: dict[str, StoredIcon] = {}
        """What is known of the icons, all but their drawings, by their references."""
        self._pictograms: dict[str, Pictogram] = {}

    def icon(self, pictogram: Pictogram) -> Reference:
        """Take an icon in, and return the reference by which a page names it."""
        wanted = _reference(pictogram.id)
        names = itertools.chain([wanted], (f"{wanted}-{number}" for number in itertools.count(2)))
        for name in names:
            if name in self._taken:
                continue
            other = self._pictograms.setdefault(name, pictogram)
            if other is pictogram or _alike(other, pictogram):
                break
        if name not in self.icons:
            self.icons[name] = StoredIcon.of(
                pictogram,
                part=self._add(
                    "icons", pictogram.id, ".svg", pictogram.svg.encode(errors="replace")
                ),
                made_of=tuple(map(StoredOrigin.of, pictogram.made_of)),
                remarks=tuple(map(plain_text, pictogram.remarks)),
            )
        return Reference(name)

    def photo(self, photo: Photo) -> StoredPhoto:
        """Take a photo in, and return what a page says of it."""
        part = _photo_name("photos", "photo", photo.suffix, photo.data)
        self.contents[part] = photo.data
        return StoredPhoto(part, photo.width, photo.height)

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

    def __init__(
        self, icons: Mapping[str, Any], contents: Mapping[str, bytes], session: ProjectSession
    ) -> None:
        """``icons`` is what ``project.json`` says of them."""
        self.session = session
        self.complaints: list[str] = []
        """What could not be read, where the rest was; a sentence for the user each."""
        self._unknown: dict[str, dict[str, None]] = {}
        """The fields that are not known here, by where they are."""
        self._icons = icons
        self._contents = contents
        self._found: dict[str, Pictogram] = {}
        self._drawn: dict[str, Exemplar] = {}
        self._left = {*icons, *(part for part in contents if not part.startswith("icons/"))}
        """Icons, and other parts, that have not been asked for yet."""
        self._total = len(self._left)

    @property
    def share(self) -> float:
        """The share of the project that has been read, from 0 to 1."""
        return 1 - len(self._left) / max(1, self._total)

    @property
    def resources(self) -> Resources:
        """The session, which knows the icons of the project, too."""
        return cast(Resources, _Resources(self))

    @property
    def passed_over(self) -> tuple[str, ...]:
        """The fields that are not known here, as later versions may write them; in sentences."""
        return tuple(
            f"{where}, {quoted_list(names)} {was(names)} passed over, which this version of "
            "Iconstudio does not know. Save under another name, and the file stays as it is."
            for where, names in ((where, list(some)) for where, some in self._unknown.items())
        )

    def note_unknown(self, where: str, fields: Iterable[str]) -> None:
        """Note fields that are not known here."""
        for name in fields:
            self._unknown.setdefault(where, {})[name[:_SHOWN]] = None

    def icon(self, reference: str) -> Pictogram:
        """Return an icon that a page names: of the collection, or as it was stored.

        Raises
        ------
        IconstudioError
            If there is none, or it is no good.
        """
        if reference not in self._found:
            self._left.discard(reference)
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
        self._left.discard(part)
        return self._contents[part]

    def drawn(self, part: str) -> Pictogram:
        """Return an SVG of the file, which went through the gate.

        Raises
        ------
        IconstudioError
            If it is missing, or no good.
        """
        return self.session.icon_from(self.content(part), part)

    def photo(self, stored: StoredPhoto) -> Generator[None, None, Photo]:
        """Return the photo of which a page says this; yield while it is decoded.

        Raises
        ------
        IconstudioError
            If it is missing, or no good.
        """
        data = self.content(stored.part)
        image = yield from self.session.image(data)
        width, height = stored.width or image.width, stored.height or image.height
        photo = photo_of(replace(image, width=width, height=height), data=data)
        return replace(photo, suffix=FilePath(stored.part).suffix)

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
        stored = reference in self._icons
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
        data = self._icons[reference]
        entry = json.converted(data, StoredIcon, FilePath(INDEX), ", icons")
        self.note_unknown("Of the icons", json.unknown_fields(entry, data))
        return replace(
            _as_stored(self.drawn(entry.part), self.content(entry.part)),
            id=entry.id or reference,
            credit=entry.credit,
            made_of=tuple(Pictogram(one.id, "", one.credit) for one in entry.made_of),
            remarks=entry.remarks,
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
