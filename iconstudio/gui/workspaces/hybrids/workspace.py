"""Pictogram hybrids (section 4.3): choose icons, mix them, scroll, keep what surprises."""

from PySide6.QtCore import QPoint, Qt
from PySide6.QtWidgets import QHBoxLayout, QMenu, QSplitter, QVBoxLayout, QWidget

from iconstudio.gui.document.document import Document
from iconstudio.gui.exchange.saving import Saver
from iconstudio.gui.gallery.detail import DetailPanel
from iconstudio.gui.gallery.favourites import FavouritesPanel
from iconstudio.gui.gallery.pictures import Picture, picture_of
from iconstudio.gui.gallery.sending import Destination, offer
from iconstudio.gui.jobs.worker import Worker
from iconstudio.gui.panels.chooser import IconChooser
from iconstudio.gui.theme.theme import UNIT
from iconstudio.gui.window.actions import Entry, Key, work_entries
from iconstudio.gui.workspaces.base import Workspace
from iconstudio.gui.workspaces.hybrids.batches import CODED
from iconstudio.gui.workspaces.hybrids.drawing import Draws
from iconstudio.gui.workspaces.hybrids.opening import HybridsOpener
from iconstudio.gui.workspaces.hybrids.panels import IconsColumn, SheetPanel
from iconstudio.gui.workspaces.hybrids.sections import terms
from iconstudio.model import IconstudioError, Pictogram
from iconstudio.session import Session
from iconstudio.workflows.files import write_file
from iconstudio.workflows.hybrids import page as edits
from iconstudio.workflows.hybrids.page import HybridsPage
from iconstudio.workflows.workflow import Workflow

OWN = {
    "&File": (
        *work_entries("mix"),
        Entry("svg_in", "Op&en drawing…", "Mix a drawing of your own", "Ctrl+Shift+O", "open"),
        Entry("save_all", "Save all &favourites…", "Save every favourite as SVG", "Ctrl+Alt+S"),
    ),
    "&Edit": (
        Entry("paste", "&Paste icon", "Mix the drawing on the clipboard", Key.Paste),
        Entry("clear", "&Remove all icons", "Remove all icons", "Ctrl+Backspace", "clear"),
        Entry("favourite", "&Favourite", "Keep the picked hybrid, or no longer", "F"),
        Entry("like", "More &like this", "Draw hybrids like the picked one", "L"),
        Entry("run", "&Mix", "Draw hybrids of the icons", "Ctrl+Return"),
    ),
}  # fmt: skip


class HybridsWorkspace(Workspace):
    """Icons on the left; the sheet of hybrids, favourites and details on the right."""

    def __init__(self, workflow: Workflow, session: Session, files: Worker, saver: Saver) -> None:
        super().__init__(workflow, session, files, saver, Document(HybridsPage()))
        self.finder = Worker(self)
        """Looks icons up also while hybrids are drawn."""
        self.opener = HybridsOpener(session, self.document, self.finder, self)
        self.column = IconsColumn(IconChooser(session, self.finder, multiple=True))
        self.panel = SheetPanel()
        self.sheet, self.sections = self.panel.sheet, self.panel.sections
        self.draws = Draws(session, self.worker, self.sheet, self.sections, self)
        self.favourites_panel = FavouritesPanel("Press F at a hybrid to keep it")
        self.detail = DetailPanel()
        self.displays = self.sheet, self.detail.large
        self.menu: QMenu | None = None
        self._destinations: tuple[Destination, ...] = ()
        self._make_actions()
        self._lay_out()
        self._wire_page()
        self._wire_work()
        self._show_page(self.document.page)

    # -- putting together ----------------------------------------------------------------------

    def _make_actions(self) -> None:
        self.make_actions(
            {
                "new": lambda: self.document.change("new mix", HybridsPage()),
                "svg_in": self.column.chooser.choose_file,
                "save": self._save,
                "save_all": lambda: self.saver.save_svgs(self.favourites_panel.pictures),
                "clear": lambda: edits.clear_icons(self.document),
                "favourite": lambda: self.keep(self.picture),
                "like": lambda: self.draw_like(self.picture),
                "run": self.run,
                **self.opener_slots(self.opener),
            },
            OWN,
        )
        for name in ("favourite", "like"):
            self.actions_by_name[name].setEnabled(False)
        self.panel.start.setMenu(
            self.add_examples(self.workflow.examples, self.opener.open_example)
        )

    def _lay_out(self) -> None:
        upper = QWidget()
        above = QVBoxLayout(upper)
        above.setContentsMargins(0, 0, 0, 0)
        above.setSpacing(UNIT)
        above.addWidget(self.panel, 1)
        above.addWidget(self.favourites_panel)
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
        column.chooser.chosen.connect(self.opener.receive)
        column.chooser.released.connect(lambda one: edits.remove_icon(document, one.id))
        column.pick.requested.connect(self.pick)
        cards.pinned.connect(lambda icon, pins: edits.set_pins(document, icon, pins))
        cards.removed.connect(lambda icon: edits.remove_icon(document, icon))
        cards.dropped.connect(self.opener.open_mime)
        column.symmetry.chosen.connect(lambda axis: edits.set_symmetry(document, axis))
        column.offer.clicked.connect(
            lambda: edits.set_symmetry(document, edits.shared_axis(document.page))
        )
        column.seed.changed.connect(lambda seed: edits.set_seed(document, seed))
        column.run.clicked.connect(self.run)
        panel = self.favourites_panel
        panel.changed.connect(
            lambda: edits.set_favourites(document, tuple(one.icon for one in panel.pictures))
        )
        panel.save_all.connect(self.actions_by_name["save_all"].trigger)

    def _wire_work(self) -> None:
        sheet, panel, detail = self.sheet, self.panel, self.detail
        for runner in (self.draws.runner, self.opener.runner):
            runner.progress.connect(self.progressed)
            runner.ended.connect(self._rest)
        self.draws.runner.failed.connect(self.failed)
        self.draws.counted.connect(self.counted)
        self.draws.section_changed.connect(panel.show_section)
        self.draws.section_changed.connect(lambda _: self._rest())
        self.connect_opener(self.opener)
        self.opener.shown.connect(self.run)
        sheet.picked.connect(self._look_at)
        sheet.chosen.connect(self.kept)
        panel.bar.favourite.connect(self.keep)
        panel.bar.like.connect(self.draw_like)
        sheet.asked.connect(self._open_menu)
        panel.back.connect(self.draws.show_all)
        self.favourites_panel.picked.connect(self._look_at)
        self.favourites_panel.picked.connect(self.kept)
        detail.sent.connect(lambda title: self.send_picture(detail.picture, title))
        self.connect_detail(detail)

    # -- what the window asks for --------------------------------------------------------------

    @property
    def picture(self) -> Picture | None:
        """The picked hybrid."""
        return self.detail.picture

    @property
    def icons(self) -> tuple[Pictogram, ...]:
        """The icons to be mixed."""
        return self.document.page.mix.icons

    def enter(self) -> None:
        """Begin with looking icons up, or go on at the sheet."""
        (self.sheet if self.sections.all else self.column.chooser).setFocus()

    def take(self, pictogram: Pictogram) -> None:
        """Mix an icon that was sent or dropped here."""
        self.opener.take(pictogram)

    def set_destinations(self, destinations: tuple[Destination, ...]) -> None:
        """Say where hybrids can be sent to."""
        self._destinations = tuple(one for one in destinations if one.title != self.workflow.title)
        self.detail.set_destinations(self._destinations)

    def cancel(self) -> None:
        """Stop drawing and picking; hybrids that are finished stay."""
        self.opener.runner.cancel()
        self.draws.runner.cancel()

    # -- mixing --------------------------------------------------------------------------------

    def run(self) -> None:
        """Draw hybrids of the icons: a new sheet, or more of them if nothing has changed."""
        page = self.document.page
        problem = edits.problem(page.mix)
        if problem:
            self.hinted.emit(problem)
            return
        self.remarked.emit("")
        self.draws.start(page.mix, page.title)
        self.panel.show_welcome(False)
        self._show_page(page)

    def draw_like(self, picture: Picture) -> None:
        """Draw hybrids that resemble one."""
        try:
            self.draws.draw_like(picture)
        except IconstudioError as error:
            self.failed.emit(str(error))

    def pick(self, count: int) -> None:
        """Let the program pick icons of the word that is looked up; once more, the next best."""
        keyword = self.column.chooser.field.text().strip()
        if keyword:
            self.remarked.emit("")
            self.opener.pick(keyword, count)
        else:
            self.hinted.emit("Type what the icons should show, for example “lamp”.")
            self.column.chooser.setFocus()

    def _rest(self) -> None:
        hybrids = self.sections
        if not (self.draws.runner.running or self.opener.runner.running):
            count, total = (len(some) for some in (hybrids.in_sight, hybrids.pictures))
            others = f" · {total} with the others" if total > count else ""
            self.idle.emit(f"{count} hybrids{others}" if count else "")

    # -- looking at results --------------------------------------------------------------------

    def keep(self, picture: Picture) -> None:
        """Make a hybrid a favourite, or no longer."""
        favourites = self.document.page.favourites
        left = tuple(one for one in favourites if not one.looks_like(picture.icon))
        added = left == favourites
        edits.set_favourites(self.document, (*left, picture.icon) if added else left)
        if added:
            self.kept.emit(picture)

    def _look_at(self, picture: Picture) -> None:
        self.detail.show_picture(picture)
        self.detail.explain(terms(picture))
        for name in ("favourite", "like"):
            self.actions_by_name[name].setEnabled(True)
        self.picked.emit(picture)

    def _open_menu(self, picture: Picture, spot: QPoint) -> None:
        menu = QMenu(self)
        menu.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        menu.addActions([self.actions_by_name[name] for name in ("favourite", "like")])
        menu.addSeparator()
        offer(menu, self._destinations, lambda title: self.send_picture(picture, title))
        menu.addAction(self.actions_by_name["svg"])
        self.menu = menu
        menu.popup(spot)

    # -- page ----------------------------------------------------------------------------------

    def _show_page(self, page: HybridsPage) -> None:
        if not page.ids and self.draws.ran is not None:
            self._clear_sheet()
        self.column.show_page(page, edits.shared_axis(page) if page.symmetry is None else None)
        favourites = tuple(picture_of(one, CODED) for one in page.favourites)
        if self.favourites_panel.pictures != favourites:
            self.favourites_panel.icon_list.show_entries(favourites)
        kept = page.favourites
        self.sheet.model().mark(lambda one: any(icon.looks_like(one.icon) for icon in kept))
        mix = page.mix
        stale = self.draws.ran is not None and self.draws.ran != mix
        self.panel.note.setText("of an earlier mix – press Mix to renew" if stale else "")
        problem = edits.problem(mix)
        self.column.run.setEnabled(not problem)
        self.column.run.setToolTip(problem or "Draw hybrids of the icons (Ctrl+Return)")
        for name, there in (("clear", page.ids), ("save", page.ids), ("save_all", page.favourites)):
            self.actions_by_name[name].setEnabled(bool(there))

    def _clear_sheet(self) -> None:
        """Leave the hybrids behind: nothing of what they are of is there any more."""
        self.draws.clear()
        self.panel.show_welcome(True)
        self.detail.show_picture(None)
        for name in ("favourite", "like"):
            self.actions_by_name[name].setEnabled(False)
        self.picked.emit(None)
        self._rest()

    def _save(self) -> None:
        page = self.document.page
        mix, name = page.mix, page.name or None
        self.saver.save_work(
            "mix", page.title, lambda path: write_file(path, self.workflow, mix, title=name)
        )
