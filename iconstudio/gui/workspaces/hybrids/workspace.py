"""Pictogram hybrids (section 4.3): choose icons, mix them, scroll, keep what surprises."""

from pathlib import Path

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QMenu, QWidget

from iconstudio.grammar import counted
from iconstudio.gui.exchange.opening import Opener
from iconstudio.gui.gallery import tidiness
from iconstudio.gui.gallery.detail import DetailPanel
from iconstudio.gui.gallery.favourites import FavouritesPanel
from iconstudio.gui.pictures.picture import Picture, picture_of
from iconstudio.gui.theme.layout import column, row, splitter
from iconstudio.gui.workspaces.base import Workspace
from iconstudio.gui.workspaces.hybrids.actions import ENTRIES
from iconstudio.gui.workspaces.hybrids.drawing import CODED, Draws
from iconstudio.gui.workspaces.hybrids.panels import IconsColumn, SheetPanel
from iconstudio.importing.mixes import MixImporter
from iconstudio.inputs.together import ReadTogether
from iconstudio.model import Exemplar, IconstudioError, Pictogram
from iconstudio.workflows.hybrids import page as edits
from iconstudio.workflows.hybrids.page import HybridsPage


class HybridsWorkspace(Workspace):
    """Icons on the left; the sheet of hybrids, favourites and details on the right."""

    page_type = HybridsPage
    entries = ENTRIES
    sends_to_itself = False

    def build(self) -> None:
        """Make canvas, panels and runs."""
        self.importer = MixImporter(self.session, self.document)
        self.opener = Opener(self.importer, self.finder, self)
        self.column = IconsColumn(self.document, self.session, self.finder)
        self.panel = SheetPanel()
        self.sheet, self.sections = self.panel.sheet, self.panel.sections
        self.draws = Draws(self.session, self.worker, self.panel, self)
        self.favourites_panel = FavouritesPanel("Press F at a hybrid to keep it")
        self.detail = DetailPanel()
        self.make_actions()
        self.panel.start.setMenu(self.examples)
        above = QWidget()
        column((self.panel, 1), self.favourites_panel, of=above)
        right = splitter(Qt.Orientation.Vertical, (above, 420, 1), (self.detail, 190, 0))
        row(self.column, (right, 1), of=self)
        self._wire()
        self.show_page()

    def _wire(self) -> None:
        self.column.chooser.chosen.connect(self.add)
        self.column.cards.dropped.connect(self.opener.open_mime)
        self.column.pick.clicked.connect(self.pick)
        self.column.run.clicked.connect(self.run)
        self.follow(self.draws.runner, self.draws.show)
        self.follow(self.opener.runner)
        self.draws.counted.connect(self.counted)
        tidiness.setting.changed.connect(self._renew_tidiness)
        self.draws.section_changed.connect(self.rest)
        self.pick_from(self.sheet)
        self.pick_from(self.favourites_panel.icon_list)
        self.sheet.asked.connect(self.offer_for)
        self.panel.bar.favourite.connect(self.keep)
        self.panel.bar.like.connect(self.draw_like)
        self.favourites_panel.icon_list.changed.connect(self._note_favourites)
        self.favourites_panel.button.clicked.connect(self.save_all)

    # -- what the window asks for --------------------------------------------------------------

    @property
    def icons(self) -> tuple[Pictogram, ...]:
        """The icons to be mixed."""
        return self.page.mix.icons

    def enter(self) -> None:
        """Begin with looking icons up, or go on at the sheet."""
        (self.sheet if self.sections.all else self.column.chooser).setFocus()

    # -- mixing --------------------------------------------------------------------------------

    def run(self) -> None:
        """Draw hybrids of the icons: a new sheet, or more of them if nothing has changed."""
        page = self.page
        problem = edits.problem(page.mix)
        if problem:
            self.hinted.emit(problem)
            return
        self.remarked.emit("")
        self.draws.start(page.mix, page.title)
        self.panel.show_welcome(False)
        self.show_page()

    def open_example(self, path: Path) -> None:
        """Open the icons of an example, and mix them."""
        self.opener.replace(lambda: self.importer.opening(path, self.mix_example))

    def mix_example(self) -> None:
        """Draw the hybrids of an example, unless they are there from before."""
        if self.draws.ran != self.page.mix:
            self.run()

    def draw_like(self, picture: Picture) -> None:
        """Draw hybrids that resemble one."""
        try:
            self.draws.draw_like(picture)
        except IconstudioError as error:
            self.failed.emit(str(error))

    def add(self, icon: Exemplar) -> None:
        """Mix one more icon, which is drawn already."""
        self.opener.receive(ReadTogether((icon.id,), (icon,)))

    def pick(self) -> None:
        """Let the program pick icons of the word that is looked up; once more, the next best."""
        keyword = self.column.chooser.field.text().strip()
        if keyword:
            self.remarked.emit("")
            ask = edits.next_pick(self.page, keyword, self.column.count.value())
            self.opener.replace(lambda: self.importer.picking(ask))
        else:
            self.hinted.emit("Type what the icons should show, for example “lamp”.")
            self.column.chooser.setFocus()

    def outcome(self) -> str:
        """Return how many hybrids are in sight, and how many there are."""
        count, total = (len(some) for some in (self.sections.in_sight, self.sections.pictures))
        others = f" · {total} with the others" if total > count else ""
        return f"{counted(count, 'hybrid')}{others}" if count else ""

    # -- looking at results --------------------------------------------------------------------

    def keep(self, picture: Picture) -> None:
        """Make a hybrid a favourite, or no longer."""
        favourites = self.page.favourites
        left = tuple(one for one in favourites if not picture.shows(one))
        added = left == favourites
        edits.set_favourites(self.document, (*left, picture.icon) if added else left)
        if added:
            self.kept.emit(picture)

    def look_at(self, picture: Picture | None) -> None:
        """Pick a hybrid, and say what its rank is made of; or none."""
        if picture is not None:
            self.detail.explain(edits.terms(picture.icon.score))
        super().look_at(picture)

    def _renew_tidiness(self) -> None:
        if self.picture is not None:
            self.look_at(tidiness.shown(self.picture))

    def fill_result_menu(self, menu: QMenu, picture: Picture) -> None:
        """Say what can be done with a hybrid."""
        menu.addActions([self.actions_by_name[name] for name in ("favourite", "like")])
        menu.addSeparator()
        super().fill_result_menu(menu, picture)
        menu.addAction(self.actions_by_name["svg"])

    # -- page ----------------------------------------------------------------------------------

    def show_page(self) -> None:
        """Show what the page says."""
        page = self.page
        if not page.ids and self.draws.ran is not None:
            self._clear_sheet()
        elif self.draws.recall(page.mix, page.title):
            self.panel.show_welcome(False)
        self.column.show_page(page)
        favourites = tuple(picture_of(one, CODED) for one in page.favourites)
        if self.favourites_panel.pictures != favourites:
            self.favourites_panel.icon_list.show_entries(favourites)
        kept = page.favourites
        self.sheet.model().mark(lambda one: any(map(one.shows, kept)))
        mix = page.mix
        stale = self.draws.ran is not None and self.draws.ran != mix
        self.panel.note.setText("of an earlier mix – press Mix to renew" if stale else "")

    def _clear_sheet(self) -> None:
        """Leave the hybrids behind: nothing of what they are of is there any more."""
        self.draws.clear()
        self.panel.show_welcome(True)
        self.look_at(None)
        self.rest()

    def _note_favourites(self) -> None:
        pictures = self.favourites_panel.pictures
        edits.set_favourites(self.document, tuple(one.icon for one in pictures))

    # -- files ---------------------------------------------------------------------------------

    def clear(self) -> None:
        """Remove all icons."""
        edits.clear_icons(self.document)

    def save(self) -> None:
        """Write the mix into a file."""
        self.save_work(self.page.mix, self.page.title, title=self.page.name or None)

    def save_all(self) -> None:
        """Save all favourites as SVG."""
        self.saver.save_svgs(self.favourites_panel.pictures)
