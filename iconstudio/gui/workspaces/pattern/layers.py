"""The layers of an image: how many, which one the brush gives, and what was corrected."""

from collections.abc import Callable, Generator

from PySide6.QtCore import QObject, QRectF, Qt, Signal
from PySide6.QtGui import QPaintEvent
from PySide6.QtWidgets import QButtonGroup, QCheckBox, QFrame, QGridLayout, QSpinBox, QWidget

from iconstudio.grammar import counted
from iconstudio.gui.jobs.runner import Runner
from iconstudio.gui.jobs.worker import Worker
from iconstudio.gui.panels.slider import IconSlider
from iconstudio.gui.theme.layout import column, label, push_button, row
from iconstudio.gui.theme.painting import smooth_painter
from iconstudio.gui.theme.theme import UNIT
from iconstudio.gui.workspaces.montage.tools.scribble import THINNEST, WIDEST, Brush
from iconstudio.gui.workspaces.pattern.colour import Swatch, paint_colour
from iconstudio.gui.workspaces.pattern.scene import tint
from iconstudio.model import Separation
from iconstudio.session import Session
from iconstudio.workflows.pattern import page as edits
from iconstudio.workflows.pattern.bounds import MOST_COLOURS
from iconstudio.workflows.pattern.layering import ImageLayers, layers_of
from iconstudio.workflows.pattern.page import PatternDocument

_AUTOMATIC = 1
"""What the field shows for as many colours as there are."""
_ACROSS = 6
_WORDS = "Choose a layer, and paint over what belongs to it."


class LayerReader(Runner):
    """Its event is the ``ImageLayers`` of the image that was requested last."""

    def __init__(self, session: Session, worker: Worker, parent: QObject) -> None:
        super().__init__(worker, parent)
        self._session = session
        self._image: Separation | None = None
        self.layers: ImageLayers | None = None
        """What was found last."""
        self.event.connect(self._keep)

    def request(self, image: Separation | None) -> None:
        """Find the layers of an image, if there is one and it is another."""
        if image == self._image:
            return
        self._image = image
        if image is None:
            self.layers = None
            self.cancel()
        else:
            before = self.layers
            self.start(lambda: _found(self._session, image, before))

    def _keep(self, layers: object) -> None:
        if isinstance(layers, ImageLayers):
            self.layers = layers


def _found(
    session: Session, image: Separation, before: ImageLayers | None
) -> Generator[ImageLayers | None]:
    yield (yield from layers_of(session, image, before))


class LayerSwatch(Swatch):
    """The colour of a layer, on a bar of the tint that shows where it is."""

    def __init__(self, number: int, colour: str) -> None:
        name = f"Layer {number}" if number else "The ground"
        super().__init__(colour, f"{name}: paint with it", 5 * UNIT)
        self.number = number
        self.setCheckable(True)

    def paintEvent(self, event: QPaintEvent) -> None:
        """Draw the round, and the bar below it."""
        super().paintEvent(event)
        if self.number:
            with smooth_painter(self) as painter:
                box = QRectF(0, 0, 14, 14)
                box.moveBottomRight(QRectF(self.rect()).bottomRight())
                paint_colour(painter, box.adjusted(1, 1, -1, -1), tint(self.number).name())


class LayersPanel(QFrame):
    """What can be done with an image; ``choose_layer`` is called with the layer for the brush.

    Signals
    -------
    tinted(bool)
        Whether the layers are to be tinted.
    """

    tinted = Signal(bool)

    def __init__(
        self, document: PatternDocument, brush: Brush, choose_layer: Callable[[int], object]
    ) -> None:
        super().__init__()
        self._choose = choose_layer
        self.count = QSpinBox(minimum=_AUTOMATIC, maximum=MOST_COLOURS)
        self.count.setSpecialValueText("Automatic")
        self.count.setAccessibleName("Number of colours")
        self.count.setToolTip("How many colours the image has, with its ground")
        self.count.setFixedWidth(15 * UNIT)
        self.count.setAlignment(Qt.AlignmentFlag.AlignHCenter)
        self.count.valueChanged.connect(
            lambda count: edits.set_colours(document, None if count == _AUTOMATIC else count)
        )
        self.show_tints = QCheckBox("Show layers")
        self.show_tints.setChecked(True)
        self.show_tints.toggled.connect(self.tinted)
        self.size = IconSlider(
            "brush", "Brush size", (THINNEST, WIDEST), brush.width, brush.set_width
        )
        brush.changed.connect(self.size.slider.setValue)
        self.clear = push_button(
            "Undo corrections", "Take all strokes of the brush back",
            lambda: edits.clear_corrections(document), role="pill",
        )  # fmt: skip
        self.caption = label("Separating the colours…", wordWrap=True)
        self._grid = QGridLayout()
        self._grid.setSpacing(2)
        self._group = QButtonGroup(self)
        self._group.buttonClicked.connect(lambda swatch: choose_layer(swatch.number))
        self._colours: tuple[str, ...] = ()
        swatches = QWidget()
        column(row(self._grid, None), of=swatches)
        column(
            row(label("Layers", "heading"), None, self.show_tints),
            row(label("Colours"), self.count, None, self.size),
            self.caption,
            swatches,
            None,
            row(self.clear, None),
            of=self,
        )

    def show_image(self, image: Separation) -> None:
        """Show what the page says of its image."""
        count = image.colours or _AUTOMATIC
        if self.count.value() != count:
            blocked = self.count.blockSignals(True)
            self.count.setValue(count)
            self.count.blockSignals(blocked)
        strokes = len(image.corrections)
        self.clear.setVisible(bool(strokes))
        self.clear.setText(f"Undo {counted(strokes, 'correction')}")

    def show_layers(self, layers: ImageLayers) -> None:
        """Show the layers that were found."""
        self.remark("")
        if layers.colours == self._colours:
            return
        self._colours = layers.colours
        for swatch in self._group.buttons():
            self._group.removeButton(swatch)
            swatch.hide()
            swatch.deleteLater()
        for number, colour in enumerate(layers.colours):
            swatch = LayerSwatch(number, colour)
            self._group.addButton(swatch)
            self._grid.addWidget(swatch, *divmod(number, _ACROSS))
        chosen = min(1, len(layers.colours) - 1)
        self._group.buttons()[chosen].setChecked(True)
        self._choose(chosen)

    def remark(self, sentence: str) -> None:
        """Say what to do, after what the user should know of how the image was read."""
        self.caption.setText(f"{sentence} {_WORDS}".lstrip())
