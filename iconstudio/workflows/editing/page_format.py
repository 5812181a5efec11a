"""An edit in a project file."""

from collections.abc import Generator
from typing import Any

from iconstudio.inputs.fields import Fields, plain_text
from iconstudio.workflows.editing.page import Area, EditPage, Kind
from iconstudio.workflows.pages import PageFormat, Parts, StoredParts


class EditPages(PageFormat[EditPage]):
    """The icon, and all areas, the one too that is still being traced."""

    def write(self, page: EditPage, parts: Parts) -> dict[str, Any]:
        """Return a page as JSON."""
        return {
            "icon": None if page.icon is None else parts.icon(page.icon.pictogram),
            "keyword": plain_text(page.keyword),
            "areas": [
                {"kind": one.kind.value, "closed": one.closed, "points": one.vertices}
                for one in page.areas
            ],
            "symmetry": page.symmetry,
            "exclude": sorted(page.exclude),
        }

    def read(self, fields: Fields, parts: StoredParts) -> Generator[None, None, EditPage]:
        """Return the page that was written."""
        icon = parts.exemplar(parts.icon(fields.reference())) if fields.has("icon") else None
        yield
        return EditPage(
            icon,
            fields.text("keyword"),
            tuple(map(_area, fields.objects("areas", "area"))),
            fields.axis(),
            frozenset(fields.texts("exclude")),
        )


def _area(fields: Fields) -> Area:
    kind = fields.text("kind")
    if kind not in [one.value for one in Kind]:
        raise fields.mistake('"kind" must be "remove" or "add".')
    return Area(Kind(kind), fields.points("points"), fields.flag("closed"))
