"""What is shown in place of what has no icons, and that it is told."""

import pytest


def ids(collection, keyword):
    return [found.id for found in collection.search(keyword)]


@pytest.mark.parametrize(
    ("typed", "plain", "taken"),
    [
        ("cr\xe8me br\xfbl\xe9e", "creme brulee", "custard"),
        ("jalape\xf1o", "jalapeno", "chilli"),
        ("grandmother", "grandmother", "grandparent"),
        ("terrier", "terrier", "dog"),
        ("puppy", "puppy", "dog"),
        ("lorry", "lorry", "truck"),
        ("lorries", "lorries", "truck"),
        ("trainers", "trainers", "sneaker"),
        ("aeroplane", "aeroplane", "airplane"),
        ("doggo", "doggo", "dog"),
        ("autumn leaves", "autumn leaves", "fallen leaf"),
        ("happy new year", "happy new year", "fireworks"),
        ("merry-go-round", "merry go round", "carousel"),
    ],
)
def test_it_is_told_what_is_shown_in_place_of_a_thing_that_has_no_icons(
    bundled, typed, plain, taken
):
    assert ids(bundled, typed)
    assert bundled.remark(typed) == f"\u201c{plain}\u201d was read as \u201c{taken}\u201d."


@pytest.mark.parametrize(
    "typed", ["dog", "children", "rose", "labrador", "vehicle", "running", "colour"]
)
def test_what_has_icons_of_its_own_is_not_said_to_be_read_otherwise(bundled, typed):
    assert bundled.remark(typed) == ""


@pytest.mark.parametrize(
    ("symbol", "name"),
    [
        ("\U0001f3f3\ufe0f\u200d\U0001f308", "rainbow flag"),
        ("\U0001f3f3\ufe0f\u200d\u26a7\ufe0f", "transgender flag"),
    ],
)
def test_the_name_of_an_emoji_finds_what_the_emoji_finds(bundled, symbol, name):
    assert ids(bundled, name) == ids(bundled, symbol)
    left_out = f"No icon has all of these words: \u201c{name.split()[0]}\u201d was left out."
    assert bundled.remark(name) == bundled.remark(symbol) == left_out
