"""What sheets are drawn of is as smooth on them as it is."""

import numpy as np

from iconstudio.output.figure import Figure


def disc(side: int, radius: float) -> np.ndarray:
    """Return a disc with smooth edges in the middle of a square, (side, side) uint8."""
    y, x = np.mgrid[:side, :side] + 0.5 - side / 2
    return (255 * np.clip(radius - np.hypot(x, y) + 0.5, 0, 1)).astype(np.uint8)


def test_ink_made_a_little_smaller_stays_smooth():
    figure = Figure(480, 480)
    figure.stencil(0, 0, 480, disc(512, 192), (0, 0, 0))
    shown = 255 - np.asarray(figure.picture)[..., 0].astype(int)
    assert abs(shown - disc(480, 180)).max() < 64
