"""The examples that come with the program: files like the user's own, each with a title."""

from dataclasses import dataclass
from pathlib import Path

from iconstudio.inputs.fields import read
from iconstudio.resources import resource


@dataclass(frozen=True, slots=True)
class Example:
    """A file of work to begin with, and what it shows."""

    title: str
    path: Path


def examples(folder: str) -> list[Example]:
    """Return the examples in a folder of ``resources/examples``, by title; "" has the sketches."""
    files = (resource("examples") / folder).glob("*.json")
    some = (Example(read(file).text("title") or file.stem, file) for file in files)
    return sorted(some, key=lambda example: example.title)
