"""Images of pixels, out of files, the clipboard or what is dropped: as they are, photos, icons."""

from collections.abc import Callable, Generator
from pathlib import Path

from iconstudio.images.photo import photo_from, photo_of
from iconstudio.images.reading import SUFFIXES, Image
from iconstudio.inputs import items
from iconstudio.model import Photo, Pictogram
from iconstudio.session import Session

ImageSource = Path | bytes | Callable[[], Image]
"""A file, its bytes, or what returns an image that is in none."""


def is_called_image(path: str) -> bool:
    """Whether a file is called as images are."""
    return path.rpartition(".")[2].lower() in SUFFIXES


def image_in(session: Session, source: ImageSource) -> Generator[None, None, Image]:
    """Return an image; yield now and then.

    Raises
    ------
    IconstudioError
        If it cannot be read, or is none.
    """
    if callable(source):
        return source()
    return (yield from session.image(source))


def photo_in(session: Session, item: items.File | items.Image) -> Generator[None, None, Photo]:
    """Return the photo that was opened, dropped or pasted; see ``image_in``."""
    match item:
        case items.File(name):
            path = Path(name)
            return photo_from(path, (yield from image_in(session, path)))
        case items.Image(source):
            data = source if isinstance(source, bytes) else b""
            return photo_of((yield from image_in(session, source)), data=data)


def pictogram_in(
    session: Session, source: ImageSource, name: str
) -> Generator[None, None, Pictogram]:
    """Return an image as an icon, without asking; see ``image_in``."""
    image = yield from image_in(session, source)
    scan = yield from session.scan(image)
    tracing = yield from session.trace(scan, None, name, image.remark)
    return tracing.pictogram
