import pytest

from iconstudio.workflows.events import Result
from tests.output.made import made, quarters


@pytest.fixture(scope="session")
def result() -> Result:
    return made(quarters())
