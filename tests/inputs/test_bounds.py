"""What files may hold: any Unicode encoding, many points, and bounds that are told."""

import json
import math
import os
import random
import time
from copy import deepcopy
from itertools import islice
from pathlib import Path

import numpy as np
import pytest

from iconstudio.algorithms.geometry import near
from iconstudio.algorithms.iconification.guidance import scribble
from iconstudio.inputs import formats, lines
from iconstudio.inputs import json as files
from iconstudio.model import CANVAS, MARGIN, IconstudioError, Stroke
from iconstudio.resources import resource
from iconstudio.workflows.editing.file import read_edit
from iconstudio.workflows.hybrids.file import read_hybrids
from iconstudio.workflows.modelling.file import read_sketch
from iconstudio.workflows.montage.file import read_montage

READERS = {"": read_sketch, "edits": read_edit, "hybrids": read_hybrids, "montages": read_montage}
SQUARE = [[10, 10], [90, 10], [90, 90], [10, 90]]
MANY = 20_000


def outline(count, size=1.0):
    """A wavy outline of so many points, as a segmentation gives it."""
    angles = np.linspace(0, 2 * np.pi, count, endpoint=False)
    radii = size * (100 + 20 * np.cos(5 * angles) + 0.02 * np.cos(997 * angles))
    return (128 + radii[:, None] * np.stack([np.cos(angles), np.sin(angles)], axis=1)).tolist()


def saved(tmp_path, data):
    path = tmp_path / "input.json"
    path.write_text(data if isinstance(data, str) else json.dumps(data), "utf-8")
    return path


@pytest.mark.parametrize(
    "encoding",
    ["utf-8", "utf-8-sig", "utf-16", "utf-16-le", "utf-16-be", "utf-32", "utf-32-le", "utf-32-be"],
)
def test_any_unicode_encoding_is_read(tmp_path, encoding):
    path = tmp_path / "input.json"
    text = json.dumps({"keyword": "Café ☕", "polygon": SQUARE}, ensure_ascii=False)
    path.write_bytes(text.encode(encoding))
    assert read_sketch(path).sketch.keyword == "Café ☕"


def test_another_encoding_is_told(tmp_path):
    path = tmp_path / "input.json"
    path.write_bytes('{"keyword": "café"}'.encode("latin-1"))
    with pytest.raises(IconstudioError, match="no text in UTF-8"):
        read_sketch(path)


@pytest.mark.parametrize("size", [1.0, 1e-3, 1e5])
def test_an_outline_of_many_points_is_taken_in_a_moment(tmp_path, size):
    points = outline(MANY, size)
    path = saved(tmp_path, {"keyword": "dog", "polygon": points})
    read_sketch(saved(tmp_path, {"polygon": outline(600)}))  # loads the library
    path = saved(tmp_path, {"keyword": "dog", "polygon": points})
    began = time.process_time()
    polygon = read_sketch(path).sketch.polygon
    fitted = polygon.fitted()
    assert time.process_time() - began < 1
    assert len(polygon.vertices) < 500
    unit = max(np.ptp(points, axis=0)) / (CANVAS - 2 * MARGIN)
    closed = (*polygon.vertices, polygon.vertices[0])
    assert near(np.array(points), closed, 0.2 * unit * (1 + 1e-9)).all()
    assert len(fitted.vertices) == len(polygon.vertices)


def test_what_a_hand_draws_is_not_simplified(tmp_path):
    points = outline(lines.MANY)
    read = read_sketch(saved(tmp_path, {"polygon": points})).sketch.polygon
    assert read.vertices == tuple(map(tuple, points))


def test_an_area_and_a_stroke_of_many_points(tmp_path):
    points = outline(MANY)
    file = read_edit(saved(tmp_path, {"icon": "a:b", "add": [points]}))
    (area,) = file.resolved(lambda _: None).add
    assert len(area.vertices) < 500
    assert near(np.array(points), (*area.vertices, area.vertices[0]), 0.2 + 1e-9).all()
    points = outline(formats.MOST_POINTS)
    layer = {"icon": "a:b", "strokes": [{"width": 9, "points": points}]}
    file = read_montage(saved(tmp_path, {"layers": [layer]}))
    ((stroke,),) = (one.strokes for one in file.resolved(lambda _: None).layers)
    assert len(stroke.points) < 500
    assert near(np.array(points), stroke.points, 0.2 + 1e-9).all()
    whole = scribble([Stroke(9, tuple(map(tuple, points)))])
    assert (scribble([stroke]) != whole).sum() < 0.02 * whole.sum()


@pytest.mark.parametrize(
    ("read", "data"),
    [
        (lambda path: read_sketch(path).sketch, lambda points: {"polygon": points}),
        (
            lambda path: read_edit(path).resolved(lambda _: None),
            lambda points: {"icon": "a:b", "add": [points]},
        ),
    ],
)
def test_an_outline_that_is_noise_is_refused_at_once(tmp_path, read, data):
    noise = np.random.default_rng(1).uniform(9, 247, (50_000, 2)).round(2).tolist()
    read(saved(tmp_path, data(outline(600))))  # loads the library
    path = saved(tmp_path, data(noise))
    began = time.process_time()
    with pytest.raises(IconstudioError, match=r"of 50,000 points .* at most 20,000 can be"):
        read(path)
    assert time.process_time() - began < 2


LINE = [[9, 9], [90, 90]] * (formats.MOST_POINTS // 2) + [[9, 9]]
LAYER = {"icon": "a:b", "strokes": [{"width": 9, "points": LINE}]}
TEXTS = ["a:b"] * (formats.MOST_IN_LIST + 1)


@pytest.mark.parametrize(
    ("read", "data", "words"),
    [
        (read_sketch, {"polygon": LINE}, "200,001 entries; at most 200,000"),
        (read_edit, {"icon": "a:b", "add": [LINE]}, "200,001 points; at most 200,000"),
        (read_montage, {"layers": [LAYER]}, "stroke 1: .*at most 200,000"),
        (read_montage, {"layers": [{"icon": "a:b"}] * 10_001}, "10,001 entries"),
        (read_edit, {"icon": "a:b", "remove": [SQUARE] * 10_001}, "10,001 entries"),
        (read_sketch, {"polygon": SQUARE, "exclude": TEXTS}, "10,001 entries"),
        (read_hybrids, {"icons": TEXTS}, "10,001 entries"),
        (read_hybrids, {"icons": ["a:b"], "pins": [SQUARE * 3000]}, "at most 10,000 are read"),
        (read_hybrids, {"icons": ["a:b"], "pins": [SQUARE * 1500] * 2}, "too many points"),
        (read_sketch, {"polygon": SQUARE, "keyword": "x" * 5000}, "5,000 characters"),
        (read_edit, {"icon": "x" * 5000, "add": [SQUARE]}, "5,000 characters"),
        (read_edit, '{"icon": "a:b", "add": [], "icon": "a:c"}', '"icon" is there twice'),
        (read_edit, '{"icon": "a:b", "' + "\\ud800" * 999 + '": 1, "x": 1, "x": 2}', "twice"),
        (read_hybrids, '{"keyword": "dog", "seed": ' + "9" * 5000 + "}", "whole number"),
        (read_sketch, '{"polygon": [[0, 0], [1, ' + "9" * 5000 + "], [1, 0]]}", "too large"),
        (read_sketch, '{"polygon": [[0, 0], [1, 1e999], [1, 0]]}', "not a number, or too large"),
        (read_sketch, '{"polygon": ' + "[" * 900 + "]" * 900 + "}", "pair of numbers"),
        (read_sketch, '{"polygon": ' + "[" * 100_000, "nested too deeply"),
        (read_sketch, " " * (files.MOST_BYTES + 1), "more than 32,000,000 bytes"),
    ],
)  # fmt: skip
def test_bounds_are_told(tmp_path, read, data, words):
    with pytest.raises(IconstudioError, match=words):
        read(saved(tmp_path, data))


@pytest.mark.skipif(os.name != "posix", reason="needs POSIX files")
@pytest.mark.timeout(20)
@pytest.mark.parametrize("read", READERS.values())
def test_what_is_no_file_is_refused_at_once(tmp_path, read):
    os.mkfifo(tmp_path / "pipe")
    for path in (tmp_path / "pipe", Path("/dev/zero"), tmp_path):
        with pytest.raises(IconstudioError, match=f"{path}” cannot be read. It is a "):
            read(path)


@pytest.mark.skipif(os.name != "posix", reason="needs symbolic links")
def test_links_in_a_circle_are_no_crash(tmp_path):
    (tmp_path / "a.svg").symlink_to("a.svg")
    sketch = read_sketch(saved(tmp_path, {"polygon": SQUARE, "photo": "a.svg"}))
    edit = read_edit(saved(tmp_path, {"icon": "a.svg", "add": [SQUARE]}))
    assert sketch.photo.name == edit.icon.rpartition(os.sep)[2] == "a.svg"


def test_slim_is_said_to_be_slim(tmp_path):
    pole = [[0, 0], [2000, 0], [2000, 12], [0, 12]]
    with pytest.raises(IconstudioError, match="too slim: it is not even 4% as wide"):
        read_sketch(saved(tmp_path, {"polygon": pole})).sketch.polygon.fitted()
    slanting = [[0, 0], [1000, 1000], [1005, 995], [5, -5]]
    with pytest.raises(IconstudioError, match="too slim"):
        read_sketch(saved(tmp_path, {"polygon": slanting})).sketch.polygon.fitted()
    thin = [[100, 20], [101, 20], [101, 220], [100, 220]]  # an aerial may be taken off
    assert read_edit(saved(tmp_path, {"icon": "a:b", "remove": [thin]})).remove


# -- changed files ---------------------------------------------------------------------------------

STRANGE = [
    None, True, 0, -1, 0.5, 1e308, 10**400, math.nan, math.inf, "", "x", "\ud800", "a\0b", " ",
    "../" * 99, "x" * 9999, [], [[]], [[[]]], {}, {"": None}, [1, 2], [[1, 2]] * 3, ["a:b"] * 3,
]  # fmt: skip


def places(data, here=()):
    """The ways to all values in a document."""
    yield here
    keys = data if isinstance(data, dict) else range(len(data) if isinstance(data, list) else 0)
    for key in keys:
        yield from places(data[key], (*here, key))


def change_a_value(data, chance):
    """Replace one value of a document, drop it, or repeat it."""
    # Of a document that was repeated thousandfold before, the first places do.
    *way, last = chance.choice(list(islice(places(data), 1, 2000)))
    for key in way:
        data = data[key]
    match chance.randrange(4):
        case 0:
            del data[last]
        case 1 if isinstance(data, list):
            data[last:last] = [data[last]] * chance.choice([1, 2, 3000])
        case _:
            data[last] = deepcopy(chance.choice(STRANGE))


@pytest.mark.parametrize("folder", READERS)
def test_changed_examples_are_read_or_refused_in_a_sentence(tmp_path, folder):
    read, chance, refused = READERS[folder], random.Random(folder), 0
    examples = sorted((resource("examples") / folder).glob("*.json"))
    path = tmp_path / "input.json"
    for _ in range(300):
        data = json.loads(chance.choice(examples).read_text("utf-8"))
        for _ in range(chance.choice([1, 1, 2, 5])):
            if data:
                change_a_value(data, chance)
        raw = json.dumps(data, ensure_ascii=False).encode(errors="surrogatepass")
        if chance.random() < 0.4:
            raw = damaged(raw, chance)
        path.write_bytes(raw)
        try:
            read(path)
        except IconstudioError as error:
            refused += 1
            assert str(error).endswith(".") and "\n" not in str(error)
            assert path.name in str(error)
    assert 30 < refused < 288


def damaged(raw, chance):
    """Bytes of which some are cut out, doubled, or others."""
    first, last = sorted(chance.randrange(len(raw) + 1) for _ in range(2))
    middle = chance.choice([b"", raw[first:last] * 2, chance.randbytes(min(last - first, 9))])
    return raw[:first] + middle + raw[chance.choice([first, last]) :]
