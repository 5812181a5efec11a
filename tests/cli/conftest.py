"""Commands run in the process of the tests, one after the other, on the same worker processes."""

import pytest

from iconstudio.workers import Workers


class LastingWorkers(Workers):
    """Their processes outlive a session that closes them, which still ends what they do for it."""

    def close(self) -> None:
        for lane in self._lanes:
            for task in tuple(lane._unsettled):
                task.cancel()

    def end(self) -> None:
        super().close()


@pytest.fixture(scope="session")
def lasting_workers():
    """Return a function that takes the place of ``Workers``."""
    made = {}

    def workers(count=None):
        if count not in made:
            made[count] = LastingWorkers(count)
        return made[count]

    yield workers
    for pool in made.values():
        pool.end()


@pytest.fixture(scope="module", autouse=True)
def sessions_share_workers(lasting_workers):
    """What a command leaves behind is tested where a program of its own is started."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr("iconstudio.session.Workers", lasting_workers)
        patch.setattr("iconstudio.reading.Workers", lasting_workers)
        yield
