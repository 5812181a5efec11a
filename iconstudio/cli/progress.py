"""A progress bar on a terminal; nothing elsewhere."""

import sys
from types import TracebackType

from tqdm import tqdm

from iconstudio.workflows.estimating import spoken


class ProgressBar:
    """One bar on standard error for all stages, each named beside it."""

    def __init__(self) -> None:
        tqdm.monitor_interval = 0  # no thread that outlives the bar
        self._bar = tqdm(
            total=100,
            disable=not sys.stderr.isatty(),
            leave=False,
            bar_format="{desc:<28} {percentage:3.0f}% |{bar}| {elapsed}{postfix}",
        )

    def show(self, done: float, message: str, remaining: float | None = None) -> None:
        """Show that ``done`` (0 to 1) of what ``message`` names is over.

        ``remaining`` are the seconds until all is over, if that can be told.
        """
        self._bar.set_description_str(message, refresh=False)
        self._bar.set_postfix_str("" if remaining is None else spoken(remaining), refresh=False)
        self._bar.n = 100 * done
        self._bar.refresh()

    def say(self, sentence: str) -> None:
        """Print a sentence on standard error without disturbing the bar."""
        self._bar.write(sentence, file=sys.stderr)

    def __enter__(self) -> "ProgressBar":
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        trace: TracebackType | None,
    ) -> None:
        self._bar.close()
