"""Clicking a part of the picked result: alternatives come up, and one can be pinned."""

from collections.abc import Generator
from dataclasses import dataclass, replace

import numpy as np
from PySide6.QtCore import QObject, QPoint, Signal

from iconstudio.algorithms.raster import placed_ink
from iconstudio.gui.gallery.alternatives import AlternativesPopup
from iconstudio.gui.gallery.large import LargePicture
from iconstudio.gui.jobs.runner import Runner
from iconstudio.gui.jobs.worker import Worker
from iconstudio.gui.pictures.picture import Picture, picture_of
from iconstudio.model import Icon, Sketch
from iconstudio.session import Session
from iconstudio.workflows.events import Event
from iconstudio.workflows.modelling.alternatives import Tried, alternatives, trying
from iconstudio.workflows.modelling.page import SketchDocument, pin_part, unpin_part
from iconstudio.workflows.parts import Part
from iconstudio.workflows.pinning import PinnedPart, without_pins


@dataclass(frozen=True, slots=True)
class _Offered:
    """What could stand in the place of a part, and a picture of each for the time being."""

    choices: tuple[PinnedPart, ...]
    pictures: tuple[Picture, ...]


class PartAlternatives(QObject):
    """Offers alternatives for the parts of a result; what is chosen is pinned on the page.

    Signals
    -------
    changed()
        The user has pinned a part, or unpinned it.
    exchanged(Picture)
        In place of a result that stands for another one, the user wants this montage.
    """

    changed = Signal()
    exchanged = Signal(object)

    def __init__(
        self,
        session: Session,
        document: SketchDocument,
        worker: Worker,
        large: LargePicture,
        parent: QObject,
    ) -> None:
        super().__init__(parent)
        self._session, self._document = session, document
        self._part: Part | None = None
        self._choices: tuple[PinnedPart, ...] = ()
        self._pictures: dict[int, Picture] = {}
        self.popup = AlternativesPopup(large)
        self.runner = Runner(worker, self)
        """Finds and tries the alternatives; its ``failed`` may be listened to."""
        large.answers = True
        large.part_clicked.connect(self.offer)
        self.runner.event.connect(self._show)
        self.popup.chosen.connect(self._choose)
        self.popup.unpinned.connect(self._unpin)
        self.popup.closed.connect(self.runner.cancel)

    def offer(self, part: Part, spot: QPoint) -> None:
        """Offer what could stand in the place of a part, at a place of the screen."""
        sketch = self._document.page.sketch
        self._part, self._choices, self._pictures = part, (), {}
        pinned = len(without_pins(sketch.pins, part.ink, sketch.symmetry)) < len(sketch.pins)
        self.popup.ask(part.source.exemplar.name, pinned, spot, self._in_montage)
        self.runner.start(lambda: _offering(self._session, sketch, part))

    @property
    def _in_montage(self) -> bool:
        """Whether what is chosen becomes a montage: what is pinned takes no other's place."""
        return self._part is not None and self._part.icon.composite.stands_in

    def _show(self, event: Event | _Offered) -> None:
        match event:
            case _Offered(choices, pictures):
                self._choices, self._pictures = choices, dict(enumerate(pictures))
                if not choices:
                    self.popup.show_none()
                if self._in_montage:  # only what is there can be opened
                    self._pictures = {}
            case Tried(number, icon):
                name = self._choices[number].source.exemplar.name
                self._pictures[number] = picture_of(replace(icon, title=name))
            case _:
                return
        self.popup.show_pictures(self._pictures)

    def _choose(self, number: int) -> None:
        if self._in_montage:
            self.exchanged.emit(self._pictures[number])
        else:
            pin_part(self._document, self._choices[number])
            self.changed.emit()

    def _unpin(self) -> None:
        unpin_part(self._document, self._part.ink)
        self.changed.emit()


def _offering(session: Session, sketch: Sketch, part: Part) -> Generator[Event | _Offered]:
    """Yield what could stand in the place of a part, and then each as it is tried."""
    choices = alternatives(part)
    yield _Offered(choices, tuple(map(_placed, choices)))
    yield from trying(session, sketch, part.icon.composite, choices)


def _placed(choice: PinnedPart) -> Picture:
    """Return the picture of a whole icon where it lies."""
    from iconstudio.algorithms.tracing.vectorize import trace  # with SciPy: the window opens sooner

    ink, _ = placed_ink(choice.source.exemplar, choice.source.placement)
    path = trace(np.where(ink, np.uint8(255), np.uint8(0)))
    return picture_of(Icon(path, choice.source.exemplar.name))
