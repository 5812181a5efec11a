"""The result that was picked, large, beside the icons that it owes its parts to."""

from collections.abc import Callable, Sequence

from PySide6.QtCore import QRectF, Qt
from PySide6.QtGui import QPaintEvent
from PySide6.QtWidgets import (
    QFrame,
    QGridLayout,
    QHBoxLayout,
    QMenu,
    QPushButton,
    QScrollArea,
    QSizePolicy,
    QStackedLayout,
    QWidget,
)

from iconstudio.grammar import counted
from iconstudio.gui.gallery.display import DisplaySwitch
from iconstudio.gui.gallery.large import LargePicture
from iconstudio.gui.gallery.sending import Destination, offer, offer_to_open
from iconstudio.gui.jobs.live import LiveRunner
from iconstudio.gui.pictures.picture import Picture, SourcePicture, source_pictures
from iconstudio.gui.theme import theme
from iconstudio.gui.theme.elided import ElidedLabel
from iconstudio.gui.theme.layout import column, label, push_button, row, scrolled, with_role
from iconstudio.gui.theme.painting import fill_rounded, smooth_painter
from iconstudio.gui.theme.theme import UNIT
from iconstudio.model import Remix
from iconstudio.output.words import described, thanks, told_of

INVITATION = "Pick a result to see it large, with the icons that its parts come from."
MAKING = "It is being made, and appears here."


class SourceThumbnail(QWidget):
    """A source at its placement, the part that is used in its colour."""

    def __init__(self, picture: SourcePicture) -> None:
        super().__init__()
        self._picture = picture
        self.setFixedSize(6 * UNIT, 6 * UNIT)
        self.setToolTip(described(picture.source.placement))

    def paintEvent(self, event: QPaintEvent) -> None:
        """Draw the source."""
        with smooth_painter(self) as painter:
            fill_rounded(painter, QRectF(self.rect()), theme.current().color("window"))
            box = QRectF(self.rect()).adjusted(2, 2, -2, -2)
            painter.drawImage(box, self._picture.image.at(box.width() * self.devicePixelRatioF()))


class SourceRow(QWidget):
    """One source: thumbnail, share, name, author and licence."""

    def __init__(self, picture: SourcePicture) -> None:
        super().__init__()
        icon = picture.source.exemplar.pictogram
        title = ElidedLabel(icon.name, icon.credit.url)
        title.setProperty("heading", True)
        title.setToolTip(f"{icon.name}: open {icon.credit.url}" if icon.credit.url else icon.name)
        share = label(f"{picture.share:.0%}", "heading")
        share.setFixedWidth(5 * UNIT)
        share.setAlignment(Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter)
        share.setToolTip("Part of the icon's ink that comes from this source")
        who = (
            f"made of {counted(len(icon.made_of), 'icon')}" if icon.made_of else icon.credit.author
        )
        text = ElidedLabel(who, tail=f" · {icon.credit.license}")
        text.setProperty("muted", True)
        text.setToolTip("\n".join(thanks(one.credit) for one in icon.origins))
        words = column(None, title, text, None, spacing=1)
        thumbnail, gap = SourceThumbnail(picture), UNIT * 3 // 2
        row(thumbnail, (words, 1), share, of=self, spacing=gap, margins=(0, 0, UNIT, 0))
        self.setAccessibleName(f"{icon.name}, {picture.share:.0%}")


class DetailPanel(QFrame):
    """The picked result, its sources and credits, and the ways to take it along."""

    def __init__(
        self,
        upright: bool = False,
        invitation: str = INVITATION,
        large: LargePicture | None = None,
        switch: QWidget | None = None,
    ) -> None:
        """``upright``: the result stands above its sources, not beside them, with a switch.

        ``invitation`` is shown as long as there is nothing to show; ``large`` shows the result,
        and ``switch`` how, if not the usual ones.
        """
        super().__init__()
        self.setProperty("card", True)
        self.picture: Picture | None = None
        self._invitation = invitation
        self._columns = 1 if upright else 2
        self.large = large or LargePicture(wide=upright)
        self._title, self._about = with_role(ElidedLabel(""), "title"), label()
        self._about.setToolTip("How far the icon's filled shape and the drawn one cover each other")
        self._rows = QGridLayout()
        self._rows.setContentsMargins(0, 0, UNIT, 0)
        self._rows.setHorizontalSpacing(3 * UNIT)
        self._rows.setVerticalSpacing(UNIT // 2)
        for number in range(self._columns):
            self._rows.setColumnStretch(number, 1)
        self.empty = label(invitation, alignment=Qt.AlignmentFlag.AlignCenter, wordWrap=True)
        """What is shown as long as there is nothing to show."""
        self.empty.setMargin(3 * UNIT)
        full = QWidget()
        margins = UNIT * 3 // 2, UNIT * 3 // 2, UNIT, UNIT * 3 // 2
        heading, buttons = self._make_heading(), self._make_buttons()
        self._sources = sources = self._make_sources()
        if upright:
            self.switch = switch or DisplaySwitch()
            heading.addWidget(self.switch)
            parts = heading, (self.large, 2), self._about, buttons, (sources, 1)
            column(*parts, of=full, margins=margins)
        else:
            heading.addLayout(buttons)
            side = column(heading, self._about, (sources, 1), spacing=UNIT // 2)
            row(self.large, (side, 1), of=full, spacing=2 * UNIT, margins=margins)
        self._stack = QStackedLayout(self)
        self._stack.addWidget(self.empty)
        self._stack.addWidget(full)
        self.setMinimumHeight(23 * UNIT)

    def show_picture(self, picture: Picture | None) -> None:
        """Show a result, or nothing, with its own sources."""
        self.picture = picture
        self.large.show_picture(picture)
        self._stack.setCurrentIndex(0 if picture is None else 1)
        if picture is None:
            self._show_sources(())
            return
        icon = picture.icon
        remix = isinstance(icon, Remix)
        self._title.set_words((icon.composite.style if remix else icon.title).capitalize())
        self._about.setText(told_of(icon, picture.preview))
        self._show_sources(source_pictures(icon.composite, picture.colours) if remix else ())

    def _show_sources(self, sources: Sequence[SourcePicture]) -> None:
        while self._rows.count():
            before = self._rows.takeAt(0).widget()
            before.hide()
            before.deleteLater()
        # Credits without sources may be long, and have the room.
        self._sources.setVisible(bool(sources) or self._columns > 1)
        self._about.setWordWrap(not sources)
        for number, source in enumerate(sources):
            self._rows.addWidget(SourceRow(source), *divmod(number, self._columns))
        self._rows.setRowStretch(self._rows.rowCount(), 1)

    def watch(self, runner: LiveRunner) -> None:
        """Say while a runner makes the first result that this is under way."""

        def tell() -> None:
            self.empty.setText(MAKING if runner.running else self._invitation)

        runner.began.connect(tell)
        runner.ended.connect(tell)

    def add_button(self, name: str, button: QPushButton) -> None:
        """Offer one more way to take the result along, by the action of that name."""
        self.buttons[name] = button
        self._buttons.insertWidget(self._buttons.count() - 1, button)

    def set_takeable(self, on: bool) -> None:
        """Say whether the result may be taken along now."""
        for button in (*self.buttons.values(), self._send):
            button.setEnabled(on)

    def explain(self, text: str) -> None:
        """Say in a tool tip what the words on the result mean."""
        self._about.setToolTip(text)

    def set_destinations(
        self,
        destinations: Sequence[Destination],
        send: Callable[[str], object],
        send_sources: Callable[[str], object],
    ) -> None:
        """Offer to ``send`` the result, or its sources, to one of these, by its title."""
        menu = QMenu(self._send)
        offer(menu, destinations, send)
        openers = offer_to_open(menu, destinations, send_sources)
        menu.aboutToShow.connect(lambda: [one.setVisible(self.picture.has_code) for one in openers])
        self._send.setMenu(menu)
        self._send.setVisible(bool(destinations))

    def _make_heading(self) -> QHBoxLayout:
        self._about.setSizePolicy(QSizePolicy.Policy.Ignored, QSizePolicy.Policy.Preferred)
        return row((self._title, 1))

    def _make_buttons(self) -> QHBoxLayout:
        self.buttons = {
            "svg": push_button("Save SVG…", "Save the icon as SVG, with credits (Ctrl+E)"),
            "png": push_button("Save PNG…", "Save the icon as PNG (Ctrl+Shift+E)"),
            "copy": push_button("Copy SVG", "Copy the icon as SVG (Ctrl+Shift+C)"),
        }
        self._send = push_button("Send to", "Go on with the icon in another workspace")
        self._send.hide()
        self._buttons = row(self._send, *self.buttons.values())
        return self._buttons

    def _make_sources(self) -> QScrollArea:
        inner = QWidget()
        inner.setLayout(self._rows)
        scroll = scrolled(inner)
        scroll.setAccessibleName("Sources of the picked icon")
        return scroll
