"""The adapter of Dask (``dask.distributed``): calls functions in the processes of a cluster.

On its machines this program must be installed, and nothing else be set up. Dask gives the task of a
process that dies to another one; one that several processes died of is given up.
"""

import asyncio
import logging
from collections.abc import Callable
from concurrent.futures import CancelledError, Future, InvalidStateError
from contextlib import AbstractContextManager, suppress
from time import monotonic
from typing import Any

from iconstudio import __version__
from iconstudio.model import IconstudioError
from iconstudio.workers import ProcessDied

SECONDS = 10.0
"""How long the scheduler has to answer, and workers to be there."""
_CLOSING = 5.0
_RECOUNT = 5.0
"""Seconds after which workers are counted again."""
_MISSING = (
    "To hand work to a cluster, Dask is needed, and it is not installed. "
    'Install it: pip install "iconstudio[cluster]"'
)


class DisconnectedError(IconstudioError):
    """The scheduler is gone."""

    def __init__(self, address: str) -> None:
        super().__init__(
            f"The Dask scheduler at “{address}” does not answer any more. Start it anew, and give "
            "the same command again: it goes on where it was."
        )


class Cluster(AbstractContextManager["Cluster"]):
    """A Dask cluster, by the address of its scheduler: ``tcp://HOST:8786``, say.

    Raises
    ------
    IconstudioError
        If Dask is missing, no scheduler answers, or it has no workers.
    """

    def __init__(self, address: str, seconds: float = SECONDS) -> None:
        try:
            from distributed import Client
        except ImportError:
            raise IconstudioError(_MISSING) from None
        self._address = address[:200]
        self._count, self._counted = 0, -_RECOUNT
        for name in tuple(logging.root.manager.loggerDict):
            if name.partition(".")[0] == "distributed":  # this program says what is to be known
                logging.getLogger(name).setLevel(logging.CRITICAL + 1)
        try:
            asyncio.run(asyncio.wait_for(_greet(address), seconds))
            self._client = Client(address, timeout=seconds, set_as_default=False)
        except Exception as error:  # whatever an address that is none leads to
            raise IconstudioError(
                f"No Dask scheduler answers at “{self._address}”. Start one with “dask scheduler”, "
                "and give the address that it prints, such as tcp://192.168.0.7:8786."
            ) from error
        try:
            self._client.wait_for_workers(1, timeout=seconds)
        except Exception as error:
            self.close()
            raise IconstudioError(
                f"The Dask scheduler at “{self._address}” has no workers. Start some: "
                f"“dask worker {self._address} --nworkers -1 --nthreads 1”, "
                f"where Iconstudio {__version__} is installed."
            ) from error

    @property
    def count(self) -> int:
        """How many tasks run at a time: workers may come and go."""
        if monotonic() - self._counted > _RECOUNT:
            try:
                self._count = sum(self._client.nthreads().values())
            except Exception as error:
                raise DisconnectedError(self._address) from error
            self._counted = monotonic()
        return self._count

    def submit(self, function: Callable[..., Any], *args: object) -> "Future[Any]":
        """Call a function of a module of this program in some process.

        The future raises what the function did; ``ProcessDied`` if the processes died of it, and
        ``DisconnectedError`` if the scheduler is gone.
        """
        task = self._client.submit(_call, __version__, function, args, pure=False)
        future: Future[Any] = Future()
        future.add_done_callback(lambda one: task.cancel() if one.cancelled() else None)
        task.add_done_callback(lambda one: _settle(future, one, self._address))
        return future

    def close(self) -> None:
        """Let go of the scheduler; what it still works on is cancelled."""
        self._client.close(timeout=_CLOSING)

    def __exit__(self, *exc: object) -> None:
        self.close()


async def _greet(address: str) -> None:
    """Ask a scheduler who it is: Dask's client waits for ever for what is none, and cannot end."""
    from distributed.comm.core import connect

    comm = await connect(address)
    try:
        await comm.write({"op": "identity", "reply": True})
        await comm.read()
    finally:
        comm.abort()


def _call(version: str, function: Callable[..., Any], args: tuple[object, ...]) -> Any:
    """Call a function in a worker of the cluster."""
    if version != __version__:
        raise ImportError(f"Iconstudio {__version__} instead of {version}")
    return function(*args)


def _settle(future: "Future[Any]", task: Any, address: str) -> None:
    """Give a future what has become of a task of Dask."""
    from distributed.scheduler import KilledWorker

    with suppress(InvalidStateError):  # it was cancelled meanwhile
        try:
            future.set_result(task.result())
        except KilledWorker:
            future.set_exception(ProcessDied(None))
        except CancelledError:
            future.set_exception(DisconnectedError(address))
        except Exception as error:
            future.set_exception(error)
    task.release()  # nothing of it is kept in the cluster
