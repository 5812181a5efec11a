"""Photos out of files, the clipboard and what is dropped."""

from collections.abc import Generator
from pathlib import Path

from iconstudio.gui.pictures.photo import image_of
from iconstudio.images.photo import photo_from, photo_of
from iconstudio.inputs.items import File, Image
from iconstudio.model import Photo
from iconstudio.session import Session


def photo_in(session: Session, item: File | Image) -> Generator[None, None, Photo]:
    """Return the photo that was opened, dropped or pasted; yield now and then.

    Raises
    ------
    IconstudioError
        If it cannot be read, or is none.
    """
    match item:
        case File(path):
            return photo_from(Path(path), (yield from session.image(Path(path))))
        case Image(bytes() as data):
            return photo_of((yield from session.image(data)), data=data)
        case Image(image):
            return photo_of(image_of(image))
