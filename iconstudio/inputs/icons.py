"""Icons that files of the user's refer to."""

from pathlib import Path

from iconstudio.files import write_bytes
from iconstudio.model import Pictogram
from iconstudio.model.pictogram import UNCOLLECTED
from iconstudio.svg.credits import titled


def reference_to(pictogram: Pictogram, path: Path) -> str:
    """Return the reference of an icon for the file ``path``.

    What no collection has is saved as SVG in the folder of that file, named after both, with its
    title and credits.

    Raises
    ------
    IconstudioError
        If it cannot be written.
    """
    if not pictogram.id.startswith(UNCOLLECTED):
        return pictogram.id
    name = "".join(c if c.isalnum() else "-" for c in pictogram.id.partition(":")[2])
    file = path.resolve().parent / f"{path.stem}-{name}.svg"
    write_bytes(file, titled(pictogram.svg, pictogram.credit.title).encode())
    return str(file)
