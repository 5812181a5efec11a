"""The best of several seeds (beyond the paper)."""

from collections.abc import Callable, Iterator
from dataclasses import replace

import numpy as np

from iconstudio.algorithms.patterns.exemplar import Pattern
from iconstudio.algorithms.patterns.prepared import Prepared
from iconstudio.algorithms.patterns.synthesis import Settings, synthesised

_WHOLE = 0.02
"""Where less of the ink is torn, hardly anybody sees it."""


def best(
    prepared: Prepared, settings: Settings, count: int, ask: Callable[[], None] = lambda: None
) -> Iterator[Pattern]:
    """Give the best pattern so far of at most ``count`` seeds, that of the settings the first.

    The better has less torn ink; of two with as much, the lower energy. Once hardly anything is
    torn, no further seed is tried.
    """
    least: tuple[float, float] | None = None
    for seed in (settings.seed, *np.random.SeedSequence(settings.seed).generate_state(count - 1)):
        *_, pattern = synthesised(prepared, replace(settings, seed=int(seed)), ask)
        if least is None or (pattern.torn, pattern.energy) < least:
            least = pattern.torn, pattern.energy
            yield pattern
        if pattern.torn < _WHOLE:
            return
