"""What is dropped or pasted, read from its MIME data, in whichever form it comes."""

import html
from functools import partial

from PySide6.QtCore import QMimeData, QUrl
from PySide6.QtGui import QGuiApplication, QImage, QPixmap

from iconstudio.gui.exchange.dragging import unpacked
from iconstudio.gui.pictures.photo import image_of
from iconstudio.images.pillow import is_image
from iconstudio.inputs.items import Drawing, Elsewhere, File, Image, Item, Reference, named_in
from iconstudio.svg.pasted import data_images, files_in

SVG = "image/svg+xml"
_SVG_TYPES = (SVG, "image/x-inkscape-svg", "application/svg+xml")
_PIXELS = tuple(f"image/{one}" for one in ("png", "tiff", "webp", "bmp", "avif", "heic", "jpeg"))
"""Of several forms of an image, the ones to take first: those that lose nothing."""
_READING = ("xcb", "wayland")


def holds_something(data: QMimeData) -> bool:
    """Whether there is anything that can be opened, or of which can be said why it cannot."""
    there = data.hasUrls() or data.hasText() or data.hasHtml() or data.hasImage()
    return there or any(map(data.hasFormat, _SVG_TYPES)) or unpacked(data) is not None


def holds_words(data: QMimeData) -> bool:
    """Whether there is nothing but text, so that it belongs into a text field."""
    text = data.text()
    if data.hasUrls() or not text.strip() or any(map(data.hasFormat, _SVG_TYPES)):
        return False
    return not files_in(text) and all(isinstance(one, Reference) for one in named_in(text))


def items(data: QMimeData, images_first: bool = False) -> tuple[Item, ...]:
    """Return all that was dropped or pasted, once each; nothing if it is but words.

    Many programs offer the same thing in several forms. ``images_first`` says whether an image of
    pixels is wanted rather than a drawing.
    """
    if (icon := unpacked(data)) is not None:
        return (icon,)
    listed = tuple(dict.fromkeys(one for url in data.urls() for one in _at(url)))
    if any(not isinstance(one, Elsewhere) for one in listed):
        return listed
    ways = [_drawings, _images]
    for way in reversed(ways) if images_first else ways:
        if found := way(data):
            return found
    return listed or named_in(data.text())


def _drawings(data: QMimeData) -> tuple[Item, ...]:
    for kind in _SVG_TYPES:
        if markup := data.data(kind).data().strip():
            return (Drawing(markup),)
    for text in (data.text(), data.html()):
        if found := files_in(text):
            return tuple(map(Drawing, found))
    addressed = _in_addresses(data.text(), data.html())
    return tuple(one for one in addressed if isinstance(one, Drawing))


def _images(data: QMimeData) -> tuple[Item, ...]:
    """Return the image that is offered, undecoded: Qt's readers know no limits, and SVG too."""
    offered = [one for one in data.formats() if one.startswith("image/") and one not in _SVG_TYPES]
    for kind in sorted(offered, key=(*_PIXELS, *offered).index):
        if content := data.data(kind).data():
            return (Image(content),)
    # Where Qt makes an image of whatever is offered, it would read an SVG, without our limits.
    unsafe = QGuiApplication.platformName().startswith(_READING)
    drawn = unsafe and any(map(data.hasFormat, _SVG_TYPES))
    image = data.imageData() if data.hasImage() and not drawn else None
    image = image.toImage() if isinstance(image, QPixmap) else image
    if isinstance(image, QImage) and not image.isNull():
        return (Image(partial(image_of, image)),)
    return tuple(one for one in _in_addresses(data.text(), data.html()) if isinstance(one, Image))


def _at(url: QUrl) -> tuple[Item, ...]:
    if url.isLocalFile():
        return (File(url.toLocalFile()),)
    if url.scheme() == "data":
        return _in_addresses(bytes(url.toEncoded().data()).decode("ascii", "replace"))
    return (Elsewhere(url.toDisplayString()),)


def _in_addresses(text: str, markup: str = "") -> tuple[Item, ...]:
    """Return the images in the data addresses of a text or, if it has none, of HTML."""
    found = data_images(text) or data_images(html.unescape(markup))
    return tuple(
        Drawing(data) if kind == SVG else Image(data)
        for kind, data in found
        if kind == SVG or is_image(data)
    )
