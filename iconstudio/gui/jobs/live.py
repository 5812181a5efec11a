"""Runs that follow the hand: of many requests, only the newest is met."""

from collections.abc import Callable, Generator
from typing import Any

from PySide6.QtCore import QObject, QTimer, Signal

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

    Parameters
    ----------
    make
        Returns the run for a request, which is any immutable value; in the worker's thread.

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
    ) -> None:
        super().__init__(worker, parent)
        self._make = make
        self._pending: Any = None
        self.ran: Any = None
        """What runs, or was finished last; None if it came to no end."""
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
        self._pending = request
        if not self.holding:
            self._go_on()

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
        make, self.ran = self._make, request
        self.start(lambda: make(request))
        self.began.emit(request)

    def _tell(self, event: object) -> None:
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
            self.release()
