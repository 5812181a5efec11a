"""What pattern is wanted: its size, how it is filled, and the seed."""

from PySide6.QtCore import QRectF, Qt
from PySide6.QtGui import QAction, QPaintEvent
from PySide6.QtWidgets import QCheckBox, QFrame, QPushButton, QSpinBox, QWidget

from iconstudio.gui.canvas.outlines import IconOutlines
from iconstudio.gui.document.document import new_gesture
from iconstudio.gui.panels.seed import SeedField
from iconstudio.gui.panels.value_slider import NAME, FactorSlider, ValueSlider
from iconstudio.gui.theme import theme
from iconstudio.gui.theme.layout import card, column, label, row, tool_button
from iconstudio.gui.theme.painting import smooth_painter
from iconstudio.gui.theme.theme import UNIT
from iconstudio.gui.workspaces.pattern.colour import ColourButton
from iconstudio.model import CANVAS, Pictogram
from iconstudio.workflows.pattern import page as edits
from iconstudio.workflows.pattern.bounds import LARGER, LARGEST, LARGEST_SEED, SMALLER, SMALLEST
from iconstudio.workflows.pattern.page import PatternDocument, PatternPage

GROUNDS = ("#ffffff", "#f7f1e3", "#fde2d4", "#d8e8f2", "#e2efda", "#20242c", "#17375e", "#3a2f4d",
           "#274a3d", "#5a2330")  # fmt: skip
"""Grounds to choose from, pale and dark."""


OF_AN_IMAGE = "An image keeps its own ground, density and turn: this is for icons"


class SizeFields(QWidget):
    """Width and height."""

    def __init__(self, document: PatternDocument) -> None:
        super().__init__()
        self._document = document
        self.width_field, self.height_field = (_side(name) for name in ("Width", "Height"))
        for field in (self.width_field, self.height_field):
            field.valueChanged.connect(self._changed)
        self.words = label("Size")
        sides = self.width_field, label("×"), self.height_field
        row(self.words, *sides, None, of=self, spacing=UNIT // 2)

    def show_size(self, width: int, height: int) -> None:
        """Show the size that is in use."""
        for field, value in ((self.width_field, width), (self.height_field, height)):
            if field.value() != value:
                blocked = field.blockSignals(True)
                field.setValue(value)
                field.blockSignals(blocked)

    def _changed(self) -> None:
        edits.set_size(
            self._document, self.width_field.value(), self.height_field.value(), new_gesture()
        )


def _side(name: str) -> QSpinBox:
    field = QSpinBox(minimum=SMALLEST, maximum=LARGEST, singleStep=SMALLEST)
    field.setKeyboardTracking(False)
    field.setAccessibleName(name)
    field.setToolTip(f"{name} of the pattern; an exemplar's canvas is {CANVAS} wide and high")
    field.setFixedWidth(10 * UNIT)
    field.setAlignment(Qt.AlignmentFlag.AlignHCenter)
    return field


class ShapePicture(QWidget):
    """The shape that is filled, small."""

    def __init__(self, outlines: IconOutlines) -> None:
        super().__init__()
        self._outlines = outlines
        self._shape: Pictogram | None = None
        self.setFixedSize(4 * UNIT, 4 * UNIT)
        outlines.changed.connect(self.update)

    def show_shape(self, shape: Pictogram | None) -> None:
        """Show another shape, or none."""
        self._shape = shape
        self.setToolTip("" if shape is None else shape.credit.title)
        self.update()

    def paintEvent(self, event: QPaintEvent) -> None:
        """Draw the shape, or a frame for the whole rectangle."""
        scheme = theme.current()
        path = None if self._shape is None else self._outlines.outline_of(self._shape)
        with smooth_painter(self) as painter:
            if path is None:
                painter.setPen(scheme.color("muted"))
                painter.setBrush(Qt.BrushStyle.NoBrush)
                painter.drawRect(QRectF(self.rect()).adjusted(5.5, 5.5, -5.5, -5.5))
            else:
                painter.scale(self.width() / CANVAS, self.height() / CANVAS)
                painter.fillPath(path, scheme.color("text"))


class TurnSlider(ValueSlider):
    """An angle in degrees."""

    def words(self, value: float) -> str:
        """Return an angle in words."""
        return f"{value:.0f}°"


class PatternControls(QFrame):
    """Edit what is wanted of the page."""

    def __init__(self, document: PatternDocument, outlines: IconOutlines, filling: QAction) -> None:
        """``filling`` lets the next icon that is chosen be the shape that is filled."""
        super().__init__()
        self._document = document
        self.size_fields = SizeFields(document)
        self.tile = QCheckBox("Tile without a seam")
        self.tile.setToolTip("The pattern continues itself, side by side")
        self.tile.clicked.connect(lambda on: edits.set_tile(document, on))
        self.density = FactorSlider(
            "Density", "How dense icons lie, beside the exemplar", SMALLER, LARGER,
            lambda value, gesture: edits.set_density(document, value, gesture),
        )  # fmt: skip
        self.factor = FactorSlider(
            "Scale", "How large all is, beside the exemplar", SMALLER, LARGER,
            lambda value, gesture: edits.set_scale(document, value, gesture),
        )  # fmt: skip
        self.turn = TurnSlider(
            "Turn", "Degrees by which every icon turns", -180, 180,
            lambda value, gesture: edits.set_turn(document, value, gesture),
        )  # fmt: skip
        self.seed = SeedField(LARGEST_SEED, "patterns")
        self.seed.changed.connect(lambda seed: edits.set_seed(document, seed, self.seed.gesture))
        self.ground = ColourButton(GROUNDS, "Colour of the ground")
        self.ground.chosen.connect(lambda colour: edits.set_ground(document, colour))
        self.transparent = QCheckBox("Transparent")
        self.transparent.setToolTip("Nothing lies behind the pattern")
        self.transparent.clicked.connect(self._set_transparent)
        self.shape = ShapePicture(outlines)
        self.fill = _button(filling)
        self.whole = tool_button(
            "close", "Fill the whole rectangle", lambda: edits.set_fill(document, None)
        )
        self._tips = {one: one.toolTip() for one in (self.density, self.turn, self.ground)}
        self._lay_out()

    def _lay_out(self) -> None:
        self._ground_words, self._shape_words = label("Ground"), label("Shape")
        named = self.size_fields.words, self.seed.words, self._ground_words, self._shape_words
        for words in named:
            words.setFixedWidth(NAME)
        parts = (
            label("Pattern", "heading"),
            self.size_fields,
            self.tile,
            column(self.density, self.factor, self.turn, spacing=2),
            row(self.seed, None),
            row(self._ground_words, self.ground, self.transparent, None, spacing=UNIT // 2),
            row(self._shape_words, self.shape, (self.fill, 1), self.whole, spacing=UNIT // 2),
        )
        row(card(*parts), of=self)

    def show_page(self, page: PatternPage) -> None:
        """Show what the page says."""
        work = page.work
        self.size_fields.show_size(work.width, work.height)
        self.tile.setChecked(work.tile)
        self.tile.setEnabled(work.fill is None)  # a shape is no tile
        self.density.show_value(work.density)
        self.factor.show_value(work.scale)
        self.turn.show_value(work.turn)
        self.seed.set_seed(work.seed)
        self.transparent.setChecked(not work.ground)
        if work.ground:
            self.ground.show_colour(work.ground)
        self.shape.show_shape(work.fill)
        self.whole.setEnabled(work.fill is not None)
        self._heed(work.image is not None)
        self.ground.setEnabled(work.image is None and bool(work.ground))

    def _heed(self, image: bool) -> None:
        """Offer what an image heeds; of the rest, say why not."""
        for one, tip in self._tips.items():
            one.setEnabled(not image)
            one.setToolTip(OF_AN_IMAGE if image else tip)

    def _set_transparent(self, on: bool) -> None:
        edits.set_ground(self._document, "" if on else self.ground.colour)


def _button(action: QAction) -> QPushButton:
    button = QPushButton(action.text().replace("&", ""), toolTip=action.toolTip(), checkable=True)
    button.clicked.connect(action.trigger)
    action.toggled.connect(button.setChecked)
    return button
