"""Pictogram hybrids (section 4.3): choose icons, mix them, scroll, keep what surprises."""

from collections.abc import Callable, Generator
from contextlib import closing
from dataclasses import dataclass, replace
from functools import lru_cache
from pathlib import Path

from PySide6.QtCore import QPoint, Qt
from PySide6.QtWidgets import QFileDialog, QHBoxLayout, QMenu, QSplitter, QVBoxLayout, QWidget

from iconstudio.gui import theme
from iconstudio.gui.actions import Entry, Key
from iconstudio.gui.document import Document
from iconstudio.gui.panels.chooser import IconChooser
from iconstudio.gui.panels.detail import DetailPanel
from iconstudio.gui.panels.sending import Destination, offer
from iconstudio.gui.panels.strip import same
from iconstudio.gui.panels.tray import FavouritesTray
from iconstudio.gui.pictures import Picture
from iconstudio.gui.runner import Runner
from iconstudio.gui.saving import Saver
from iconstudio.gui.theme import UNIT
from iconstudio.gui.worker import Worker
from iconstudio.gui.workspaces.base import Workspace
from iconstudio.gui.workspaces.hybrids import files
from iconstudio.gui.workspaces.hybrids import page as edits
from iconstudio.gui.workspaces.hybrids.batches import Seen, batch
from iconstudio.gui.workspaces.hybrids.page import Ask, HybridsPage
from iconstudio.gui.workspaces.hybrids.panels import IconsColumn, SheetPanel
from iconstudio.gui.workspaces.hybrids.sheet_model import Section, terms
from iconstudio.model import Axis, Exemplar, IconstudioError, Mix, Pictogram
from iconstudio.session import Session
from iconstudio.workflows.events import Event
from iconstudio.workflows.hybrids import FEWEST

EXAMPLE = "lamp"
"""What the welcome offers to mix."""

OWN = {
    "&File": (
        Entry("new", "&New mix", "Start afresh", Key.New, "new"),
        Entry("svg_in", "Open S&VG…", "Mix a drawing of your own", Key.Open, "open"),
        Entry("open", "Open &mix…", "Open a file of icons to mix", "Ctrl+Shift+O"),
        Entry("save", "&Save mix…", "Save the icons to mix as JSON", Key.Save),
        Entry("save_all", "Save all &favourites…", "Save every favourite as SVG", "Ctrl+Alt+S"),
    ),
    "&Edit": (
        Entry("clear", "&Remove all icons", "Remove all icons", "Ctrl+Backspace", "clear"),
        Entry("favourite", "Keep as &favourite", "Keep the picked hybrid", "F"),
        Entry("like", "More &like this", "Draw hybrids like the picked one", "L"),
        Entry("run", "&Mix", "Draw hybrids of the icons", "Ctrl+Return"),
    ),
}  # fmt: skip


@dataclass(frozen=True, slots=True)
class Picked:
    """What the program picked."""

    ask: Ask
    exemplars: tuple[Exemplar, ...]


class HybridsWorkspace(Workspace):
    """Icons on the left; the sheet of hybrids, favourites and details on the right."""

    title = "Hybrids"
    invitation = "Mix with others"

    def __init__(self, session: Session, files: Worker, saver: Saver) -> None:
        super().__init__(session, files, saver, Document(HybridsPage()))
        self.finder = Worker(self)
        """Looks icons up also while hybrids are drawn."""
        self.runner = Runner(self.worker, self)
        self.picking = Runner(self.finder, self)
        self.column = IconsColumn(IconChooser(session, self.finder, multiple=True))
        self.panel = SheetPanel()
        self.sheet = self.panel.sheet
        self.tray = FavouritesTray("Press F at a hybrid to keep it")
        self.detail = DetailPanel()
        self.menu: QMenu | None = None
        self._destinations: tuple[Destination, ...] = ()
        self._section: Section | None = None
        """The section whose batch is drawn now, or was last."""
        self._ran: Mix | None = None
        self._name = ""
        """What the hybrids are called."""
        self._seen = Seen()
        self._scrolled = 0
        """Where the user was on the whole sheet."""
        self._mix_when_picked = False
        self._make_actions()
        self._lay_out()
        self._wire_page()
        self._wire_work()
        self.refresh_icons(theme.current())
        self._show_page(self.document.page)

    # -- putting together ----------------------------------------------------------------------

    def _make_actions(self) -> None:
        self.make_actions(
            {
                "new": lambda: self.document.change("new mix", HybridsPage()),
                "svg_in": self.column.chooser.choose_file,
                "open": self._ask_for_mix,
                "save": self._save,
                "save_all": lambda: self.saver.save_svgs(self.document.page.favourites),
                "clear": lambda: edits.clear_icons(self.document),
                "favourite": lambda: self._with_picked(self.keep),
                "like": lambda: self._with_picked(self.draw_like),
                "run": self.run,
                "coded": self._set_coded,
            },
            OWN,
        )
        for name in ("favourite", "like"):
            self.actions_by_name[name].setEnabled(False)

    def _lay_out(self) -> None:
        upper = QWidget()
        above = QVBoxLayout(upper)
        above.setContentsMargins(0, 0, 0, 0)
        above.setSpacing(UNIT)
        above.addWidget(self.panel, 1)
        above.addWidget(self.tray)
        right = QSplitter(Qt.Orientation.Vertical)
        right.addWidget(upper)
        right.addWidget(self.detail)
        right.setSizes([420, 190])
        right.setHandleWidth(UNIT)
        right.setChildrenCollapsible(False)
        right.setStretchFactor(0, 1)
        layout = QHBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.setSpacing(UNIT)
        layout.addWidget(self.column)
        layout.addWidget(right, 1)

    def _wire_page(self) -> None:
        document, column, cards = self.document, self.column, self.column.cards
        document.page_changed.connect(self._show_page)
        column.chooser.chosen.connect(self._add)
        column.chooser.released.connect(lambda one: edits.remove_icon(document, one.id))
        column.pick.wanted.connect(self.pick)
        cards.pinned.connect(lambda icon, pins: edits.set_pins(document, icon, pins))
        cards.removed.connect(lambda icon: edits.remove_icon(document, icon))
        cards.dropped.connect(self.take)
        cards.dropped_file.connect(column.chooser.open_file)
        column.symmetry.chosen.connect(lambda axis: edits.set_symmetry(document, axis))
        column.offer.clicked.connect(
            lambda: edits.set_symmetry(document, _shared_axis(document.page))
        )
        column.seed.changed.connect(lambda seed: edits.set_seed(document, seed))
        column.run.clicked.connect(self.run)
        self.tray.changed.connect(lambda: edits.set_favourites(document, self.tray.pictures))
        self.tray.save_all.connect(self.actions_by_name["save_all"].trigger)

    def _wire_work(self) -> None:
        sheet, panel, detail = self.sheet, self.panel, self.detail
        for runner in (self.runner, self.picking):
            runner.progress.connect(self.progressed)
            runner.failed.connect(self.failed)
        self.runner.event.connect(self._show_picture)
        self.runner.ended.connect(self._end_batch)
        self.picking.event.connect(self._show_picked_icons)
        self.picking.ended.connect(self._rest)
        sheet.picked.connect(self._look_at)
        sheet.chosen.connect(self.made)
        sheet.favourite.connect(self.keep)
        sheet.like.connect(self.draw_like)
        sheet.asked.connect(self._open_menu)
        sheet.neared_end.connect(self._draw_on)
        panel.back.connect(self._go_back)
        panel.example.connect(self._try_example)
        self.tray.picked.connect(self._look_at)
        self.tray.picked.connect(self.made)
        detail.sent.connect(lambda title: self.send_picture(detail.picture, title))
        self.connect_detail(detail)

    # -- what the window asks for --------------------------------------------------------------

    @property
    def picture(self) -> Picture | None:
        """The picked hybrid."""
        return self.detail.picture

    @property
    def coded(self) -> bool:
        """Whether the hybrids are coded by source."""
        return self.actions_by_name["coded"].isChecked()

    def enter(self) -> None:
        """Begin with looking icons up, or go on at the sheet."""
        (self.sheet if self.sheet.hybrids.sections else self.column.chooser).setFocus()

    def take(self, pictogram: Pictogram) -> None:
        """Mix an icon that was sent or dropped here."""
        job = self.files.submit(lambda: _drawn(self.session, pictogram))
        job.event.connect(self._add)
        job.failed.connect(self.failed)

    def set_destinations(self, destinations: tuple[Destination, ...]) -> None:
        """Say where hybrids can be sent to."""
        self._destinations = tuple(one for one in destinations if one.title != self.title)
        self.detail.set_destinations(self._destinations)

    def cancel(self) -> None:
        """Stop drawing and picking; hybrids that are finished stay."""
        self._mix_when_picked = False
        self.picking.cancel()
        self.runner.cancel()

    def close_work(self) -> None:
        """Stop all work and wait until the threads have ended; for good."""
        super().close_work()
        self.finder.close(self.session.close)

    def refresh_icons(self, look: theme.Theme) -> None:
        """Draw all icons in the colours of ``look``."""
        super().refresh_icons(look)
        self.column.refresh_icons(look)
        self.panel.refresh_icons(look)

    # -- mixing --------------------------------------------------------------------------------

    def run(self) -> None:
        """Draw hybrids of the icons: a new sheet, or more of them if nothing has changed."""
        mix = self.document.page.mix
        problem = _problem(mix)
        if problem:
            self.failed.emit(problem)
            return
        self.said.emit("")
        main = self._main
        if main is not None and mix == self._ran:
            self._go_back()
            if not self.runner.running:
                self._draw(main)
            self.sheet.scrollToBottom()
            return
        self.runner.cancel()
        self.sheet.hybrids.clear()
        self._seen, self._ran, self._name = Seen(), mix, self.document.page.title
        self.panel.show_welcome(False)
        section = Section("", mix)
        self.sheet.hybrids.open(section)
        self._show_section()
        self._draw(section)

    def draw_like(self, picture: Picture) -> None:
        """Draw hybrids that resemble one, in a section of their own."""
        sections, like = self.sheet.hybrids.sections, picture.result.seeds
        if self._main is None or len(like) != len(self._main.mix.icons):
            self.failed.emit("This hybrid is of other icons. Mix its icons again first.")
            return
        if self.sheet.hybrids.alone is None:
            self._scrolled = self.sheet.verticalScrollBar().value()
        title = f"More like {picture.title}"
        section = next((one for one in sections if one.title == title), None)
        if section is not None:
            self.sheet.hybrids.show_alone(section)
        else:
            section = Section(title, replace(self._main.mix, like=like))
            self.sheet.hybrids.open(section)
            self.runner.cancel()
            self._draw(section)
        self._show_section()

    @property
    def _main(self) -> Section | None:
        """The section of all draws that resemble nothing."""
        sections = self.sheet.hybrids.sections
        return sections[-1] if sections else None

    def _draw(self, section: Section) -> None:
        self._section = section
        self.sheet.hybrids.begin(section)
        mix, title, seen = replace(section.mix, first=section.drawn), self._name, self._seen
        self.runner.start(lambda: batch(self.session, mix, title, seen))

    def _draw_on(self) -> None:
        """Draw the next batch of what the user has scrolled to the end of."""
        section = self.sheet.hybrids.alone or self._main
        if section is None or self.runner.running or section.exhausted:
            return
        self._draw(section)

    def _show_picture(self, event: Event | Picture) -> None:
        if isinstance(event, Picture):
            self.sheet.add(self._section, event)
            self.counted.emit(len(self.sheet.hybrids.pictures))

    def _end_batch(self, whole: bool) -> None:
        section = self._section
        new = section.batch
        if whole:
            section.drawn += section.mix.draws
            section.exhausted = not new
        else:
            section.drawn = max([section.drawn, *(one.result.draw + 1 for one in new)])
            # What was drawn but not shown any more may come again.
            self._seen = Seen(self.sheet.hybrids.pictures)
        if whole or new:
            nothing = ", the last of them brought nothing new" if section.exhausted else ""
            self.sheet.end(section, f"{section.drawn} draws{nothing}")
        self._rest()

    def _rest(self) -> None:
        if not (self.runner.running or self.picking.running):
            count = len(self.sheet.hybrids.pictures)
            self.rested.emit(f"{count} hybrids" if count else "")

    # -- looking at results --------------------------------------------------------------------

    def keep(self, picture: Picture) -> None:
        """Make a hybrid a favourite, or no longer."""
        favourites = self.document.page.favourites
        left = tuple(one for one in favourites if not same(one, picture))
        added = left == favourites
        edits.set_favourites(self.document, (*left, picture) if added else left)
        if added:
            self.made.emit(picture)

    def _look_at(self, picture: Picture | None) -> None:
        self.detail.show_picture(picture)
        if picture is not None:
            self.detail.explain(terms(picture))
        for name in ("favourite", "like"):
            self.actions_by_name[name].setEnabled(picture is not None)
        self.picked.emit(picture)

    def _with_picked(self, what: Callable[[Picture], None]) -> None:
        if self.picture is not None:
            what(self.picture)

    def _open_menu(self, picture: Picture, spot: QPoint) -> None:
        menu = QMenu(self)
        menu.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        kept = self.tray.holds(picture)
        menu.addAction(
            "No favourite any more" if kept else "Keep as favourite", lambda: self.keep(picture)
        )
        menu.addAction("More like this", lambda: self.draw_like(picture))
        menu.addSeparator()
        offer(menu, self._destinations, lambda title: self.send_picture(picture, title))
        menu.addAction("Save SVG…", lambda: self._take_along(picture))
        self.menu = menu
        menu.popup(spot)

    def _take_along(self, picture: Picture) -> None:
        self.made.emit(picture)
        self.saver.save_svg(picture)

    def _set_coded(self, coded: bool) -> None:
        self.sheet.set_coded(coded)
        self.detail.large.set_coded(coded)

    def _go_back(self) -> None:
        self.sheet.hybrids.show_alone(None)
        self._show_section()
        self.sheet.executeDelayedItemsLayout()
        self.sheet.verticalScrollBar().setValue(self._scrolled)

    def _show_section(self) -> None:
        alone = self.sheet.hybrids.alone
        self.panel.title.setText("Hybrids" if alone is None else alone.title)
        self.panel.button.setVisible(alone is not None)

    # -- picking -------------------------------------------------------------------------------

    def pick(self, count: int) -> None:
        """Let the program pick icons; once more, the next best ones."""
        keyword = self.column.chooser.field.text().strip()
        if not keyword:
            self.failed.emit("Type what the icons should show, for example “lamp”.")
            self.column.chooser.setFocus()
            return
        page = self.document.page
        ask = Ask(keyword, count, page.symmetry)
        if page.ask is not None and ask == replace(page.ask, group=0):
            ask = replace(ask, group=page.ask.group + 1)
        self.said.emit("")
        self.picking.start(lambda: _picked(self.session, ask))

    def _try_example(self) -> None:
        self.column.chooser.search(EXAMPLE)
        self.pick(self.column.pick.count.value())
        self._mix_when_picked = True

    def _show_picked_icons(self, event: Event | Picked | HybridsPage) -> None:
        if isinstance(event, HybridsPage):
            self._put(event)
        elif isinstance(event, Picked):
            edits.set_icons(self.document, event.exemplars, event.ask)
            if self._mix_when_picked:
                self._mix_when_picked = False
                self.run()

    # -- page ----------------------------------------------------------------------------------

    def _add(self, exemplar: Exemplar) -> None:
        try:
            edits.add_icon(self.document, exemplar)
        except IconstudioError as error:
            self.failed.emit(str(error))

    def _show_page(self, page: HybridsPage) -> None:
        self.column.show_page(page, _shared_axis(page) if page.symmetry is None else None)
        if self.tray.pictures != page.favourites:
            self.tray.strip.show_pictures(page.favourites)
        self.sheet.set_favourites(page.favourites)
        mix = page.mix
        stale = self._ran is not None and self._ran != mix
        self.panel.note.setText("of an earlier mix – press Mix to renew" if stale else "")
        problem = _problem(mix)
        self.column.run.setEnabled(not problem)
        self.column.run.setToolTip(problem or "Draw hybrids of the icons (Ctrl+Return)")
        for name, there in (("clear", page.ids), ("save", page.ids), ("save_all", page.favourites)):
            self.actions_by_name[name].setEnabled(bool(there))

    # -- files ---------------------------------------------------------------------------------

    def _ask_for_mix(self) -> None:
        path, _ = QFileDialog.getOpenFileName(
            self, "Open a mix", "", "Mixes (*.json);;All files (*)"
        )
        if path:
            self.open_mix(path)

    def open_mix(self, path: str) -> None:
        """Put the icons that a file names on the page."""
        self.said.emit("")
        self.picking.start(lambda: files.read_page(self.session, Path(path)))

    def _put(self, page: HybridsPage) -> None:
        page = replace(page, favourites=self.document.page.favourites)
        self.document.change("open mix", page)
        if page.ask is not None:
            self.column.chooser.search(page.ask.keyword)

    def _save(self) -> None:
        page = self.document.page
        self.saver.save_work("mix", page.title, lambda path: files.write_page(path, page))


def _problem(mix: Mix) -> str:
    """Return what is missing before ``mix`` can be drawn, as a sentence; else nothing."""
    if len(mix.icons) < FEWEST:
        more = "two icons" if not mix.icons else "one more icon"
        return f"Choose at least {more} to mix: look some up on the left, or let the program pick."
    return ""


def _shared_axis(page: HybridsPage) -> Axis | None:
    """Return an axis about which all icons of a page are nearly symmetric, if there is one."""
    axes = [_axes(one.exemplar) for one in page.ingredients]
    return next((axis for axis in Axis if axes and all(axis in some for some in axes)), None)


@lru_cache(64)
def _axes(exemplar: Exemplar) -> frozenset[Axis]:
    """Return the axes about which an icon's solid shape is nearly symmetric."""
    from iconstudio.algorithms.raster import solid
    from iconstudio.algorithms.symmetry import NEARLY, likeness

    shape = solid(exemplar.ink)
    return frozenset(axis for axis in Axis if likeness(shape, axis) >= NEARLY)


def _drawn(session: Session, pictogram: Pictogram) -> Generator[Exemplar]:
    yield session.exemplar(pictogram)


def _picked(session: Session, ask: Ask) -> Generator[Event | Picked]:
    with closing(session.choose(ask.keyword, ask.count, ask.symmetry, ask.group)) as choosing:
        icons = yield from choosing
    yield Picked(ask, tuple(map(session.exemplar, icons)))
