"""Several things that are opened together: each is read, or it is said why not."""

import logging
from collections.abc import Callable, Generator, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from iconstudio.grammar import joined
from iconstudio.inputs.items import Elsewhere, File, Item
from iconstudio.model import IconstudioError, SpriteError

log = logging.getLogger(__name__)

_NAMED = 3
"""So many things are called by their names; of the others, there are so and so many."""
_TOLD = 8
"""So many things are told one by one why they cannot be opened."""


@dataclass(frozen=True, slots=True)
class ReadTogether:
    """What was read: names, what is put on the page, and what could not be opened."""

    names: tuple[str, ...]
    found: tuple[Any, ...]
    complaints: tuple[str, ...] = ()


@dataclass(frozen=True, slots=True)
class Sprite:
    """A sprite sheet that was opened alone: the user chooses one of its symbols."""

    item: Item
    names: tuple[str, ...]


def read_together(
    items: Sequence[Item],
    read: Callable[[Item], Generator[None, None, Any]],
    most: int,
    no_room: Callable[[Sequence[str], Sequence[Item]], str],
) -> Generator[ReadTogether | Sprite | None]:
    """Read things, ``most`` at most, and yield them together; None in between.

    A single sprite sheet is yielded as such.

    ``no_room`` returns the sentence for the names that were taken, and what was left over.
    """
    names: list[str] = []
    found: list[Any] = []
    complaints: list[str] = []
    left: Sequence[Item] = ()
    for number, item in enumerate(items):
        if len(found) == most:
            left = items[number:]
            break
        try:
            _check(item)
            found.append((yield from read(item)))
            names.append(item.name)
        except SpriteError as error:
            if len(items) == 1:
                yield Sprite(item, error.names)
                return
            complaints.append(f"{error.what} Open it by itself to choose a symbol.")
        except IconstudioError as error:
            complaints.append(str(error))
        except Exception as error:  # the others are opened all the same
            log.exception("something could not be opened")
            complaints.append(f"“{item.name}” stopped the reader ({type(error).__name__}).")
        yield None  # a place to stop
    if len(complaints) > _TOLD:
        complaints[_TOLD:] = [f"{len(complaints) - _TOLD} more could not be opened."]
    if left:
        complaints.append(no_room(names, left))
    yield ReadTogether(tuple(names), tuple(found), tuple(complaints))


def quoted_list(things: Sequence[Item | str]) -> str:
    """Return the names of some things, the first ones of many, as words in a sentence."""
    names = [f"“{one if isinstance(one, str) else one.name}”" for one in things]
    if len(names) > _NAMED + 1:
        names[_NAMED:] = [f"{len(names) - _NAMED} more"]
    return joined(names)


def _check(item: Item) -> None:
    if isinstance(item, File) and Path(item.path).is_dir():
        raise IconstudioError(f"“{item.name}” is a folder. Open the files in it instead.")
    if isinstance(item, Elsewhere):
        raise IconstudioError(
            f"“{item.name}” was not opened: it is not on this computer. Save it as a file first."
        )
