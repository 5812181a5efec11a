"""What sheets are drawn of is as smooth on them as it is."""

import numpy as np
import pytest

from iconstudio.output.figure import Figure, legible


def disc(side: int, radius: float) -> np.ndarray:
    """Return a disc with smooth edges in the middle of a square, (side, side) uint8."""
    y, x = np.mgrid[:side, :side] + 0.5 - side / 2
    return (255 * np.clip(radius - np.hypot(x, y) + 0.5, 0, 1)).astype(np.uint8)


def test_ink_made_a_little_smaller_stays_smooth():
    figure = Figure(480, 480)
    figure.stencil(0, 0, 480, disc(512, 192), (0, 0, 0))
    shown = 255 - np.asarray(figure.picture)[..., 0].astype(int)
    assert abs(shown - disc(480, 180)).max() < 64


@pytest.mark.parametrize(
    ("text", "written"),
    [
        ("\U0001f697", "automobile"),
        ("a \U0001f469\U0001f3fd\u200d\U0001f692", "a woman firefighter"),
        ("\u0628\u064a\u062a", "[Arabic]"),
        ("own:\u732b.svg, 2  icons", "[CJK] 2 icons"),
        ("\u05db\u05dc\u05d1 \u05db\u05dc\u05d1 dog", "[Hebrew] dog"),
        ("caf\u00e9, \u0434\u043e\u043c,  \u2026", "caf\u00e9, \u0434\u043e\u043c,  \u2026"),
        ("fire\u200btruck", "firetruck"),
    ],
)
def test_what_the_font_lacks_is_named(text, written):
    assert legible(text) == written
    figure = Figure(400, 60)
    figure.text(5, 5, text, 30)
    assert np.asarray(figure.picture).min() < 64
