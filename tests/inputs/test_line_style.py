"""Files of line styles: what is written is read, and every mistake ends in one sentence."""

import os
from dataclasses import replace
from json import dumps
from math import inf, nan
from pathlib import Path
from tempfile import TemporaryDirectory

import pytest
from hypothesis import given
from hypothesis import strategies as st

from iconstudio.inputs.line_style import (
    MOST_LEARNED,
    SHORTEST,
    read_style,
    style_of_lines,
    write_style,
    written,
)
from iconstudio.inputs.styles import bundled, named
from iconstudio.model import CANVAS, IconstudioError, Line, LineStyle, StylePair

STROKE = [[0, 0], [50, 5], [100, 0]]
WIDE = [[*point, 3] for point in STROKE]
HUNDREDTHS = st.integers(-200 * CANVAS, 200 * CANVAS).map(lambda number: number / 100)
WIDTHS = st.integers(0, 100 * CANVAS).map(lambda number: number / 100)


def style_of(text, *tell):
    """Return the style in a file of this text."""
    with TemporaryDirectory() as folder:
        path = Path(folder, "the text")
        path.write_bytes(text.encode(errors="replace"))
        return read_style(path, *tell)


@st.composite
def pairs(draw, plain, wide):
    points = st.lists(st.tuples(HUNDREDTHS, HUNDREDTHS), min_size=3, max_size=4, unique=True)
    far = ((0.0, 0.0), (SHORTEST, 0.0))
    onwards = [
        (round(x + 3.0 * CANVAS * n, 2), y) for n, (x, y) in enumerate(draw(points), start=1)
    ]
    styled = (*far, *onwards)
    return StylePair(
        styled,
        (*far, *draw(points)) if plain else (),
        draw(st.booleans()),
        (1.0, *(draw(WIDTHS) for _ in styled[1:])) if wide else (),
    )


@st.composite
def styles(draw):
    texts = st.text(st.characters(exclude_characters="\0", codec="utf-8"), max_size=9)
    plain, wide = draw(st.booleans()), draw(st.booleans())
    one = pairs(plain, wide)
    return LineStyle(
        " ".join(["a", *draw(texts).splitlines()]),
        tuple(draw(one) for _ in range(draw(st.integers(1, 2)))),
        draw(texts),
        draw(texts),
        draw(st.booleans()),
        plain and draw(st.booleans()),
    )


@given(styles())
def test_what_is_written_is_read(style):
    assert style_of(written(style)) == style


def test_a_file_is_as_short_as_can_be(tmp_path):
    path = tmp_path / "a.json"
    write_style(path, LineStyle("Ä", (StylePair(((0, 0), (50.001, 5), (100, 0))),)))
    text = '{"name":"Ä","pairs":[{"styled":[[0,0],[50.0,5],[100,0]]}]}\n'
    assert path.read_text("utf-8") == text
    assert read_style(path).pairs[0].styled == ((0, 0), (50, 5), (100, 0))


def test_widths_are_learned():
    (pair,) = style_of(dumps({"name": "a", "pairs": [{"styled": WIDE}]})).pairs
    assert pair.widths == (3, 3, 3)


def test_strokes_of_too_many_points_are_thinned_side_by_side_and_this_is_told():
    many = [[i / 500, (i % 3) / 100] for i in range(MOST_LEARNED + 5000)]
    told = []
    file = {"name": "a", "pairs": [{"styled": many, "plain": [[x, 9] for x, _ in many]}]}
    (pair,) = style_of(dumps(file), told.append).pairs
    assert len(pair.styled) == len(pair.plain) == MOST_LEARNED
    assert [x for x, _ in pair.styled] == [x for x, _ in pair.plain]
    assert pair.styled[0] == tuple(many[0]) and pair.styled[-1] == tuple(many[-1])
    assert told == ["In “the text”, pair 1: of 25,000 points of a stroke 20,000 are learned from."]


def pair(**more):
    return {"name": "a", "pairs": [{"styled": STROKE, **more}]}


@pytest.mark.parametrize(
    ("data", "words"),
    [
        ({"name": "a", "pairs": []}, "There is no pair. Add at least one"),
        ({"name": " ", "pairs": [{"styled": STROKE}]}, '"name" is empty'),
        ({"name": "a", "pairs": [{"plain": STROKE}]}, '"styled" is missing: a list of [x, y]'),
        ({"name": "a"}, "this is no line style"),
        ({"layers": []}, "this is no line style"),
        ([], "An object"),
        ({**pair(), "version": 2}, "is of version 2"),
        ({**pair(new=1), "version": "3"}, "is of version 3"),
        (pair(colour=1), '"colour" is not known here'),
        (pair(styled=STROKE[:2]), "has two points; it needs at least 3"),
        (pair(styled=[[1, 1]] * 5), "is 0 units long"),
        (pair(plain=[[1, 1]] * 3), "The plain stroke is 0 units long"),
        (pair(styled=[[0, 0], [90, 60], [0, 0], [90, 60], [0, 0]]), "gets nowhere"),
        (pair(styled=[[x / 20, y / 20] for x, y in STROKE]), "units long; it needs at least 10"),
        (pair(styled=[[0, 0], [nan, 1], [9, 9]]), "Point 2 of"),
        (pair(plain=[[0, 0], [5, 1], [9, -inf]]), "Point 3 of"),
        (pair(styled=[[0, 0], [1e5, 1], [9, 9]]), "is out of all scale: [100000, 1]"),
        (pair(styled=[[0, 0], [1], [9, 9]]), "is not numbers such as [12, 34.5] or [12, 34.5, 6]"),
        (pair(styled=[[0, 0], [1, 2, 3, 4], [9, 9]]), "is not numbers such as"),
        (pair(styled=[[0, 0], [9, 2, 3], [9, 9]]), "have a width, and some have none"),
        (pair(styled=[[x, y, -1] for x, y in STROKE]), "Widths of the styled stroke are from 0"),
        (
            pair(styled=[[i % 2 * 4000, 500 * i - 2000] for i in range(9)]),
            "Scale them down, or leave some out",
        ),
        ({"name": "a", "pairs": [{"styled": STROKE}, {"styled": STROKE, "plain": STROKE}]}, "none"),
        (
            {"name": "a", "pairs": [{"styled": STROKE}, {"styled": WIDE}]},
            "Give widths to all pairs",
        ),
        (pair(styled=[[*p, 0] for p in STROKE]), "All widths of the styled stroke are 0"),
        ({**pair(), "shape": True}, "no plain strokes, whose shape would count"),
        ({**pair(), "name": "a\nb"}, '"name" has a line break. Write it on one line.'),
        ({**pair(), "name": "a\u2028b"}, '"name" has a line break'),
        (pair(styled=[[0, 0], [1e300, 1], [9, 9]]), "is out of all scale: [1e+300, 1]"),
        (pair(styled=[[0, 0, 1], [5, 5, 1e300], [9, 9, 1]]), "is out of all scale"),
        ({**pair(), "rotation": 1e300}, '"rotation" must be true or false'),
    ],
)
def test_every_mistake_ends_in_a_sentence(data, words):
    with pytest.raises(IconstudioError) as caught:
        style_of(dumps(data))
    assert words in str(caught.value)


def test_what_is_no_file_is_refused_at_once(tmp_path):
    os.mkfifo(tmp_path / "pipe")
    for path, words in ((tmp_path, "a folder"), (tmp_path / "pipe", "a pipe")):
        with pytest.raises(IconstudioError, match=words):
            read_style(path)


def test_lines_long_enough_are_examples():
    long = Line(tuple(map(tuple, STROKE)), width=3, widths=(1, 2, 3))
    short = Line(((0, 0), (1, 1), (2, 0)))
    assert style_of_lines((short, long, short), "a").pairs == (
        StylePair(long.points, widths=(1, 2, 3)),
    )
    even = replace(long, widths=())
    assert [one.widths for one in style_of_lines((long, even), "a").pairs] == [(1, 2, 3), (1, 1, 1)]
    assert style_of_lines((long,), "a\nb").name == "a b", "files may be called so"
    with pytest.raises(IconstudioError, match=r"“a\.svg” has no line of at least"):
        style_of_lines((short,), "a.svg")


def test_bundled_styles_are_what_their_files_say_and_found_by_name():
    assert len(bundled()) >= 12
    for style in bundled():
        assert style_of(written(style)) == style
        assert style.author and style.license
        assert named(f" {style.name.upper()}") is style
    with pytest.raises(IconstudioError, match="Do you mean “Wobbly”"):
        named("wobly")
    with pytest.raises(IconstudioError, match=r"There are .*, Zigzag"):
        named("xyzxyz")
