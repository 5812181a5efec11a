"""What lies on something of another colour shows against it."""

from iconstudio.algorithms.two_tones import INK, PAPER, in_two_tones
from iconstudio.model import Fill, Path
from tests.shapes import outline


def square(x, y, side, colour):
    corners = [(x, y), (x + side, y), (x + side, y + side), (x, y + side)]
    return Fill(outline(corners), colour)


def tones(*fills):
    found = in_two_tones(fills)
    assert [one.path for one in found] == [one.path for one in fills]
    return [one.colour for one in found]


def test_what_lies_on_the_ground_is_ink_however_pale():
    assert tones(square(0, 0, 9, "#ffffff"), square(20, 0, 9, "#000000")) == [INK, INK]


def test_a_detail_shows_and_so_does_what_lies_on_it():
    cat, eye, pupil = (
        square(0, 0, 90, "#20242c"), square(20, 20, 30, "#ffffff"), square(30, 30, 9, "#20242c"),
    )  # fmt: skip
    assert tones(cat, eye, pupil) == [INK, PAPER, INK]
    assert tones(cat, square(20, 20, 9, "#20242c")) == [INK, INK], "of the same colour"
    assert tones(cat, square(80, 80, 30, "#ffffff")) == [INK, INK], "hardly on it"


def test_what_lies_in_a_hole_lies_on_the_ground():
    outer = square(0, 0, 90, "#20242c").path
    hole = outline([(20, 20), (20, 70), (70, 70), (70, 20)])
    ring = Fill(Path((*outer.contours, *hole.contours)), "#20242c")
    assert tones(ring, square(30, 30, 20, "#ffffff")) == [INK, INK]
