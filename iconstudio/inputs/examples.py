"""The examples that come with the program: files like the user's own, each with a title."""

from dataclasses import dataclass
from pathlib import Path

from iconstudio.inputs import json
from iconstudio.inputs.formats import Record, Text
from iconstudio.resources import resource


@dataclass(frozen=True, slots=True)
class Example:
    """A file of work to begin with, and what it shows."""

    title: str
    path: Path


class _Titled(Record, frozen=True):
    title: Text = ""


def examples(folder: str) -> list[Example]:
    """Return the examples in a folder of ``resources/examples``, by title; "" has the sketches."""
    files = (resource("examples") / folder).glob("*.json")
    some = (Example(json.read(file, _Titled).title or file.stem, file) for file in files)
    return sorted(some, key=lambda example: example.title)
