"""Pictures that the panels show, made from the values of the model."""

from collections.abc import Callable, Generator
from contextlib import closing
from dataclasses import dataclass, replace
from enum import Enum
from functools import cached_property, lru_cache
from typing import TYPE_CHECKING
from weakref import WeakValueDictionary

import numpy as np
from numpy.typing import NDArray
from PySide6.QtCore import QPointF, QRectF, QSizeF, Qt
from PySide6.QtGui import QColor, QImage, QPainter, QPainterPath, QTransform

from iconstudio.gui.pictures.mipmap import Mipmap
from iconstudio.gui.pictures.vector import painter_path
from iconstudio.model import (
    CANVAS,
    Composite,
    Exemplar,
    Icon,
    Patterned,
    Pictogram,
    Placement,
    Remix,
    Source,
)
from iconstudio.workflows.events import Event, Result

if TYPE_CHECKING:
    from iconstudio.output.colours import Palette

COLOUR_CODE_SIZE = 512
"""Side of a colour-coded picture in pixels: enough for the large view at two pixels a point."""


_BLACK = QColor("black")

_ICON, _TWIN = 0.76, 0.34
"""Sides of an icon and of its colour code beside it, as parts of the square that both share."""


_made: "WeakValueDictionary[int, Picture]" = WeakValueDictionary()
"""By the identities of their icons, which live as long as they do."""


class Display(Enum):
    """What is shown of results: icons, their colour code, or both, as in the paper's figures."""

    PLAIN = "plain"
    BOTH = "both"
    CODED = "coded"


@dataclass(frozen=True, eq=False)
class Picture:
    """An icon, ready to be drawn: as it is (a vector) and coded by source (pixels)."""

    icon: Icon
    outline: QPainterPath
    colours: "Palette | None" = None
    """The colours of its sources; None: those that its composite gives them."""
    coded_side: int = COLOUR_CODE_SIZE
    """Side of the colour-coded picture in pixels."""
    preview: bool = False
    """Whether a better one is to follow in its place."""
    tidied: "Picture | None" = None
    """Of one that shows an icon before it was tidied: the other."""

    @cached_property
    def untidied(self) -> "Picture | None":
        """The icon before what seams brought about was put right; None if nothing was."""
        if not isinstance(self.icon, Remix) or self.icon.drawing.untidied is None:
            return None
        path, drawing = self.icon.drawing.untidied, self.icon.drawing
        outline = painter_path(path)
        coverage = _coverage(outline, len(drawing.coverage))
        icon = self.icon.drawn(replace(drawing, path=path, coverage=coverage, untidied=None))
        return Picture(icon, outline, self.colours, self.coded_side, self.preview, self)

    def shows(self, icon: Icon) -> bool:
        """Return whether it looks like an icon, as it is or tidied."""
        return any(one is not None and icon.looks_like(one.icon) for one in (self, self.tidied))

    @cached_property
    def coded(self) -> Mipmap | None:
        """The picture coded by source, made when it is first asked for: this takes some 15 ms.

        None if the icon is no remix.
        """
        from iconstudio.output.colours import colour_code

        if self.tidied is not None:  # the labelling is the same
            return self.tidied.coded
        match self.icon:
            case Remix(composite=composite, drawing=drawing):
                pixels = colour_code(composite, drawing, self.coded_side, self.colours)
                return Mipmap.of(rgba_image(pixels), 64)
        return None

    @cached_property
    def shapes(self) -> tuple[tuple[QPainterPath, str], ...]:
        """What it is drawn with, from back to front, in units of its size; each with its colour.

        What has none is drawn in ink.
        """
        if isinstance(self.icon, Patterned):
            return tuple((painter_path(fill.path), fill.colour) for fill in self.icon.fills)
        return ((self.outline, ""),)

    @property
    def has_code(self) -> bool:
        """Whether there are sources to colour it by."""
        return isinstance(self.icon, Remix)

    @property
    def title(self) -> str:
        """What it shows."""
        return self.icon.title

    @property
    def name(self) -> str:
        """What to call it beside others."""
        match self.icon:
            case Remix(composite=composite):
                return f"{self.title}, {composite.style}"
        return self.title

    def pictogram(self) -> Pictogram:
        """Return the result as an icon like any other."""
        from iconstudio.output.svg import pictogram_of

        return pictogram_of(self.icon)

    @property
    def _awaits_code(self) -> bool:
        """Whether the colour code is still being made: that of a preview need not be waited for."""
        return self.preview and "coded" not in vars(self)

    def image(self, side: int) -> QImage:
        """Return the icon on nothing, in black or its colours; the longer side is ``side`` pixels.

        It is as large as what it is drawn on.
        """
        return self.rendered(within(QSizeF(*self.icon.size), QRectF(0, 0, side, side)).size())

    def rendered(self, size: QSizeF, ink: QColor = _BLACK) -> QImage:
        """Return what the icon is drawn on, as an image of so many pixels."""
        image = QImage(
            *(max(1, round(side)) for side in size.toTuple()),
            QImage.Format.Format_ARGB32_Premultiplied,
        )
        image.fill(Qt.GlobalColor.transparent)
        with QPainter(image) as painter:
            painter.setRenderHint(QPainter.RenderHint.Antialiasing)
            self._paint_shapes(painter, QRectF(image.rect()), ink)
        return image

    def paint(
        self,
        painter: QPainter,
        target: QRectF,
        ink: QColor,
        display: Display = Display.PLAIN,
    ) -> None:
        """Draw into the square ``target``; what has no colour code, as an icon."""
        painter.save()
        painter.setClipRect(target)  # an icon may reach out of its canvas
        painter.setRenderHints(
            QPainter.RenderHint.Antialiasing | QPainter.RenderHint.SmoothPixmapTransform
        )
        if not self.has_code:
            display = Display.PLAIN
        side, icon, twin = target.width(), self.icon_box(target, display), QRectF(target)
        if display is Display.BOTH:
            twin.setTopLeft(target.bottomRight() - _TWIN * QPointF(side, side))
        if display is Display.CODED or (display is Display.BOTH and not self._awaits_code):
            pixels = twin.width() * painter.device().devicePixelRatioF()
            painter.drawImage(twin, self.coded.at(pixels))
        if display is not Display.CODED:
            self._paint_shapes(painter, within(QSizeF(*self.icon.size), icon), ink)
        painter.restore()

    def icon_box(self, target: QRectF, display: Display) -> QRectF:
        """Return where ``paint`` draws the icon, or what stands for it, within ``target``."""
        box = QRectF(target)
        if display is Display.BOTH and self.has_code:
            box.setSize(QSizeF(_ICON * target.width(), _ICON * target.width()))
        return box

    def _paint_shapes(self, painter: QPainter, target: QRectF, ink: QColor) -> None:
        """Draw what the icon is drawn on into ``target``, which is as wide for its height."""
        width, height = self.icon.size
        painter.setClipRect(target, Qt.ClipOperation.IntersectClip)
        painter.translate(target.topLeft())
        painter.scale(target.width() / width, target.height() / height)
        for path, colour in self.shapes:
            painter.fillPath(path, QColor(colour) if colour else ink)


def within(size: QSizeF, box: QRectF) -> QRectF:
    """Return the largest rectangle as wide for its height as ``size``, in the middle of a box."""
    fitted = QRectF(box.topLeft(), size.scaled(box.size(), Qt.AspectRatioMode.KeepAspectRatio))
    fitted.moveCenter(box.center())
    return fitted


def same(one: Picture, other: Picture) -> bool:
    """Whether two results look the same."""
    return one.icon.looks_like(other.icon)


def pictured(
    events: Generator[Event],
    title: str = "",
    side: int | None = None,
    colours: "Callable[[Icon], Palette | None]" = lambda icon: None,
) -> Generator["Event | Picture"]:
    """Pass ``events`` on, with a ``Picture`` in place of each result.

    Runs where the events are made, so that the window's thread has nothing to compute.

    Parameters
    ----------
    title
        What to call the results; empty leaves them as they are.
    side
        Of the colour-coded pictures, in pixels; None: enough for the large view.
    colours
        Returns the colours of an icon's sources; None: those that its composite gives them.
    """
    with closing(events):
        for event in events:
            if not isinstance(event, Result):
                yield event
            else:
                icon = replace(event.icon, title=title) if title else event.icon
                picture = _drawn(icon, side, colours(icon), event.preview)
                if not picture.preview:
                    _ = picture.coded  # made here, as the window will show it at once
                yield picture
                _ = picture.coded


def picture_of(icon: Icon, size: int | None = None) -> Picture:
    """Return the picture of an icon; ``size`` is the side of the colour-coded one in pixels.

    That one is made at once, for a thread that has nothing to do later; as long as somebody has
    the picture, it is not made again.
    """
    picture = _made.get(id(icon)) or _drawn(icon, size)
    _ = picture.coded
    return picture


def _drawn(
    icon: Icon, side: int | None, colours: "Palette | None" = None, preview: bool = False
) -> Picture:
    side = side or COLOUR_CODE_SIZE
    picture = Picture(icon, painter_path(icon.path), colours, side, preview)
    _ = picture.shapes
    _made[id(icon)] = picture
    return picture


def _coverage(outline: QPainterPath, side: int) -> NDArray[np.uint8]:
    """Draw an outline in canvas units, (side, side) uint8, 255 = ink."""
    image = QImage(side, side, QImage.Format.Format_Alpha8)
    image.fill(Qt.GlobalColor.transparent)
    with QPainter(image) as painter:
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        painter.scale(side / CANVAS, side / CANVAS)
        painter.fillPath(outline, _BLACK)
    rows = np.frombuffer(image.constBits(), np.uint8).reshape(side, image.bytesPerLine())
    return rows[:, :side].copy()


def rgba_image(pixels: NDArray[np.uint8]) -> QImage:
    """Return (h, w, 4) uint8 RGBA, alpha not multiplied in, as an image."""
    pixels = np.ascontiguousarray(pixels)
    height, width, _ = pixels.shape
    image = QImage(pixels.data, width, height, 4 * width, QImage.Format.Format_RGBA8888)
    return image.convertToFormat(QImage.Format.Format_ARGB32_Premultiplied)


def stencil(coverage: NDArray[np.uint8], color: QColor) -> QImage:
    """Return (h, w) uint8 ``coverage`` as an image in one colour, whose alpha does not count."""
    coverage = np.ascontiguousarray(coverage)
    height, width = coverage.shape
    image = QImage(coverage.data, width, height, width, QImage.Format.Format_Alpha8)
    image = image.convertToFormat(QImage.Format.Format_ARGB32_Premultiplied)
    with QPainter(image) as painter:
        painter.setCompositionMode(QPainter.CompositionMode.CompositionMode_SourceIn)
        painter.fillRect(image.rect(), QColor(color.rgb()))
    return image


@lru_cache(64)
def tinted(icon: Exemplar, color: str) -> Mipmap:
    """Return an icon in one colour, at all sizes."""
    return Mipmap.of(stencil(icon.coverage, QColor(color)), 32)


def placed(image: QImage, placement: Placement) -> QImage:
    """Return a picture of the canvas with ``image``, the size of the canvas, at its placement."""
    result = QImage(CANVAS, CANVAS, QImage.Format.Format_ARGB32_Premultiplied)
    result.fill(Qt.GlobalColor.transparent)
    with QPainter(result) as painter:
        painter.setRenderHint(QPainter.RenderHint.SmoothPixmapTransform)
        painter.setTransform(QTransform(*placement.transform))
        painter.drawImage(0, 0, image)
    return result


@dataclass(frozen=True, slots=True, eq=False)
class SourcePicture:
    """A source that contributes significantly: its share of the ink, colour, and where it lies."""

    source: Source
    share: float
    color: QColor
    image: Mipmap


def source_pictures(composite: Composite, palette: "Palette | None" = None) -> list[SourcePicture]:
    """Return the significant sources, the largest share first.

    Each is drawn pale at its placement, with the part that it owns in its colour.
    """
    from iconstudio.output.colours import SIGNIFICANT, source_colours

    colours = source_colours(composite, palette)
    pictures = []
    for label in composite.owners(SIGNIFICANT):
        source = composite.sources[label]
        color = QColor(*(int(value) for value in colours[label][:3]))
        whole = placed(stencil(source.exemplar.coverage, color), source.placement)
        image = Mipmap.of(_with_part(whole, composite.labels == label), 64)
        pictures.append(SourcePicture(source, composite.shares[label], color, image))
    return pictures


def _with_part(image: QImage, part: NDArray[np.bool_]) -> QImage:
    """Return ``image`` faded except where ``part`` is."""
    veil = np.where(part, 255, 72).astype(np.uint8)
    result = QImage(image)
    with QPainter(result) as painter:
        painter.setCompositionMode(QPainter.CompositionMode.CompositionMode_DestinationIn)
        painter.drawImage(result.rect(), stencil(veil, QColor("black")))
    return result
