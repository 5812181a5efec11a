"""The grid of results over the details of the one that is picked."""

from PySide6.QtCore import Qt, Signal
from PySide6.QtWidgets import QSplitter

from iconstudio.gui.gallery.detail import DetailPanel
from iconstudio.gui.gallery.results import ResultsPanel
from iconstudio.gui.gallery.tidiness import setting, shown
from iconstudio.gui.pictures.picture import Picture
from iconstudio.gui.theme.theme import UNIT
from iconstudio.workflows.events import Event, Recommended, StyleMatched, StyleSkipped
from iconstudio.workflows.grid import GridSettings


class ResultsBrowser(QSplitter):
    """Shows the events of a run as they come: results by style and lambda_S.

    The first result of an object is picked, and stays so while the run goes on; when its first run
    is over, the best is picked, once. Then the pick stays in its cell until the user picks another.

    Signals
    -------
    kept(Picture)
        A result worth keeping: picked by the user, or recommended by the run.
    counted(int)
        How many results are there.
    """

    kept = Signal(object)
    counted = Signal(int)

    def __init__(self, welcome: str, nearer: str) -> None:
        """For the words, see ``ResultsPanel``."""
        super().__init__(Qt.Orientation.Vertical)
        self.results = ResultsPanel(welcome, nearer)
        self.detail = DetailPanel()
        self._settled = False
        self._owed = False  # the finished result of a preview that the user picked
        self._recommended: dict[str, Picture] = {}
        self.addWidget(self.results)
        self.addWidget(self.detail)
        self.setSizes([400, 210])
        self.setHandleWidth(UNIT)
        self.setChildrenCollapsible(False)
        self.setStretchFactor(0, 3)
        self.setStretchFactor(1, 1)
        results = self.results
        results.picked.connect(self._show)
        results.aged.connect(self._show_age)
        results.chosen.connect(self._choose)
        setting.changed.connect(self._renew_tidiness)

    def begin(self, settings: GridSettings, afresh: bool = True) -> None:
        """Make room for the results of a new run.

        ``afresh``: nothing that is there is of the same object. Otherwise it stays in sight until
        it is replaced.
        """
        self._recommended = {}
        if afresh:
            self._settled = False
            self.results.clear()
        self.results.begin(settings.styles, settings.lambdas)

    def clear(self) -> None:
        """Let go of all results."""
        self._recommended = {}
        self._settled = self._owed = False
        self.results.clear()
        self.counted.emit(0)

    def show_event(self, event: Event | Picture) -> None:
        """Show what a run has come to."""
        match event:
            case StyleMatched():
                self.results.show_matched(event)
            case StyleSkipped():
                self.results.show_skipped(event)
            case Recommended():
                self._recommend(event)
            case Picture():
                self._add(shown(event))

    def end(self, whole: bool = True, keep: bool = True) -> None:
        """Nothing more is to come; ``keep`` the best result in sight."""
        self.results.end()
        best = max(self._recommended.values(), key=_score, default=None)
        focus, first = self.results.focus, whole and not self._settled
        hidden = focus is not None and self.results.skipped(focus[0])
        if best is not None and (first or hidden):
            self._pick(best)
        self._settled = self._settled or (whole and best is not None)
        if keep and self.results.finished:
            self.kept.emit(best or self.detail.picture)

    def _show(self, picture: Picture | None) -> None:
        self.detail.show_picture(picture)
        self._show_age()

    def _show_age(self) -> None:
        """Let the large picture be as pale as the same one in the grid."""
        if (cell := self.results.picked_cell) is not None:
            self.detail.large.paling.match(cell.paling)

    def _renew_tidiness(self) -> None:
        self._recommended = {style: shown(one) for style, one in self._recommended.items()}
        self.results.renew_tidiness()

    def _add(self, picture: Picture) -> None:
        if not self.results.add(picture):
            return
        self.counted.emit(self.results.finished)
        style, _ = place = _place(picture)
        if style in self._recommended and place == _place(self._recommended[style]):
            self._recommended[style] = picture  # a symmetric one is in its place
        if self.detail.picture is None:
            self._pick(picture)
        if self._owed and picture is self.detail.picture:
            self._keep(picture)

    def _recommend(self, event: Recommended) -> None:
        self.results.recommend(event.style, event.lambda_s)
        if event.lambda_s is not None:
            self._recommended[event.style] = self.results.coming(event.style, event.lambda_s)

    def _pick(self, picture: Picture) -> None:
        self.results.pick(*_place(picture))

    def _choose(self, picture: Picture) -> None:
        self._settled = True
        self._keep(picture)

    def _keep(self, picture: Picture) -> None:
        self._owed = picture.preview
        if not self._owed:
            self.kept.emit(picture)


def _place(picture: Picture) -> tuple[str, float]:
    return picture.icon.composite.style, picture.icon.composite.lambda_s


def _score(picture: Picture) -> float:
    return picture.icon.score.total
