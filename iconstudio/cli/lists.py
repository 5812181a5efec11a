"""Options that take several values: with commas, with spaces, or by giving the option again."""

from collections.abc import Callable
from typing import Any

import click


class Words(click.ParamType):  # type: ignore[type-arg]  # generic only since Click 8.5
    """Words of a list."""

    name = "names"

    def split(self, value: object) -> list[str]:
        """Return the words of ``a,b c``."""
        return str(value).replace(",", " ").split()

    def convert(
        self, value: Any, param: click.Parameter | None, ctx: click.Context | None
    ) -> tuple[Any, ...]:
        """Read ``a,b`` as ("a", "b")."""
        if isinstance(value, tuple):
            return value
        words = self.split(value)
        if not words:
            self.fail("give a name, or leave the option out", param, ctx)
        return tuple(words)


class Numbers(Words):
    """Positive numbers of a list."""

    name = "numbers"

    def __init__(self, largest: float) -> None:
        self.largest = largest

    def convert(
        self, value: Any, param: click.Parameter | None, ctx: click.Context | None
    ) -> tuple[float, ...]:
        """Read ``0.1,0.3`` as (0.1, 0.3)."""
        if isinstance(value, tuple):
            return value
        words = self.split(value)
        if not words or not all(map(is_number, words)):
            self.fail(f"{value!r} is no list of numbers such as 0.1,0.3", param, ctx)
        numbers = tuple(map(float, words))
        if not all(0 < number <= self.largest for number in numbers):
            self.fail(f"give numbers above 0 and up to {self.largest:g}", param, ctx)
        return numbers


def is_number(word: str) -> bool:
    """Whether a word can be read as a number."""
    try:
        float(word)
    except ValueError:
        return False
    return True


class ListCommand(click.Command):
    """A command of which some options go on over the words that follow, as in ``--styles a b``.

    ``goes_on`` names them, each with the test that a word must pass to belong to the list.
    """

    def __init__(self, *args: Any, goes_on: dict[str, Callable[[str], bool]], **kwargs: Any):
        super().__init__(*args, **kwargs)
        self._goes_on = goes_on

    def parse_args(self, ctx: click.Context, args: list[str]) -> list[str]:
        """Join the words of each list with commas before click sees them."""
        joined: list[str] = []
        belongs: Callable[[str], bool] | None = None
        for word in args:
            if belongs is not None and joined[-1] not in self._goes_on and belongs(word):
                joined[-1] += f",{word}"
                continue
            joined.append(word)
            if word in self._goes_on:
                belongs = self._goes_on[word]
            elif len(joined) < 2 or joined[-2] not in self._goes_on:
                belongs = None
        return super().parse_args(ctx, joined)


def flat(values: tuple[tuple[Any, ...], ...]) -> tuple[Any, ...]:
    """Return the values of an option that was given several times as one list."""
    return tuple(value for part in values for value in part)
