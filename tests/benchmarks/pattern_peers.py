"""Patterns beside what people use: torn ink, seams of tiles, and seconds, on the same exemplars."""

import os
import statistics
import subprocess
import tempfile
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from pathlib import Path
from shutil import which
from typing import Any

import numpy as np
from numpy.typing import NDArray
from PIL import Image

from iconstudio.algorithms.patterns import quilting
from iconstudio.algorithms.patterns.energy import reduced
from iconstudio.algorithms.patterns.exemplar import Colours, Exemplar
from iconstudio.algorithms.patterns.prepared import Prepared
from iconstudio.algorithms.patterns.synthesis import Settings, _Synthesis, synthesised
from iconstudio.algorithms.patterns.torn import torn_ink
from tests.benchmarks.scale import say

SIZE = 256, 256
SEEDS = range(6)

Peer = Callable[[Exemplar, int], Colours]


@dataclass(frozen=True)
class Measured:
    """What a peer made of one exemplar and seed."""

    seconds: float
    """Of a processor."""
    torn: float
    ink: float
    """Over the exemplar's."""
    seam: float


def quilted(exemplar: Exemplar, seed: int) -> Colours:
    """Image quilting alone (Efros and Freeman, 2001), of colours, on a torus."""
    prepared = Prepared.of(exemplar, alpha=1.0)
    side = min(exemplar.colours.shape[:2]) * 3 // 8
    random = np.random.default_rng(seed)
    nowhere = np.zeros_like(prepared.solidity)
    source = quilting.quilted(prepared.channels, nowhere, SIZE, side, True, random)
    return exemplar.colours[source[..., 0], source[..., 1]]


class _TextureOptimisation(_Synthesis):
    """Texture optimisation (Kwatra et al., 2005): neither distances nor level sets."""

    colours: Colours

    def _expected(self, *args: Any) -> Any:
        return super()._expected(*args[:-1], False)

    def _finished(self, picture: Any, source: Any) -> Any:
        self.colours = self._weights.colours(picture)
        return super()._finished(picture, source)


def texture_optimised(exemplar: Exemplar, seed: int) -> Colours:
    """Texture optimisation with the start and the windows that ours has."""
    settings = Settings(SIZE, True, seed, mend=False)
    synthesis = _TextureOptimisation(Prepared.of(exemplar, alpha=1.0), settings, lambda: None)
    ours = Prepared.of(exemplar)

    def start(_: Any, shape: tuple[int, int], factor: int) -> Any:
        other = _Synthesis(ours, settings, lambda: None)
        return other._quilted(reduced(ours.channels, factor), shape, factor)

    synthesis._quilted = start  # type: ignore[method-assign]
    for _ in synthesis.run():
        pass
    return synthesis.colours


def gmic(exemplar: Exemplar, seed: int) -> Colours:
    """G'MIC's ``syntexturize_matchpatch``, with its usual settings; it makes no tiles."""
    with tempfile.TemporaryDirectory() as folder:
        given, made = Path(folder, "given.png"), Path(folder, "made.png")
        Image.fromarray(_levels(exemplar.colours)).save(given)
        width, height = SIZE[1], SIZE[0]
        command = ["gmic", "-v", "-", "-srand", str(seed), str(given)]
        command += ["-syntexturize_matchpatch", f"{width},{height}", "-o", str(made)]
        subprocess.run(command, check=True, capture_output=True)
        return np.asarray(Image.open(made).convert("RGB")) / np.float32(255)


def ours(exemplar: Exemplar, seed: int) -> Colours:
    """What the program makes."""
    *_, pattern = synthesised(Prepared.of(exemplar), Settings(SIZE, True, seed))
    return pattern.colours


def peers() -> dict[str, Peer]:
    """Return what there is on this machine."""
    known: dict[str, Peer] = {
        "image quilting": quilted,
        "texture optimisation": texture_optimised,
        "G'MIC": gmic,
        "ours": ours,
    }
    if which("gmic") is None:
        say("G'MIC is left out: there is no gmic on this machine.")
        del known["G'MIC"]
    return known


def measured(peer: Peer, exemplar: Exemplar, seed: int) -> Measured:
    """Run a peer, and look at its picture alone."""
    began = processor()
    colours = peer(exemplar, seed)
    seconds = processor() - began
    given, made = ink_of(exemplar.colours, exemplar), ink_of(colours, exemplar)
    torn = torn_ink(made, given, peer is not gmic)
    return Measured(seconds, torn, made.mean() / given.mean(), seam(colours))


def processor() -> float:
    """Return the seconds of a processor that this program, and those it ran, have taken."""
    times = os.times()
    return times.user + times.system + times.children_user + times.children_system


def ink_of(colours: Colours, exemplar: Exemplar) -> NDArray[np.bool_]:
    """Return (h, w), what is nearer to a colour of the exemplar's ink than to its ground."""
    inked = (exemplar.masks > 0.99).any(axis=0)
    ground = np.median(exemplar.colours[(exemplar.masks < 0.01).all(axis=0)], axis=0)
    palette = np.unique(np.round(exemplar.colours[inked], 2), axis=0)
    off = np.linalg.norm(colours - ground, axis=2)
    nearest = np.min([np.linalg.norm(colours - one, axis=2) for one in palette], axis=0)
    ink: NDArray[np.bool_] = nearest < off
    return ink


def seam(colours: Colours) -> float:
    """Return the mean jump across the borders of a picture, over that between its neighbours."""
    jumps = []
    for axis in (0, 1):
        there = abs(np.diff(colours, axis=axis)).mean()
        first, last = np.take(colours, 0, axis), np.take(colours, -1, axis)
        jumps.append(abs(first - last).mean() / max(there, 1e-6))
    return float(max(jumps))


def peers_table(exemplars: Mapping[str, Exemplar]) -> str:
    """Return the means of all peers over exemplars and seeds, and torn ink by exemplar."""
    names = list(exemplars)
    rows = [
        f"| | seconds | torn ink | ink | seam | {' | '.join(names)} |",
        f"| --- {'| --: ' * (4 + len(names))}|",
    ]
    for name, peer in peers().items():
        say(name)
        found = {
            one: [measured(peer, exemplar, seed) for seed in SEEDS]
            for one, exemplar in exemplars.items()
        }
        every = [each for some in found.values() for each in some]
        torn = " | ".join(f"{statistics.fmean(e.torn for e in found[one]):.2f}" for one in names)
        mean = {
            field: statistics.fmean(getattr(one, field) for one in every)
            for field in ("torn", "ink", "seam")
        }
        seconds = statistics.median(one.seconds for one in every)
        rows.append(
            f"| {name} | {seconds:.1f} | {mean['torn']:.3f} | {mean['ink']:.2f}"
            f" | {mean['seam']:.1f} | {torn} |"
        )
    return "\n".join(rows)


def _levels(colours: Colours) -> NDArray[np.uint8]:
    return np.rint(np.clip(colours, 0, 1) * 255).astype(np.uint8)
