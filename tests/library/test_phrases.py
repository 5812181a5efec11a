"""Several words: all of them if any icon has them, else what was left out or corrected is told."""

import pytest
from small_world import icon_set, shape

from iconstudio.model import IconstudioError


def ids(collection, keyword):
    return [found.id.partition(":")[2] for found in collection.search(keyword)]


OTHERS = ((3, "account-box"), (7, "wifi-tag"), (11, "plus"))


@pytest.fixture
def world(opened):
    names = (
        "bubble", "speech", "speech-bubble", "search", "bubble-search", "dog", "house", "dog-house",
        "man", "run", "lamp", "camera-selfie", "selfie", "calendar", "c", "c-plus-plus-language",
        "24-hours-clock", "wifi-low",
    )  # fmt: skip
    icons = {name: shape(number) for number, name in enumerate(names)}
    others = icon_set("b", {name: f'<circle cx="12" cy="12" r="{r}"/>' for r, name in OTHERS})
    others["aliases"] = {"selfie": {"parent": "account-box"}, "wifi": {"parent": "wifi-tag"}}
    return opened(icon_set("a", icons), others)


@pytest.mark.parametrize(
    ("keyword", "first", "remark"),
    [
        ("speech bubble", "speech-bubble", ""),
        ("speach bubble", "speech-bubble", "“speach” was read as “speech”."),
        ("Hund house", "dog-house", "“hund” was read as “dog”."),
        ("man running", "run", "No icon has all of these words: “man” was left out."),
        ("red dog", "dog", "No icon has all of these words: “red” was left out."),
        ("big red dog", "dog", "No icon has all of these words: “big” and “red” were left out."),
        (
            "big red bubbel",
            "bubble",
            "“bubbel” was read as “bubble”. "
            "No icon has all of these words: “big” and “red” were left out.",
        ),
        ("7 dogs", "dog", "No icon has all of these words: “7” was left out."),
        ("24 hours", "24-hours-clock", ""),
        ("24/7", "24-hours-clock", ""),
        ("24h", "24-hours-clock", ""),
        ("the dog", "dog", ""),
        ("dog icon", "dog", ""),
        ("dog filled", "dog", ""),
        ("C++", "c-plus-plus-language", ""),
        ("+", "plus", ""),
        ("selfie", "selfie", ""),
        ("wifi", "wifi-low", ""),
        ("dog", "dog", ""),
    ],
)
def test_what_several_words_find_and_how_they_were_read(world, keyword, first, remark):
    assert ids(world, keyword)[0] == first
    assert world.remark(keyword) == remark


def test_what_only_an_alias_calls_so_stands_behind(world):
    assert ids(world, "selfie") == ["selfie", "camera-selfie", "account-box"]


@pytest.mark.parametrize(
    ("keyword", "told"),
    [
        ("man with lamp", "man, lamp"),
        ("speech bubble calendar", "speech bubble, calendar"),
        ("lamp3 dog house", "lamp3, dog house"),
    ],
)
def test_words_that_find_nothing_together_are_told_by_those_that_do(world, keyword, told):
    with pytest.raises(IconstudioError, match=rf"Alone, these words find icons: {told}\."):
        world.search(keyword)
    assert world.remark(keyword) == ""


@pytest.mark.parametrize(
    ("keyword", "told"),
    [
        ("calandar lamp", "“calandar” was read as “calendar”. Alone, .*: calendar, lamp"),
        ("bubbel dog house", "“bubbel” was read as “bubble”. Alone, .*: bubble, dog house"),
    ],
)
def test_a_misspelt_word_is_not_left_out_but_read_rightly(world, keyword, told):
    with pytest.raises(IconstudioError, match=told):
        world.search(keyword)


def test_a_misspelt_word_that_is_left_out_is_told_as_typed(bundled):
    told = "No icon has all of these words: “seperate” was left out."
    assert bundled.remark("seperate lines") == told


@pytest.mark.parametrize("keyword", ["feng shui", "lactose free", "umbrela stand"])
def test_words_are_not_read_as_others_that_are_little_like_them(bundled, keyword):
    with pytest.raises(IconstudioError):
        bundled.search(keyword)


@pytest.mark.parametrize(
    ("keyword", "right"),
    [
        ("shoping cart", "shopping cart"),
        ("magnifing glass", "magnifying glass"),
        ("cofee cup", "coffee cup"),
        ("traffic ligth", "traffic light"),
        ("fire extinguiser", "fire extinguisher"),
        ("hot air baloon", "hot air balloon"),
        ("tresure chest", "treasure chest"),
        ("calender event", "calendar event"),
        ("puzzle peice", "puzzle piece"),
        ("remote controll", "remote control"),
        ("swiming pool", "swimming pool"),
    ],
)
def test_a_misspelt_word_of_several_finds_what_the_right_one_does(bundled, keyword, right):
    assert ids(bundled, keyword) == ids(bundled, right)
    ((typed, meant),) = bundled._lookup.answer(keyword).read_as
    assert keyword.replace(typed, meant) == right
    assert bundled.remark(right) == ""


@pytest.mark.parametrize("keyword", ["birthday hat", "witch hat"])
def test_a_word_that_is_known_is_not_taken_for_another(bundled, keyword):
    answer = bundled._lookup.answer(keyword)
    assert answer.read_as == ()
    assert answer.left_out == (keyword.split()[0],)


@pytest.mark.parametrize("keyword", ["calender", "coffe", "ballon"])
def test_a_word_that_few_names_misspell_does_not_hide_the_right_one(bundled, keyword):
    assert ids(bundled, keyword)
    right = {"calender": "calendar", "coffe": "coffee", "ballon": "balloon"}[keyword]
    assert bundled.remark(keyword) == f"Did you mean {right}?"
    assert keyword not in bundled._lookup._terms.proposals()


@pytest.mark.parametrize("keyword", ["witch", "otter", "bison", "mango", "saturn", "dog", "a b"])
def test_a_rare_word_is_no_misspelling(bundled, keyword):
    assert "Did you mean" not in bundled.remark(keyword)


@pytest.fixture
def numbers(opened):
    names = ("mp", "file-mp3", "audio-file-mp-3", "house", "house-03", "house-2", "eco-house")
    friendly = ("pet-friendly", "child-friendly")
    return opened(icon_set("a", {name: shape(n) for n, name in enumerate((*names, *friendly))}))


@pytest.mark.parametrize(
    ("keyword", "first", "remark"),
    [
        ("mp3", {"file-mp3", "audio-file-mp-3"}, ""),
        ("mp4", {"mp"}, "“mp4” was read as “mp”."),
        ("house3", {"house-03"}, ""),
        ("house9", {"house"}, "“house9” was read as “house”."),
        ("eco friendly", {"eco-house"}, "No icon has all of these words: “friendly” was left out."),
    ],
)
def test_a_word_that_is_found_is_not_said_to_be_left_out(numbers, keyword, first, remark):
    assert set(ids(numbers, keyword)[: len(first)]) == first
    assert numbers.remark(keyword) == remark


@pytest.mark.parametrize("keyword", ["user friendly", "eco friendly"])
def test_a_word_that_only_says_how_is_left_out(bundled, keyword):
    assert not any("pet" in name or "child" in name for name in ids(bundled, keyword))
    assert bundled._lookup.answer(keyword).left_out == ("friendly",)


MANY = " ".join(f"speech{a}ling{b}" for a in "abcdefghij" for b in "abcdefghij")


@pytest.mark.parametrize("keyword", ["dog " * 2000, "dog house " * 1000, MANY, f"dog {MANY}"])
def test_what_many_words_cost_is_bounded(world, keyword):
    asked = []
    rows = world._lookup._terms._rows
    world._lookup._terms._rows = lambda *query: asked.append(1) or rows(*query)
    world._lookup.answer(keyword)
    assert len(asked) < 2000


def test_repeated_words_are_looked_up_once(world):
    assert ids(world, "dog house " * 500) == ids(world, "dog house")
    assert world.remark("dog house " * 500) == ""


def test_words_that_are_not_looked_up_are_told(world):
    cut = "Only the first 8 words were looked up."
    few = "red blue big old sad odd hot dog"
    assert world.remark(few).startswith("No icon has all") and cut not in world.remark(few)
    assert world.remark(f"{few} lamp house").endswith(cut)
    with pytest.raises(IconstudioError, match=cut):
        world.search(MANY)


@pytest.mark.parametrize("keyword", ["tree house", "house tree"])
def test_of_words_that_few_icons_answer_together_those_are_named_that_more_do(keyword, bundled):
    first, second = keyword.split()
    told = "Few icons are of these words together; more are of"
    assert bundled.remark(keyword) == f"{told} “{first}” and “{second}”."


@pytest.mark.parametrize("keyword", ["light bulb", "house", "police car"])
def test_words_that_enough_icons_answer_are_not_taken_apart(keyword, bundled):
    assert bundled.remark(keyword) == ""
