"""Which names say that an icon shows more than the thing."""

import pytest
from small_world import icon_set, shape

from iconstudio.library.words.strangers import shows_more


@pytest.mark.parametrize(
    ("name", "keyword"),
    [
        ("car-plus", "car"),
        ("user-plus", "user"),
        ("circle-user", "user"),
        ("car-with-key", "car"),
        ("bicycle-in-garage", "bicycle"),
        ("hand-holding-heart", "heart"),
        ("man-in-boat-24-filled", "boat"),
        ("camera-off", "camera"),
        ("laptop-car-outline-sharp", "car"),
        ("rental-bicycle-14", "bicycle"),
        ("house-up-fill", "house"),
        ("shield-dog", "dog"),
    ],
)
def test_a_sign_a_person_a_place_or_a_direction_is_more(name, keyword):
    assert shows_more(name, [keyword])


@pytest.mark.parametrize(
    ("name", "keyword"),
    [
        ("car", "car"),
        ("car-24-filled", "car"),
        ("car-side", "car"),
        ("police-car", "car"),
        ("table-lamp", "lamp"),
        ("dog-face", "dog"),
        ("poodle", "dog"),
        ("user", "person"),
        ("plus", "plus"),
        ("up-arrow", "arrow"),
        ("arrow-up", "arrow"),
        ("the-moon", "moon"),
        ("lamp-on", "lamp"),
        ("cross-country-motorcycle", "motorcycle"),
    ],
)
def test_kinds_views_and_styles_are_not(name, keyword):
    assert not shows_more(name, [keyword])


def test_the_collection_tells_by_what_the_search_knows_and_by_names(opened):
    names = (
        "dog", "dog-2", "poodle", "police-dog", "dog-plus", "man-walking-dog", "dog-bowl",
        "dog-with-bone", "dogs-24-filled",
    )  # fmt: skip
    collection = opened(icon_set("a", {name: shape(number) for number, name in enumerate(names)}))
    found = [one.id for one in collection.search("dogs")]
    more, related = (
        {one.partition(":")[2] for one in some} for some in collection.strangers("dogs", found)
    )
    names = {one.partition(":")[2] for one in found}
    assert more == {"dog-plus", "man-walking-dog", "dog-with-bone"} & names
    assert related == {"dog-bowl"} & names
    assert {"dog", "poodle", "police-dog", "dogs-24-filled"} <= names
    assert "dog-with-bone" in more
