"""The icons of a whole set: of the collection, or of a folder of SVG files."""

import os
from difflib import get_close_matches
from functools import partial
from pathlib import Path

from iconstudio.library.collection import Collection
from iconstudio.model import IconstudioError, Pictogram
from iconstudio.model.icon_set import Member
from iconstudio.svg.reading import read_file

_SUFFIX = ".svg"


def members(reference: str, collection: Collection) -> tuple[Member, ...]:
    """Return the icons of a set by the name of the set or the path of a folder, in a fixed order.

    Folders in a folder belong to it; what begins with a dot does not.

    Raises
    ------
    IconstudioError
        If there is no such set or folder, or it has no icons.
    """
    if found := _collected(reference, collection):
        return found
    folder = Path(reference)
    if reference and folder.is_dir():
        return _drawings(folder)
    near = get_close_matches(reference, collection.sets, n=3)
    hint = f"Did you mean {' or '.join(near)}?" if near else "Give the path of a folder of SVGs."
    raise IconstudioError(f"There is no set of icons “{reference[:200]}”, and no folder. {hint}")


def is_folder(reference: str, collection: Collection) -> bool:
    """Whether a reference names a folder: a set of the same name comes first."""
    return reference not in collection.sets and Path(reference).is_dir()


def _collected(name: str, collection: Collection) -> tuple[Member, ...]:
    icons = collection.of_set(name) if name in collection.sets else ()
    return tuple(Member(one.id, one.id.partition(":")[2], partial(_itself, one)) for one in icons)


def _drawings(folder: Path) -> tuple[Member, ...]:
    found = []
    for place, folders, files in os.walk(folder):
        folders[:] = [one for one in folders if not one.startswith(".")]
        for name in files:
            if name.lower().endswith(_SUFFIX) and not name.startswith("."):
                path = Path(place, name)
                inside = path.relative_to(folder).as_posix()
                found.append(Member(inside, inside[: -len(_SUFFIX)], partial(read_file, path)))
    if not found:
        raise IconstudioError(f"There is no SVG in the folder “{folder}”. Choose another one.")
    return tuple(sorted(found, key=lambda one: one.id))


def _itself(icon: Pictogram) -> Pictogram:
    return icon
