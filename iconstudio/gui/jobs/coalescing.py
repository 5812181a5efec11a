"""Runs that follow the hand: of many requests, only the newest is met."""

from collections.abc import Callable

from PySide6.QtCore import QObject, QTimer

from iconstudio.gui.jobs.runner import Runner


class Coalescing(QObject):
    """Says when to run again while what is wanted changes faster than it can be made.

    A run that has become out of date is still owed something to show: were it dropped at once, a
    hand that never rests would see nothing at all. So what is wanted meanwhile waits until the run
    has shown something (``release``) or is over, but no longer than ``patience`` milliseconds since
    its start.

    Parameters
    ----------
    begin
        Starts ``runner`` with what is wanted at that moment.
    """

    def __init__(self, runner: Runner, begin: Callable[[], object], patience: int) -> None:
        super().__init__(runner)
        self._runner = runner
        self._begin = begin
        self.pending = False
        """Whether something newer is wanted than what runs."""
        self.timer = QTimer(self, singleShot=True, interval=patience)
        self.timer.timeout.connect(self._go_on)
        runner.ended.connect(self._end)

    @property
    def holding(self) -> bool:
        """Whether the run under way is still waited for."""
        return self.timer.isActive()

    def request(self) -> None:
        """Run again as soon as may be."""
        self.pending = True
        if not self.holding:
            self._go_on()

    def release(self) -> None:
        """The run under way has shown something: whatever is newer need not wait for it."""
        self.timer.stop()
        self._go_on()

    def discard(self) -> None:
        """Want nothing else than what runs."""
        self.pending = False

    def _go_on(self) -> None:
        if self.pending:
            self.pending = False
            self.timer.start()
            self._begin()

    def _end(self) -> None:
        if not self._runner.running:
            self.release()
