import pytest

from iconstudio.model import Remix
from tests.output.made import made, quarters


@pytest.fixture(scope="session")
def result() -> Remix:
    return made(quarters())
