"""What an empty canvas says is there to be read, however narrow the window."""

from itertools import groupby

import numpy as np
import pytest
from hands import go_to
from PySide6.QtCore import QRectF, Qt
from PySide6.QtGui import QFont, QFontMetrics, QImage, QPainter

from iconstudio.gui.canvas import painters
from iconstudio.gui.panels.chooser import IconChooser
from iconstudio.gui.theme.theme import LIGHT, UNIT
from iconstudio.gui.workspaces.montage.scene import MontageScene
from iconstudio.gui.workspaces.sketching.scene import SketchScene


@pytest.mark.parametrize("scene", [MontageScene, SketchScene])
@pytest.mark.parametrize("width", [320, 400, 560])
def test_no_line_of_it_is_cut(qapp, scene, width):
    image = QImage(width, 400, QImage.Format.Format_Grayscale8)
    image.fill(255)
    with QPainter(image) as painter:
        painters.paint_welcome(painter, QRectF(image.rect()), *scene.welcome, LIGHT)
    rows = (np.array(image.constBits()).reshape(400, -1)[:, :width] < 200).any(axis=1)
    lines = sum(inked for inked, _ in groupby(rows))
    font = QFont()
    font.setPixelSize(14)
    metrics, room = QFontMetrics(font), QRectF(0, 0, min(360, width - 4 * UNIT), 999).toRect()
    text = metrics.boundingRect(room, Qt.TextFlag.TextWordWrap, scene.welcome[1])
    assert lines == 1 + round(text.height() / metrics.lineSpacing())
    assert not rows[: 2 * UNIT].any() and not rows[200 + 2 * UNIT :].any()


def test_the_number_of_icons_to_pick_is_typed_into_a_field_like_others(window):
    column = go_to(window, "Hybrids").column
    count, seed = column.count, column.seed.field
    assert count.height() == seed.height()
    for one in (count, seed):
        edge = one.grab().toImage().pixelColor(0, one.height() // 2)
        assert edge.name() == LIGHT.border


@pytest.mark.parametrize("title", ["Edit", "Hybrids", "Montage"])
def test_fields_for_words_have_room_for_what_they_say(window, title):
    place = go_to(window, title)
    field = place.findChild(IconChooser).field
    margins = 2 * (1 + UNIT + 2)  # frame, padding, and Qt's own
    said = field.fontMetrics().horizontalAdvance(field.placeholderText())
    assert said <= field.width() - margins


@pytest.mark.parametrize("title", ["Sketch", "Edit", "Montage", "Line style", "Pattern"])
def test_what_is_fitted_into_a_canvas_is_not_covered_by_hints_and_offers(window, title):
    view = go_to(window, title).view
    view.fit()
    page = view.camera.transform.mapRect(view.scene.bounds())
    room = QRectF(view.rect()).adjusted(0, painters.OFFER_ROOM, 0, -painters.HINT_ROOM)
    assert room.adjusted(-0.1, -0.1, 0.1, 0.1).contains(page)
