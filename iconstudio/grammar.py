"""Numbers and lists in sentences: what goes with one thing, and with several."""

from collections.abc import Sequence


def counted(count: int, noun: str) -> str:
    """Return a number of things in words: “1 icon”, “12 icons”."""
    return f"1 {noun}" if count == 1 else f"{count:,} {noun}s"


def was(things: Sequence[object]) -> str:
    """Return the verb that goes with the names of some things."""
    return "was" if len(things) == 1 else "were"


def joined(words: Sequence[str]) -> str:
    """Return some words, one at least, as a sentence has them: “a, b and c”."""
    return " and ".join(filter(None, (", ".join(words[:-1]), words[-1])))
