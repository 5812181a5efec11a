"""EDIT.json: what to change on an icon (section 4.2).

``{"icon": "set:name", "keyword": "camera", "remove": [polygon, ...], "add": [polygon, ...],
"symmetry": "horizontal", "exclude": ["set:name", ...]}``. ``icon`` may be the path of an
SVG or a scan, from the file's folder. A polygon is ``[[x, y], ...]`` in canvas units (0 to 256) of
the normalised icon. Of ``remove`` and ``add`` one may be left out; ``symmetry``, ``exclude`` and a
``title`` may.
"""

from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

from iconstudio.inputs.fields import Fields, written
from iconstudio.model import Axis, Edit, Pictogram, Polygon
from iconstudio.workflows.files import open_file


@dataclass(frozen=True, slots=True)
class EditFile:
    """What an EDIT.json says; ``icon`` is a reference, ``set:name`` or a path."""

    icon: str
    keyword: str = ""
    remove: tuple[Polygon, ...] = ()
    add: tuple[Polygon, ...] = ()
    symmetry: Axis | None = None
    exclude: frozenset[str] = frozenset()
    title: str = ""

    @classmethod
    def of(cls, edit: Edit, refer: Callable[[Pictogram], str]) -> "EditFile":
        """Return the file of an edit; ``refer`` returns the reference of its icon."""
        icon = refer(edit.icon)
        return cls(icon, edit.keyword, edit.remove, edit.add, edit.symmetry, edit.exclude)

    def resolved(self, find: Callable[[str], Pictogram]) -> Edit:
        """Return the edit, its icon found by ``find``."""
        return Edit(
            find(self.icon), self.keyword, self.remove, self.add, self.symmetry, self.exclude
        )


def read_edit(path: Path) -> EditFile:
    """Read an EDIT.json.

    Raises
    ------
    IconstudioError
        If the file cannot be read or does not hold an edit.
    """
    return edit_in(open_file(path, "edit"))


def edit_in(fields: Fields) -> EditFile:
    """Return what the fields of an EDIT.json say.

    Raises
    ------
    IconstudioError
        If they are not what they must be.
    """
    fields.check_keys(("icon", "keyword", "remove", "add", "symmetry", "exclude", "title"))
    return EditFile(
        fields.reference(),
        fields.text("keyword"),
        fields.polygons("remove"),
        fields.polygons("add"),
        fields.axis(),
        frozenset(fields.texts("exclude")),
        fields.text("title"),
    )


def edit_data(edit: EditFile) -> dict[str, object]:
    """Return what the file of an edit says."""
    return {
        "title": edit.title or None,
        "icon": edit.icon,
        "keyword": edit.keyword,
        "remove": [written(polygon.vertices) for polygon in edit.remove],
        "add": [written(polygon.vertices) for polygon in edit.add],
        "symmetry": edit.symmetry,
        "exclude": sorted(edit.exclude),
    }
