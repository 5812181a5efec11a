"""Search by inflected words, by symbols, by styles; near things for what has no drawings; hints."""

import pytest
from small_world import icon_set, shape

from iconstudio.library.collection import Collection
from iconstudio.library.search import RELEVANT
from iconstudio.model import IconstudioError


def small(*names):
    return icon_set("a", {name: shape(number) for number, name in enumerate(names)})


def ids(collection, keyword):
    return [found.id.partition(":")[2] for found in collection.search(keyword)]


@pytest.fixture
def world(opened):
    return opened(
        small(
            "child", "children-toy", "dog", "dog-face", "dog-fill", "dog-outline", "fish", "run",
            "person-running", "wed", "wedding-cake", "lizard", "swing", "die", "game-die",
            "germany",
        ),
        icon_set("b", {"mouse": shape(16), "horse": shape(17), "shore": shape(18)}),
    )  # fmt: skip


@pytest.mark.parametrize(
    ("keyword", "first", "never"),
    [
        ("children", {"child"}, set()),
        ("mice", {"mouse"}, set()),
        ("running", {"run"}, set()),
        ("ran", {"run"}, set()),
        ("\U0001f436", {"dog-face", "dog", "dog-fill", "dog-outline"}, set()),
        ("\U0001f3b2", {"game-die", "die"}, set()),
        ("\U0001f1e9\U0001f1ea", {"germany"}, set()),
        ("crocodile", {"lizard"}, set()),
        ("swing set", {"swing"}, set()),
        ("b:dog", {"dog", "dog-fill", "dog-outline"}, {"shore"}),
        ("b-dog", {"dog", "dog-fill", "dog-outline"}, {"shore"}),
        ("unheardof:dog", {"dog", "dog-fill", "dog-outline"}, set()),
    ],
)
def test_what_a_word_means(world, keyword, first, never):
    found = ids(world, keyword)
    assert set(found[: len(first)]) == first
    assert not never.intersection(found)


def test_a_child_is_found_by_its_plural_as_by_its_own_word(world):
    assert set(ids(world, "child")) == set(ids(world, "children"))


def test_a_wedding_is_no_form_of_to_wed_and_fishing_no_fish(world):
    assert ids(world, "wedding") == ["wedding-cake"]
    with pytest.raises(IconstudioError, match="'fishing'"):
        world.search("fishing")


@pytest.mark.parametrize(
    ("keyword", "order"),
    [
        ("dog filled", ["dog-fill", "dog", "dog-outline"]),
        ("line dog", ["dog-outline", "dog", "dog-fill"]),
        ("solid dogs", ["dog-fill", "dog", "dog-outline"]),
    ],
)
def test_drawings_of_the_style_that_is_asked_for_come_first(world, keyword, order):
    assert [name for name in ids(world, keyword) if name in order] == order


def test_an_unknown_icon_whose_name_is_a_word_is_told_by_icons_of_the_word(world):
    with pytest.raises(IconstudioError) as caught:
        world.get("b:dog")
    assert "a:dog" in str(caught.value) and "b:shore" not in str(caught.value)


def test_of_several_words_the_known_ones_are_told(world):
    with pytest.raises(IconstudioError, match=r"Alone, these words find icons: child, lizard\."):
        world.search("child lizard")


@pytest.mark.parametrize(
    "typed", ["Hund", "perro", "chien", "\u0441\u043e\u0431\u0430\u043a\u0430"]
)
def test_another_language_is_told_the_english_word(world, typed):
    with pytest.raises(IconstudioError, match=r"Did you mean dog\? Icons have English names"):
        world.search(typed)


@pytest.fixture(scope="module")
def bundled(tmp_path_factory):
    with Collection.open(cache=tmp_path_factory.mktemp("cache")) as collection:
        yield collection


@pytest.mark.parametrize(
    ("inflected", "word"),
    [
        ("children", "child"), ("mice", "mouse"), ("geese", "goose"), ("knives", "knife"),
        ("wolves", "wolf"), ("feet", "foot"), ("men", "man"), ("people", "person"),
        ("dice", "die"), ("leaves", "leaf"), ("running", "run"), ("swam", "swim"),
        ("foxes", "fox"), ("policemen", "policeman"), ("cacti", "cactus"),
    ],
)  # fmt: skip
def test_an_inflected_word_finds_what_the_word_finds(bundled, inflected, word):
    lookup = bundled._lookup
    near = {icon for icon, score in lookup.scores(word).items() if score <= RELEVANT}
    assert near and near <= set(lookup.scores(inflected))


@pytest.mark.parametrize(
    ("symbol", "word"),
    [
        ("\U0001f436", "dog"), ("\U0001f415", "dog"), ("\U0001f431", "cat"),
        ("\u2764\ufe0f", "heart"), ("\u2764", "heart"), ("\U0001f34e", "apple"),
        ("\u2615", "coffee"), ("\U0001f3b2", "die"), ("\U0001f697", "automobile"),
        ("\U0001f44d\U0001f3fd", "thumbs up"), ("\U0001f469\u200d\U0001f680", "astronaut"),
        ("\U0001fabf", "goose"), ("\u2702\ufe0f", "scissors"),
    ],
)  # fmt: skip
def test_an_emoji_finds_what_its_word_finds(bundled, symbol, word):
    lookup = bundled._lookup
    assert set(lookup.plainly(word)) <= set(lookup.scores(symbol))


@pytest.mark.parametrize(
    ("keyword", "name"),
    [
        ("crocodile", "reptile"), ("toe", "foot"), ("bulldog", "dog"), ("puffin", "bird"),
        ("mackerel", "fish"), ("celery", "vegetable"), ("tarantula", "spider"),
        ("blouse", "shirt"), ("tricycle", "bicycle"), ("cr\u00e8che", "nursery"),
    ],
)  # fmt: skip
def test_near_things_stand_in_for_what_has_no_drawings(bundled, keyword, name):
    assert any(name in found for found in ids(bundled, keyword))


@pytest.mark.parametrize(
    ("keyword", "never"),
    [
        ("CR\u00c8CHE", "hospital"), ("waiter", "server"), ("surgeon", "docs"), ("judge", "doge"),
        ("stapler", "machine"), ("walnut", "bolt"), ("person", "ruler"), ("pilot", "copilot"),
        ("salamander", "unlink"), ("wedding", "wednesday"),
        ("\U0001f1fa\U0001f1f8", "state"),
    ],
)  # fmt: skip
def test_nothing_far_fetched(bundled, keyword, never):
    try:
        found = ids(bundled, keyword)
    except IconstudioError:
        found = []
    assert not [name for name in found if never in name]


def test_no_hint_hurts(bundled):
    hurtful = {"bum", "rape", "slave", "suicide", "swastika", "eskimo", "anus", "penis"}
    assert hurtful.isdisjoint(bundled._lookup.proposals())
