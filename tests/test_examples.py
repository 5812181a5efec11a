"""The sketches that come with the program are fit for use."""

import json
from pathlib import Path

import pytest
from PIL import Image

from iconstudio.algorithms.geometry import crosses_itself
from iconstudio.model import CANVAS, Polygon
from iconstudio.resources import resource

EXAMPLES = resource("examples")
TRACED = sorted(EXAMPLES.glob("*.json"))
GALLERY = sorted((EXAMPLES / "gallery").glob("*.json"))


def label(path: Path) -> str:
    return path.relative_to(EXAMPLES).with_suffix("").as_posix()


def read(path: Path) -> dict:
    return json.loads(path.read_text(encoding="utf-8"))


def test_there_are_enough_of_them():
    assert len(TRACED) >= 5
    assert "motorbike" in [path.stem for path in TRACED]
    assert len(GALLERY) == 16


@pytest.mark.parametrize("path", TRACED + GALLERY, ids=label)
def test_a_sketch_is_a_simple_polygon_with_a_name_and_a_keyword(path):
    example = read(path)
    assert set(example) - {"best"} == {"title", "keyword", "polygon", "photo", "credit"}
    assert all(example[key].strip() for key in ("title", "keyword", "credit"))
    polygon = Polygon.of(example["polygon"])
    assert not crosses_itself(polygon)
    assert len(set(polygon.vertices)) == len(example["polygon"]) >= 15
    left, top, right, bottom = polygon.fitted().bounds
    assert 0 < left < right < CANVAS
    assert 0 < top < bottom < CANVAS


@pytest.mark.parametrize("path", TRACED, ids=label)
def test_a_traced_sketch_lies_within_its_photo(path):
    example = read(path)
    left, top, right, bottom = Polygon.of(example["polygon"]).bounds
    with Image.open(EXAMPLES / example["photo"]) as photo:
        photo.load()
        assert 0 <= left < right <= photo.width
        assert 0 <= top < bottom <= photo.height


@pytest.mark.parametrize("path", GALLERY, ids=label)
def test_a_free_hand_sketch_needs_no_photo(path):
    assert read(path)["photo"] is None


def test_no_two_sketches_are_the_same_drawing():
    polygons = [Polygon.of(read(path)["polygon"]).fitted() for path in TRACED + GALLERY]
    assert len(set(polygons)) == len(polygons)


def test_every_photo_belongs_to_a_sketch_and_the_folder_stays_small():
    files = [path for path in EXAMPLES.rglob("*") if path.is_file()]
    photos = {path.name for path in files if path.suffix == ".jpg"}
    assert photos == {read(path)["photo"] for path in TRACED}
    assert sum(path.stat().st_size for path in files) < 1_200_000
