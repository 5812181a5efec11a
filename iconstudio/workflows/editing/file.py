"""EDIT.json: what to change on an icon (section 4.2)."""

from pathlib import Path
from typing import Self

from iconstudio.inputs.formats import Holes, Lines, Polygons, Reference, Text, TextSet
from iconstudio.inputs.lines import area, inner, rounded, rows
from iconstudio.model import Axis, Edit, IconstudioError, Polygon
from iconstudio.workflows.files import open_file
from iconstudio.workflows.workflow import File, Find, Refer


class EditFile(File[Edit], frozen=True):
    """An EDIT.json. Polygons are in canvas units (0 to 256) of the normalised icon."""

    icon: Reference
    keyword: Text = ""
    remove: Polygons = ()
    add: Polygons = ()
    holes: Holes = ()
    """Areas of paper inside the outline that is wanted."""
    lines: Lines = ()
    """Strokes inside it."""
    symmetry: Axis | None = None
    exclude: TextSet = frozenset()
    include: TextSet = frozenset()

    @classmethod
    def of(cls, edit: Edit, refer: Refer) -> Self:
        """Return the file of an edit."""
        holes, lines = rows(edit.inner)
        return cls(
            icon=refer(edit.icon),
            keyword=edit.keyword,
            remove=tuple(rounded(polygon.vertices) for polygon in edit.remove),
            add=tuple(rounded(polygon.vertices) for polygon in edit.add),
            holes=holes,
            lines=lines,
            symmetry=edit.symmetry,
            exclude=edit.exclude,
            include=edit.include,
        )

    def resolved(self, find: Find) -> Edit:
        """Return the edit, its icon found by ``find``."""
        remove, add = tuple(map(area, self.remove)), tuple(map(area, self.add))
        criteria = self.symmetry, self.exclude, self.include
        drawn = inner(self.holes, self.lines)
        return Edit(find(self.icon), self.keyword, remove, add, *criteria, drawn)

    def check(self) -> None:
        """Refuse polygons that enclose nothing, and lines without length."""
        inner(self.holes, self.lines).check()
        for key, polygons in (("remove", self.remove), ("add", self.add)):
            for number, points in enumerate(polygons, start=1):
                try:
                    Polygon.of(points).check_area()
                except IconstudioError as error:
                    raise IconstudioError(
                        f'Polygon {number} of "{key}" is no good. {error}'
                    ) from None


def read_edit(path: Path) -> EditFile:
    """Read an EDIT.json.

    Raises
    ------
    IconstudioError
        If the file cannot be read or does not hold an edit.
    """
    return open_file(path, EditFile)
