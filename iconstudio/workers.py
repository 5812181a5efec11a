"""Worker processes that can be killed: the adapter of pebble.

A renderer may crash or hang on a hostile SVG, and PyMaxflow holds the
interpreter lock during a cut; neither may stop the window. So both run in
worker processes, and whoever waits for them holds a future.
"""

import multiprocessing
import os
from collections.abc import Callable
from concurrent.futures import Future
from typing import Any


class Workers:
    """A pool of processes. Functions and arguments must be picklable (module-level functions).

    Processes start on first use and end with ``close``, or at the end of the ``with`` block.
    """

    def __init__(self, count: int | None = None) -> None:
        self.count = count or max(1, os.cpu_count() or 1)
        self._pool: Any = None

    def submit(
        self, function: Callable[..., Any], *args: Any, timeout: float | None = None
    ) -> "Future[Any]":
        """Run ``function(*args)`` in a worker.

        ``future.cancel()`` kills it, also while it runs. The future raises ``TimeoutError`` after
        ``timeout`` seconds, and ``pebble.ProcessExpired`` if the process died.
        """
        if self._pool is None:
            from pebble import ProcessPool

            # spawn: forking a process that runs Qt and FFTW threads is not safe.
            self._pool = ProcessPool(
                max_workers=self.count, context=multiprocessing.get_context("spawn")
            )
        return self._pool.schedule(function, args=args, timeout=timeout)

    def close(self) -> None:
        """Kill the processes and wait until they have ended."""
        pool, self._pool = self._pool, None
        if pool is not None:
            pool.stop()
            pool.join()

    def __enter__(self) -> "Workers":
        return self

    def __exit__(self, *exc: object) -> None:
        self.close()
