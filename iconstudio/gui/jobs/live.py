"""Runs that follow the hand: of many requests, only the newest is met."""

from collections.abc import Callable, Generator
from typing import Any

from PySide6.QtCore import QObject, QTimer, Signal

from iconstudio.caches.kept import KEPT, Kept
from iconstudio.gui.jobs.runner import Runner
from iconstudio.gui.jobs.worker import Worker
from iconstudio.workflows.events import Progress

PATIENCE = 700
"""Milliseconds that a run which is out of date may take until it shows something."""

CALM = 800
"""Milliseconds that a run may take before its progress is shown: those that the next movement of
the hand puts an end to are shorter."""


class LiveRunner(Runner):
    """Runs what is wanted, which changes faster than it can be made.

    A run that has become out of date is still owed something to show: were it dropped at once, a
    hand that never rests would see nothing at all. So what is wanted meanwhile waits until the run
    has shown something (``release``) or is over, but no longer than ``patience`` milliseconds since
    its start.

    What a request comes to depends on the request alone. So what whole runs have yielded is kept
    for a while, and a request that returns, by undo for example, is met at once, by that.

    Parameters
    ----------
    make
        Returns the run for a request, which is any immutable value; in the worker's thread.
    kept
        How many events are kept at most of runs that came to their end.

    Signals
    -------
    began(object)
        A run starts, for that request.
    """

    began = Signal(object)

    def __init__(
        self,
        worker: Worker,
        make: Callable[[Any], Generator[Any]],
        parent: QObject | None = None,
        patience: int = PATIENCE,
        kept: int = KEPT,
    ) -> None:
        super().__init__(worker, parent)
        self._make = make
        self._pending: Any = None
        self.ran: Any = None
        """What runs, or was finished last; None if it came to no end."""
        self._kept: Kept[list[Any]] = Kept(kept)
        self._events: list[Any] = []
        self.timer = QTimer(self, singleShot=True, interval=patience)
        self.timer.timeout.connect(self._go_on)
        self._calm = QTimer(self, singleShot=True, interval=CALM)
        self.ended.connect(self._rest)

    @property
    def pending(self) -> bool:
        """Whether something newer is wanted than what runs."""
        return self._pending is not None

    @property
    def holding(self) -> bool:
        """Whether the run under way is still waited for."""
        return self.timer.isActive()

    def request(self, request: Any) -> None:
        """Run this as soon as may be, unless it is what runs or ran last."""
        if request == self.ran:
            self.discard()
            return
        if self.recall(request):
            return
        self._pending = request
        if not self.holding:
            self._go_on()

    def recall(self, request: Any) -> bool:
        """Tell at once what a request came to if that is known, in place of what runs.

        Returns
        -------
        Whether it is. ``ended`` comes once then, also for what ran.
        """
        events = self.known(request)
        if events is None:
            return False
        self._drop()
        self.discard()
        self.ran, self._events = request, events
        self.began.emit(request)
        for event in events:
            self.event.emit(event)
        self.ended.emit(True)
        return True

    def known(self, request: Any) -> list[Any] | None:
        """Return the events of a request, if they are kept."""
        return self._kept.find(request)

    def keep(self, request: Any, events: list[Any]) -> None:
        """Keep what a request has come to; what was not wanted for longest is left out for it."""
        self._kept.put(request, events)

    def run(self, request: Any) -> None:
        """Run this now, because the user asks for it; he sees its progress."""
        self.discard()
        self._calm.stop()
        self._begin(request)

    def release(self) -> None:
        """The run under way has shown something: whatever is newer need not wait for it."""
        self.timer.stop()
        self._go_on()

    def discard(self) -> None:
        """Want nothing else than what runs."""
        self._pending = None

    def cancel(self) -> None:
        """Stop, and want nothing."""
        self.discard()
        self.ran = None
        super().cancel()

    def _go_on(self) -> None:
        request = self._pending
        if request is not None:
            self.discard()
            self.timer.start()
            self._calm.start()
            self._begin(request)

    def _begin(self, request: Any) -> None:
        make, self.ran, self._events = self._make, request, []
        self.start(lambda: make(request))
        self.began.emit(request)

    def _tell(self, event: object) -> None:
        if not isinstance(event, Progress):
            self._events.append(event)
        if not (isinstance(event, Progress) and self._calm.isActive()):
            super()._tell(event)

    def _fail(self, message: str) -> None:
        self._whole = False
        if not self.pending:
            self.failed.emit(message)

    def _rest(self, whole: bool) -> None:
        if not self.running:
            self._calm.stop()
            if not whole:
                self.ran = None
            elif self._events:
                self.keep(self.ran, self._events)
            self.release()
