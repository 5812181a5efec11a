"""The paper's energies again, from nothing but the arrays of a dump."""

import math

import numpy as np
import pytest
from scipy import ndimage

from iconstudio.model import CANVAS


def prove_energies(dump, results):
    """Check a dump and the results of the report against equations 5 to 8, and 11."""
    ink, solid, interior = dump["ink"], dump["solid"], dump["interior"]
    assert np.array_equal(interior, solid & ~ink)
    m = int(dump["m"])
    assert {array.shape[-2:] for array in (ink, solid, dump["sketch"], dump["labels"])} == {(m, m)}
    target, used = tsdf(dump["sketch"]), np.unique(dump["labels"])
    data = np.full(solid.shape, np.nan)  # of what nobody owns
    data[used] = [abs(target - tsdf(solid[k])) for k in used]
    if "change" in dump:
        # Those of the icon, and of what shows nothing, tell what is removed and what is added.
        others = penalty(dump["change"], len(ink))[2:]
        np.testing.assert_allclose(dump["penalty"][2:], others, rtol=0, atol=1e-6)
        data += dump["penalty"]
    for labels, lambda_s, energy, result in zip(
        dump["labels"], dump["lambda_s"], dump["energy"], results, strict=True
    ):
        total = np.take_along_axis(data, labels[None].astype(int), 0).sum()
        smoothness = smoothness_cost(labels, ink, interior)
        assert result["m"] == m
        assert energy == pytest.approx(total + lambda_s * m / CANVAS * smoothness, rel=1e-4)
        assert result["energy"] == pytest.approx(energy)
        assert result["smoothness_cost"] == pytest.approx(smoothness, rel=1e-4)


def tsdf(shape):
    """Distances are in canvases, whatever the side of the canvas is."""
    edt, m = ndimage.distance_transform_edt, len(shape)
    reach = 6 * m // CANVAS
    return np.clip(edt(~shape) - edt(shape), -reach, reach) / CANVAS * (CANVAS / m)


def penalty(change, count):
    """Equation 11 with t = 25 and w_E = 0.1; label 0 is the icon that is edited."""
    mask = np.minimum(ndimage.distance_transform_edt(~change) / (25 * len(change) / CANVAS), 1)
    return 0.1 * np.stack([1 - mask] + [mask] * (count - 1))


def smoothness_cost(labels, ink, interior):
    padded = np.pad(ink, ((0, 0), (3, 3), (3, 3)))
    patches = np.lib.stride_tricks.sliding_window_view(padded, (7, 7), axis=(1, 2))
    cost = 0.0
    for dy, dx in ((0, 1), (1, 0)):
        m = len(labels)
        here, there = labels[: m - dy, : m - dx], labels[dy:, dx:]
        for y, x in np.argwhere(here != there):
            a, b = labels[y, x], labels[y + dy, x + dx]
            f_n = sum(
                math.sqrt((patches[a, v, u] != patches[b, v, u]).sum())
                for v, u in ((y, x), (y + dy, x + dx))
            )
            cut = 0.5 if interior[a, y, x] or interior[b, y + dy, x + dx] else 0.0
            cost += max(0.01, f_n + cut)
    return cost
