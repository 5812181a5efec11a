"""What a format declares is what is read, and what is said of anything else."""

from enum import Enum
from pathlib import Path
from typing import Annotated, Any

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from msgspec import Meta, ValidationError, convert

from iconstudio.inputs import json
from iconstudio.inputs.formats import (
    Many,
    Points,
    Polygons,
    Record,
    Reference,
    StrictRecord,
    Text,
    TextSet,
)
from iconstudio.inputs.mistakes import mistake
from iconstudio.model import IconstudioError
from iconstudio.workflows.files import likely_workflow
from iconstudio.workflows.registry import workflows

HERE = Path("here.json")


class Colour(Enum):
    RED = "red"
    BLUE = "blue"


class Wheel(Record, frozen=True):
    size: Annotated[float, Meta(gt=0, le=2.5)]
    spokes: Annotated[int, Meta(ge=3, le=2**63 - 1)] = 3
    rim: "Rim | None" = None


class Rim(Record, frozen=True):
    colour: Colour

    def check(self):
        if self.colour is Colour.BLUE:
            raise IconstudioError("No rim is blue.")


class Car(StrictRecord, frozen=True):
    name: Text
    wheels: Many[Wheel] = ()
    paint: Colour | None = None
    outline: Points = ()
    holes: Polygons = ()
    tracks: Many[Many[tuple[float, float]]] = ()
    words: TextSet = frozenset()
    icon: Reference | None = None
    photo: Path | None = None
    rating: Annotated[int, Meta(ge=1)] = 1
    weights: Many[Annotated[float, Meta(le=9)]] = ()
    more: Any = None


WHOLE = {
    "name": "a",
    "wheels": [{"size": 1.5, "rim": {"colour": "red"}}],
    "paint": "blue",
    "outline": [[1, 2]],
    "holes": [[[1, 2], [3, 4.5]]],
    "tracks": [[], [[1, 2]]],
    "words": ["b", "a"],
    "icon": "set:name",
    "rating": 9,
    "weights": [1, 2],
    "more": {"x": [1]},
}


def read(data):
    return json.converted(data, Car, HERE)


def test_what_is_written_is_read_back():
    car = read(WHOLE)
    assert car.wheels[0] == Wheel(1.5, rim=Rim(Colour.RED))
    assert json.converted(json.parsed(json.encoded(car), HERE), Car, HERE) == car
    assert json.encoded(car).count(b"spokes") == 0, "what is usual need not be said"
    assert b'"words":["a","b"]' in json.encoded(car), "the same work makes the same file"


def test_fields_that_are_passed_over_are_known():
    wheels = [{"size": 1}, {"tread": 2, "size": 1, "rim": {"colour": "red", "dents": [1]}}]
    data = {"name": "a", "wheels": wheels, "outline": [[1, 2]], "more": {"x": 1}}
    car = read(data)
    assert [*json.unknown_fields(car, data)] == ["tread", "dents"]
    assert [*json.unknown_fields(car, json.parsed(json.encoded(car), HERE))] == []


@pytest.mark.parametrize(
    ("change", "said"),
    [
        ({"name": None}, ': "name" is missing: a text.'),
        ({"naem": 1}, ': "naem" is not known here. Write "name" if you mean that.'),
        ({"wheels": 1}, ': "wheels" must be a list of wheels.'),
        ({"wheels": [WHOLE["wheels"][0], 7]}, ', wheel 2: An object such as {"key": "value"} is'),
        ({"wheels": [{}]}, ', wheel 1: "size" is missing: a number above 0 and up to 2.5.'),
        ({"wheels": [{"size": 0}]}, ', wheel 1: "size" must be a number above 0 and up to 2.5.'),
        (
            {"wheels": [{"size": 1, "spokes": 2}]},
            '"spokes" must be a whole number from 3 to 9223372036854775807.',
        ),
        ({"wheels": [{"size": 1, "rim": 1}]}, ", wheel 1, rim: An object such as"),
        ({"wheels": [{"size": 1, "rim": {}}]}, ', rim: "colour" is missing: one of red, blue.'),
        ({"wheels": [{"size": 1, "rim": {"colour": "blue"}}]}, ", wheel 1, rim: No rim is blue."),
        ({"paint": "green"}, ': "paint" must be null or one of red, blue.'),
        ({"outline": [[1, 2], [3]]}, ': Point 2 of "outline" is not a pair of numbers'),
        ({"outline": [[1, float("nan")]]}, 'Point 1 of "outline" is not a number, or too large.'),
        ({"outline": [[1, 2e9]]}, ': Point 1 of "outline" is out of all scale: [1, 2e+09].'),
        ({"holes": [[], 7]}, ': The polygon 2 of "holes" must be a list of [x, y] points.'),
        ({"holes": [[], [[1, 2], ["1", 2]]]}, ': Point 2 of polygon 2 of "holes" is not a pair'),
        ({"holes": 7}, ': "holes" must be a list of polygons.'),
        ({"tracks": 7}, ': "tracks" must be a list of lists of [x, y] points.'),
        ({"tracks": [[], [7]]}, ': Point 1 of list 2 of "tracks" is not a pair'),
        ({"words": ["a", 7]}, ': "words" must be a list of texts.'),
        ({"words": ["", "\ud800"]}, ': "words" holds characters that are none.'),
        ({"icon": " "}, ': "icon" is empty: write "set:name", or the path of an SVG or a scan.'),
        ({"photo": 7}, ': "photo" must be a text.'),
        ({"rating": 0}, ': "rating" must be a whole number of 1 or more.'),
        ({"rating": 1.0}, ': "rating" must be a whole number'),
        ({"rating": True}, ': "rating" must be a whole number'),
        ({"weights": ["1"]}, ': "weights" must be a list of numbers.'),
        ({"wheels": [WHOLE["wheels"][0]] * 10_001}, '"wheels" has 10,001 entries; at most 10,000'),
    ],
)
def test_what_is_said_of_anything_else(change, said):
    data = {key: one for key, one in (WHOLE | change).items() if one is not None}
    with pytest.raises(IconstudioError) as told:
        read(data)
    assert str(told.value).startswith("In “here.json”")
    assert said in str(told.value)


keys = st.sampled_from([*Car.__struct_fields__, *Wheel.__struct_fields__, "colour", "a.b", "x"])
leaves = st.none() | st.booleans() | st.integers() | st.floats() | st.text() | st.just("red")
values = st.recursive(
    leaves, lambda inner: st.lists(inner, max_size=3) | st.dictionaries(keys, inner, max_size=3)
)


@pytest.mark.thorough
@settings(suppress_health_check=[HealthCheck.too_slow])  # its first example loads libraries
@given(st.dictionaries(keys, values))
def test_there_is_a_sentence_for_every_mistake(data):
    data = {"name": "a"} | data
    try:
        convert(data, Car, dec_hook=lambda kind, value: kind(value))
    except ValidationError as error:
        sentence = mistake(error, data, Car)
        assert sentence.endswith(".") and ": " in sentence and "\n" not in sentence


@pytest.mark.parametrize(
    ("keys", "name"),
    [
        ("keyword polygon", "model"),
        ("icon", None),  # of two
        ("icon add", "edit"),
        ("icon style", "restyle"),
        ("style strength", "restyle"),
        ("keyword add", "edit"),
        ("icons title", "hybrids"),
        ("keyword count", "hybrids"),
        ("layers", "montage"),
        ("keyword", None),  # of three
        ("comment", None),
        ("", None),
    ],
)
def test_fields_tell_whose_file_it_is(keys, name):
    likely = likely_workflow(dict.fromkeys(keys.split(), 1), workflows())
    assert (None if likely is None else likely.name) == name
    assert likely_workflow([keys], workflows()) is None


def test_names_of_files_that_are_no_text_are_written(tmp_path):
    car = Car("a\ud800", icon=Reference("x:\udcff"))
    assert json.parsed(json.encoded(car), HERE) == {"name": "a?", "icon": "x:?"}


def test_floats_of_numpy_are_floats():
    assert b"[[0.1,2.0]]" in json.encoded(Car("a", outline=((np.float64(0.1), np.float64(2)),)))


def test_files_nearby_are_named_by_short_paths(tmp_path):
    path, near = tmp_path / "car.json", tmp_path / "photos" / "a.jpg"
    car = Car("a", icon=Reference(tmp_path / "a.svg"), photo=near)
    json.write(path, car)
    assert json.parsed(path.read_bytes(), HERE) == {
        "name": "a", "icon": "a.svg", "photo": "photos/a.jpg",
    }  # fmt: skip
    assert json.read(path, Car) == car
