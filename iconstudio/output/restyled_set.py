"""The folder of a restyled set: an SVG for each icon, contact sheets, ``CREDITS.md``, a manifest.

The manifest says what each file was made of, and how. So a run that was stopped goes on where it
was, and only what would come out the same is taken over.
"""

import os
import re
from collections.abc import Iterator, Sequence
from contextlib import suppress
from pathlib import Path
from time import monotonic

import msgspec

from iconstudio import __version__
from iconstudio.files import read_bytes, remove_abandoned
from iconstudio.model import Credit, IconstudioError, Pictogram
from iconstudio.model.icon_set import Member
from iconstudio.output.credits import credits_page
from iconstudio.output.filenames import file_stems
from iconstudio.output.folder import Folder, digest, digest_of
from iconstudio.output.set_sheet import PER_SHEET, set_sheet
from iconstudio.output.svg import document
from iconstudio.workflows.line_style.sets import Manner, MemberRestyled, MemberSkipped

MANIFEST = "restyled.json"
CREDITS = "CREDITS.md"
_FORMAT = 3
"""To be raised when icons come out differently: those of before are then made again."""
_ICON = re.compile(r"[^./\\:][^/\\:]*\.svg")
_SHEET = re.compile(r"sheet(-\d+)?\.png")
_MOST_BYTES = 100_000_000
_EVERY = 2.0
"""Seconds between two versions of the manifest; what is newer would be made again."""


class _Entry(msgspec.Struct, frozen=True):
    """What a file was made of."""

    icon: str
    seed: int
    made_of: str
    """A digest of all that it depends on."""
    digest: str
    """Of the file."""
    credits: tuple[Credit, ...]
    remarks: tuple[str, ...] = ()
    """What could not be read of its drawing."""
    scale: float = 1.0
    """Below 1 if it had no room on its page."""


class _Manifest(msgspec.Struct, frozen=True):
    program: str = __version__
    set: str = ""
    style: str = ""
    strength: float = 1.0
    size: float = 1.0
    seed: int = 0
    strokes: bool = False
    files: dict[str, _Entry] = {}
    skipped: dict[str, str] = {}
    sheets: tuple[str, ...] = ()


class RestyledSet:
    """Writes the icons of a set as they are finished.

    Raises
    ------
    IconstudioError
        On construction and from every method, if the folder cannot be written; on construction also
        if it holds the icons of another set, or of this one in another style, or a user's own.
    """

    def __init__(self, folder: Path, name: str, members: Sequence[Member], manner: Manner) -> None:
        self._path, self._folder = folder, Folder(folder)
        self._name, self._manner = name, manner
        self._how = digest(repr((_FORMAT, __version__, manner)).encode(errors="replace"))
        stems = file_stems({one.id: one.name for one in members})
        self._files = {identifier: f"{stem}.svg" for identifier, stem in stems.items()}
        before = _read(folder / MANIFEST)
        self._check(before)
        self._before, self._sheets = before.files, before.sheets
        self._done: dict[str, _Entry] = {}
        self.skipped: dict[str, str] = {}
        """The icons that could not be restyled, and why."""
        self.remark = self._remark(before)
        """What a user should know of icons that are replaced; empty if there is nothing."""
        self._saved = monotonic()
        remove_abandoned(folder)

    @property
    def remarks(self) -> dict[str, str]:
        """What could not be read of icons that are finished."""
        done = self._done.values()
        return {one.icon: " ".join(one.remarks) for one in done if one.remarks}

    @property
    def shrunk(self) -> list[float]:
        """The scales of icons that had no room on their pages."""
        return [one.scale for one in self._done.values() if one.scale < 1]

    def __len__(self) -> int:
        """How many icons are finished."""
        return len(self._done)

    def is_done(self, member: Member, source: Pictogram | bytes) -> bool:
        """Whether the file of an icon is there, made of the same, and as it was written."""
        file = self._files[member.id]
        entry = self._before.get(file)
        if entry is None or entry.made_of != self._made_of(member, source):
            return False
        if digest_of(self._path / file) != entry.digest:
            return False
        self._done[file] = entry
        return True

    def add(self, event: MemberRestyled | MemberSkipped) -> None:
        """Write the file of an icon, or note why there is none."""
        if isinstance(event, MemberSkipped):
            self.skipped[event.member.id] = event.reason
            return
        member, file = event.member, self._files[event.member.id]
        data = document(event.title, event.credits, event.drawn, event.page).encode()
        if self._is_foreign(file, data):
            self.skipped[member.id] = (
                f"“{file}” is there already, and not as it was made. It was left as it is: "
                "move it, or choose another folder."
            )
            return
        self._folder.write({file: data})
        self._done[file] = _Entry(
            member.id,
            self._manner.seed_of(member.id),
            self._made_of(member, event.source),
            digest(data),
            tuple(one.credit for one in event.credits),
            event.remarks,
            round(event.scale, 4),
        )
        if monotonic() - self._saved > _EVERY:
            self.save()

    def save(self) -> None:
        """Write the manifest, if there is an icon."""
        files = self._before | self._done
        if files:
            manifest = msgspec.json.encode(self._manifest(files))
            self._folder.write({MANIFEST: msgspec.json.format(manifest, indent=1)})
        self._saved = monotonic()

    def finish(self) -> Iterator[float]:
        """Write the rest, yielding how far that is; remove what earlier runs left.

        Files that were changed since are not removed.
        """
        files = sorted(self._done)
        sheets: list[str] = []
        for start in range(0, len(files), PER_SHEET):
            title = f"{self._name}, {self._manner.style.name}"
            paths = [self._path / file for file in files[start : start + PER_SHEET]]
            picture = yield from set_sheet(title, len(files), paths)
            sheets.append(f"sheet-{len(sheets) + 1}.png" if sheets else "sheet.png")
            self._folder.write_picture(sheets[-1], picture)
        said = {file: self._done[file].credits for file in files}
        page = credits_page(self._name, self._manner.style.name, said)
        self._folder.write({CREDITS: page.encode(errors="replace")})
        self._remove_others(sheets)
        self.save()

    def _is_foreign(self, file: str, data: bytes) -> bool:
        """Whether a file is there that a user made, or changed; ``data`` are to be in it."""
        there = digest_of(self._path / file)
        entry = self._before.get(file)
        known = (digest(data), entry.digest if entry else "")
        return os.path.lexists(self._path / file) and there not in known

    def _remove_others(self, sheets: Sequence[str]) -> None:
        """Remove what earlier runs have written, and this one has not."""
        for file in self._before.keys() - self._done.keys():
            if digest_of(self._path / file) == self._before[file].digest:
                with suppress(OSError):  # it is in nobody's way
                    (self._path / file).unlink()
        for file in set(self._sheets).difference(sheets):
            with suppress(OSError):
                (self._path / file).unlink()
        self._before, self._sheets = {}, tuple(sheets)

    def _made_of(self, member: Member, source: Pictogram | bytes) -> str:
        own = source if isinstance(source, bytes) else repr(source).encode(errors="replace")
        said = self._how, member.id, digest(own)
        return digest(repr(said).encode(errors="replace"))

    def _check(self, before: _Manifest) -> None:
        """Refuse to replace what a run of something else has made, or a user."""
        foreign = [one for one in (CREDITS, "sheet.png") if os.path.lexists(self._path / one)]
        if foreign and not os.path.lexists(self._path / MANIFEST):
            raise IconstudioError(
                f"“{self._path}” holds a {foreign[0]} of yours, which would be replaced. "
                "Choose another folder, or move it."
            )
        if before.files and (before.set, before.style) != (self._name, self._manner.style.name):
            raise IconstudioError(
                f"“{self._path}” holds icons of {before.set} in the style {before.style}. "
                "Choose another folder, or remove that one."
            )

    def _remark(self, before: _Manifest) -> str:
        now = self._manifest({})
        others = [
            f"{name} {getattr(before, name):.15g}"
            for name in ("strength", "size", "seed")
            if getattr(before, name) != getattr(now, name)
        ]
        if before.strokes != now.strokes:
            others.append("--strokes" if before.strokes else "without --strokes")
        if not (before.files and others):
            return ""
        return f"The icons in “{self._path}” are replaced; they were made with {', '.join(others)}."

    def _manifest(self, files: dict[str, _Entry]) -> _Manifest:
        manner = self._manner
        return _Manifest(
            __version__,
            self._name,
            manner.style.name,
            manner.strength,
            manner.size,
            manner.seed,
            manner.strokes,
            dict(sorted(files.items())),
            dict(sorted(self.skipped.items())),
            self._sheets,
        )


def _read(path: Path) -> _Manifest:
    """Return a manifest, with those of its files and sheets that may lie beside it.

    It names none if there is none, or it is broken.
    """
    try:
        manifest = msgspec.json.decode(read_bytes(path, _MOST_BYTES), type=_Manifest)
    except (IconstudioError, msgspec.MsgspecError, RecursionError, UnicodeDecodeError):
        return _Manifest()
    files = {name: one for name, one in manifest.files.items() if _ICON.fullmatch(name)}
    sheets = tuple(filter(_SHEET.fullmatch, manifest.sheets))
    return msgspec.structs.replace(manifest, files=files, sheets=sheets)
