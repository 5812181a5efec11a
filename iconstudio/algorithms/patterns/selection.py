"""The best of several seeds (beyond the paper)."""

from collections.abc import Callable, Iterator
from dataclasses import replace

from iconstudio.algorithms.patterns.exemplar import Pattern
from iconstudio.algorithms.patterns.prepared import Prepared
from iconstudio.algorithms.patterns.synthesis import Settings, synthesised


def best(
    prepared: Prepared, settings: Settings, count: int, ask: Callable[[], None] = lambda: None
) -> Iterator[Pattern]:
    """Give the best pattern so far of ``count`` seeds, from that of the settings on.

    The better has less torn ink; of two with as much, the lower energy.
    """
    least: tuple[float, float] | None = None
    for seed in range(settings.seed, settings.seed + count):
        *_, pattern = synthesised(prepared, replace(settings, seed=seed), ask)
        if least is None or (pattern.torn, pattern.energy) < least:
            least = pattern.torn, pattern.energy
            yield pattern
