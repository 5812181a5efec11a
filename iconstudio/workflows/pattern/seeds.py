"""Patterns of several seeds."""

from dataclasses import replace

from iconstudio.model import Patterning
from iconstudio.workflows.pattern.bounds import LARGEST_SEED


def with_seeds(work: Patterning, count: int) -> tuple[Patterning, ...]:
    """Return some work with its own seed, and with those that follow it."""
    seeds = ((work.seed + number) % (LARGEST_SEED + 1) for number in range(count))
    return tuple(replace(work, seed=seed) for seed in seeds)
