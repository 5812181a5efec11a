"""Search: the thing before what mentions it, in words that the user has; and no drawing twice."""

import re

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from hypothesis.extra import numpy as hnp
from small_world import icon_set, shape

from iconstudio.library import search
from iconstudio.library.fingerprint import SIDE, WORDS, fingerprint, stack, unlikeness
from iconstudio.library.words.naming import take_apart
from iconstudio.library.words.nearness import nearest
from iconstudio.model import IconstudioError

pytestmark = pytest.mark.thorough(but=1)

bitmaps = hnp.arrays(np.bool_, (5, SIDE, SIDE))


def ids(collection, keyword, **options):
    return [found.id.partition(":")[2] for found in collection.search(keyword, **options)]


def small(*names):
    return icon_set("a", {name: shape(number) for number, name in enumerate(names)})


def several(name):
    return [f"{name}-{number}" for number in (2, 3, 4)]


def test_the_thing_before_what_mentions_it(opened):
    names = (
        "dog-bowl", "hot-dog", "man-walking-dog", "dog-plus", "poodle", "police-dog", "dog-sitting",
        "dog-24-filled", "bowl",
    )  # fmt: skip
    found = ids(opened(small(*names)), "dog")
    assert found[:2] == ["dog-24-filled", "dog-sitting"]
    assert found[2:4] == ["police-dog", "poodle"]
    assert set(found[4:6]) == {"dog-plus", "man-walking-dog"}
    assert set(found[6:]) == {"dog-bowl", "hot-dog"}


@pytest.mark.parametrize(
    ("keyword", "name"),
    [
        ("motorbike", "motorcycle"),
        ("bike", "motorcycle"),
        ("puppy", "dog"),
        ("dogs", "dog"),
        ("DOG ", "dog"),
        ("mice", "mouse"),
        ("scissor", "scissors"),
        ("tea pot", "teapot"),
        ("table-lamp", "lamp-table"),
        ("home", "house"),
        ("old red house", "house"),
        ("poodle", "dog"),
    ],
)
def test_words_for_the_same_thing(opened, keyword, name):
    names = ("dog", "motorcycle", "mouse", "scissors", "teapot", "lamp-table", "house", "horse")
    assert ids(opened(small(*names)), keyword)[0] == name


def test_a_word_with_a_technical_meaning_is_no_kind_of_animal(opened):
    assert ids(opened(small("horse", "charger")), "horse") == ["horse"]


def test_two_words_must_both_be_there(opened):
    collection = opened(small("horse-bowl", "bowl", "horse", "dog-bowl"))
    assert ids(collection, "horse bowl") == ["horse-bowl"]


@pytest.mark.parametrize("keyword", ["", "  ", "--", "?!", "\U0001f1e9"])
def test_a_keyword_without_a_word(opened, keyword):
    with pytest.raises(IconstudioError, match="There is no word in"):
        opened(small("dog")).search(keyword)


def test_an_unknown_keyword_names_what_is_near(opened):
    collection = opened(small("motorcycle", "horse"))
    with pytest.raises(IconstudioError, match=r"'motorbyke'\. Did you mean motorbike"):
        collection.search("motorbyke")
    with pytest.raises(IconstudioError, match=r"No icon is called 'zzzz'\. Icons have English"):
        collection.search("zzzz")
    assert collection.suggest("hrse") == ("horse",)


@pytest.mark.parametrize(
    ("keyword", "names"),
    [
        ("barcode", ["barcode"]),
        ("bar code", ["barcode"]),
        ("merry-go-round", ["carousel"]),
        ("Merry go round", ["carousel"]),
        ("mug", ["mug"]),
        ("gull", ["gull"]),
        ("nail", ["nail", "fingernail", "thumbtack"]),
        ("organ", ["eye"]),
        ("anus", ["anus"]),
        ("ass", ["ass"]),
        ("lion", ["lion"]),
        ("cafe lion", ["lion-cafe"]),
        ("lioncafe", ["lion-cafe"]),
        ("caf\u00e9", ["lion-cafe"]),
        ("lion filled", ["lion"]),
        ("outline of a lion", ["lion"]),
        ("\U0001f981", ["lion"]),
    ],
)
def test_a_word_leads_to_what_it_commonly_means(opened, keyword, names):
    collection = opened(
        small(
            "barcode", "carousel", "mug", "gull", "nail", "fingernail", "thumbtack", "eye", "anus",
            "ass", "save-as", "lion", "lion-cafe",
        )
    )  # fmt: skip
    assert ids(collection, keyword)[: len(names)] == names
    if keyword not in ("lion", "lion filled", "outline of a lion", "\U0001f981"):
        assert ids(collection, keyword) == names


def test_a_compound_that_has_a_meaning_of_its_own_is_not_its_last_word(opened):
    collection = opened(small("lion", *several("fur-seal"), *several("harbor-seal")))
    with pytest.raises(
        IconstudioError, match=r"'sea lion'\. Of its kind there are: fur seal, harbor seal\."
    ):
        collection.search("sea lion")


def test_a_miss_proposes_other_things_of_the_kind(opened):
    collection = opened(small(*several("jug"), *several("carafe"), "horse"))
    with pytest.raises(IconstudioError, match=r"'ewer'\. Of its kind there are: carafe, jug\."):
        collection.search("ewer")


def test_a_miss_proposes_neither_what_is_hardly_ever_drawn_nor_one_kind_alone(opened):
    with pytest.raises(IconstudioError, match=r"'ewer'\. Icons have English names"):
        opened(small(*several("jug"), "carafe", "horse")).search("ewer")


@pytest.mark.parametrize("keyword", ["anos", "anuss", "organn"])
def test_no_hint_that_one_would_not_say_aloud(opened, keyword):
    collection = opened(small("anus", "horse"))
    assert "anus" not in collection.suggest(keyword)


@pytest.mark.parametrize("keyword", ["\u0434\u043e\u043c", "\u5bb6", "Zug"])
def test_another_language_is_told_that_names_are_english(opened, keyword):
    with pytest.raises(IconstudioError, match=f"'{keyword}'.*English"):
        opened(small("dog")).search(keyword)


def test_an_emoji_that_nothing_answers_is_named(opened):
    with pytest.raises(IconstudioError, match=r"\(bagel\)"):
        opened(small("dog")).search("\U0001f96f")


@pytest.mark.parametrize("spelt", ["a-dog", "a/dog", "i-a-dog", "A:Dog", "icon-[a--dog]"])
def test_identifiers_in_other_spellings(opened, spelt):
    collection = opened(small("dog", "dog-side", "horse"))
    assert collection.get(spelt).id == "a:dog"
    assert ids(collection, spelt)[0] == "dog"


def test_an_unknown_identifier_names_icons_of_that_name(opened):
    collection = opened(small("dog"), icon_set("b", {"horse": shape(9)}))
    with pytest.raises(
        IconstudioError, match=r"no icon 'b:dog'\. Of icons that look alike it has one\. Did"
    ):
        collection.get("b-dog")


def test_a_misspelt_identifier_is_not_one_of_several_that_look_alike(opened):
    with pytest.raises(IconstudioError, match=r"no icon 'a:hous'\. Did you mean a:house"):
        opened(small("house", "houses")).get("a:hous")


def test_an_identifier_forbids_nothing_whatever_its_words_say(opened):
    with pytest.raises(IconstudioError) as told:
        opened(small("dog")).search("a:no-such-zebra")
    assert "forbidden" not in str(told.value)


def test_excluded_icons_do_not_come_back(opened):
    collection = opened(icon_set("a", {"dog": shape(1), "dog-side": shape(2)}))
    assert ids(collection, "dog", exclude=frozenset({"a:dog", "a:unknown"})) == ["dog-side"]
    with pytest.raises(IconstudioError, match="is excluded"):
        collection.search("dog", exclude=frozenset({"a:dog", "a:dog-side"}))


def test_the_limit_holds(opened):
    collection = opened(small(*(f"dog-{number}x" for number in range(9))))
    assert len(ids(collection, "dog", limit=4)) == 4


def test_the_same_drawing_under_other_words_is_shown_once(opened):
    drawn = {"motorcycle": shape(1), "motorbike": shape(1).replace("M1 1.0h", "M1.01 1.0h")}
    assert len(ids(opened(icon_set("a", drawn)), "motorcycle")) == 1


@given(bitmaps)
def test_unlikeness_is_the_jaccard_distance(cells):
    packed = stack([np.packbits(one).tobytes() for one in cells])
    assert packed.shape == (5, WORDS)
    slow = [(cells[0] ^ one).sum() / max((cells[0] | one).sum(), 1) for one in cells]
    np.testing.assert_allclose(unlikeness(packed[:1], packed)[0], slow)


@given(hnp.arrays(np.uint64, st.tuples(st.integers(0, 12), st.just(WORDS))), st.integers(0, 9))
def test_different_drawings_differ_and_the_others_are_like_one_before(cells, limit):
    kept = search.different(cells, limit)
    assert kept == sorted(kept) and len(kept) <= limit
    for i, number in enumerate(kept):
        others = cells[kept[:i]]
        assert not len(others) or unlikeness(cells[[number]], others).min() >= search.ALIKE
    if len(kept) < limit:
        for number in set(range(len(cells))) - set(kept):
            before = cells[[k for k in kept if k < number]]
            assert unlikeness(cells[[number]], before).min() < search.ALIKE


@given(st.lists(st.tuples(st.integers(0, 9), st.integers(0, 100)), max_size=40))
def test_order_keeps_scores_and_mixes_shades(rows):
    icons = np.arange(len(rows))
    scores = np.array([score for score, _ in rows], dtype=np.int64)
    shades = np.array([shade for _, shade in rows], dtype=np.uint8)
    order = search.in_order(icons, scores, shades)
    assert sorted(order.tolist()) == icons.tolist()
    assert scores[order].tolist() == sorted(scores.tolist())
    for score in set(scores.tolist()):
        turns = [min(int(shades[icon]) // 20, 4) for icon in order if scores[icon] == score]
        first = turns[: len(set(turns))]
        assert len(set(first)) == len(first), "each shade comes once before any comes twice"


def test_fingerprint_ignores_place_and_size_but_not_filling():
    def ring(size, thick, at):
        y, x = np.mgrid[:96, :96] - np.array(at)[:, None, None]
        radius = np.hypot(x, y)
        return np.where((radius < size) & (radius > size - thick), 255, 0).astype(np.uint8)

    one, moved, disc = ring(40, 8, (48, 48)), ring(20, 4, (30, 60)), ring(40, 40, (48, 48))
    cells = [fingerprint(picture).cells for picture in (one, moved, disc)]
    near, far = unlikeness(stack(cells[:1]), stack(cells[1:]))[0]
    assert near < 0.1 and far > 0.4
    assert fingerprint(disc).blackness > 95 > 60 > fingerprint(one).blackness
    assert fingerprint(np.full((96, 96), 90, np.uint8)) is None


@pytest.mark.parametrize(
    ("keyword", "mentions"),
    [
        ("dog", ("hot-dog", "dog-bowl", "dog-house", "walking", "paw")),
        ("horse", ("horseshoe", "charger", "seahorse")),
        ("house", ("plus", "check", "key", "off")),
        ("fish", ("fishing", "bone", "hook")),
        ("car", ("wash", "key", "battery")),
        ("bird", ("house", "cage")),
    ],
)
def test_the_bundled_collection_shows_things_first(bundled, keyword, mentions):
    found = ids(bundled, keyword)
    assert len(found) >= 40
    assert not [name for name in found[:30] if any(word in name for word in mentions)]
    kept = [keyword in name for name in found[:20]]
    assert sum(kept) >= 15


@pytest.mark.parametrize(
    ("keyword", "word"),
    [
        ("motorbike", "motorcycle"),
        ("bike", "bicycle"),
        ("home", "house"),
        ("puppy", "dog"),
        ("aeroplane", "airplane"),
        ("automobile", "car"),
        ("couch", "sofa"),
        ("knives", "knife"),
        ("coffee cup", "coffee-cup"),
        ("table lamp", "table-lamp"),
    ],
)
def test_the_bundled_collection_knows_other_words(bundled, keyword, word):
    assert any(word in name for name in ids(bundled, keyword))


@pytest.fixture(scope="module")
def names(bundled):
    rows = bundled._rows("SELECT id FROM icon")
    return sorted({row[0].partition(":")[2] for row in rows})


def found_by_its_name(bundled, name, typed):
    """Whether what is typed finds an icon whose name has the words of ``name``."""
    wanted = {"".join(take_apart(name).words), name.replace("-", "")}
    try:
        found = bundled.search(typed)
    except IconstudioError:
        return False
    return any("".join(take_apart(one.id.partition(":")[2]).words) in wanted for one in found)


@pytest.mark.thorough
def test_every_icon_is_found_by_its_name_of_one_word(bundled, names):
    single = [name for name in names if name.isalpha()]
    assert len(single) > 3_000
    assert [name for name in single if not found_by_its_name(bundled, name, name)] == []


@pytest.mark.thorough
@pytest.mark.parametrize("between", ["-", " ", "", "_"])
def test_icons_are_found_by_their_names_of_two_words(bundled, names, between):
    double = [name for name in names if re.fullmatch("[a-z]{2,}-[a-z]{2,}", name)][::40]
    assert len(double) > 500
    missed = [
        name for name in double if not found_by_its_name(bundled, name, name.replace("-", between))
    ]
    assert missed == []


def test_results_of_the_bundled_collection_differ_and_suit_every_style(bundled):
    found = bundled.search("house")
    assert len(found) == 200 == len({one.id for one in found})
    numbers = bundled._identifiers.numbers([one.id for one in found])
    cells = bundled._cells[numbers]
    for i in range(1, len(cells)):
        assert unlikeness(cells[[i]], cells[:i]).min() >= search.ALIKE
    blackness = bundled._blackness[numbers] / 100
    for low, high in ((0, 0.4), (0.2, 0.6), (0.4, 0.8), (0.6, 1)):
        assert ((low <= blackness) & (blackness <= high)).sum() >= 25


@pytest.mark.parametrize(
    ("title", "keyword"),
    [
        ("camera 07", "camera"),
        ("camera-outline-24", "camera"),
        ("camera plus", "camera"),
        ("police dog", "police dog"),
        ("Fancy camera", "camera"),
        ("camera.svg", "camera"),
        ("unheard of", ""),
        ("", ""),
        (".svg", ""),
    ],
)
def test_a_title_says_what_icons_like_it_are_looked_for_by(opened, monkeypatch, title, keyword):
    monkeypatch.setattr("iconstudio.library.collection._FEW", 3)
    names = [f"{thing}-{number}" for thing in ("camera", "police-dog") for number in (2, 3, 4)]
    assert opened(small(*names, "camera-plus")).keyword(title) == keyword


@pytest.mark.parametrize(("foreign", "word"), [("ordinateur", "ringmaster"), ("Schuh", "church")])
def test_another_word_is_no_hint_however_many_letters_it_shares(foreign, word):
    assert nearest(foreign, [word, "computer"]) == ()


def test_what_is_spelt_much_less_like_it_is_no_hint():
    assert nearest("lampe", ["amp", "lap", "lamp", "clamp"]) == ("lamp",)
    assert nearest("tabel", ["table", "label"]) == ("table", "label")


def test_one_comes_before_several_of_a_style(opened):
    names = "stars-2-filled", "star-3-filled", "stars-filled", "star-outline"
    collection = opened(small(*names))
    assert ids(collection, "filled star") == [
        "star-3-filled", "stars-filled", "stars-2-filled", "star-outline",
    ]  # fmt: skip
    assert ids(collection, "filled stars")[0].startswith("stars-")


def test_a_word_of_another_language_that_icons_only_mention_is_told(opened):
    collection = opened(small("candle-lit", "bed", "house", "see-saw"))
    assert collection.remark("lit") == "Did you mean bed?"
    assert collection.remark("bed") == collection.remark("candle") == ""
    for word, meant in (("warenkorb", "shopping cart"), ("buscar", "search"), ("설정", "settings")):
        with pytest.raises(IconstudioError, match=f"Did you mean {meant}"):
            opened(small("shopping-cart", "search", "settings")).search(word)


def test_half_a_heart_is_neither_solid_nor_outlined(opened):
    names = "heart-half-fill", "heart-fill", "heart-outline", "half-heart"
    collection = opened(small(*names))
    found = ids(collection, "solid heart")
    assert found[:2] == ["heart-fill", "heart-half-fill"]
    assert ids(collection, "outline heart")[0] == "heart-outline"
    assert ids(collection, "half heart fill")[0] == "heart-half-fill"


def test_a_style_is_heeded_where_the_words_are_but_a_kind_of_something(opened):
    """Nothing is called *roundhouse*, which WordNet knows as a workplace."""
    names = "house", "house-rounded", "workplace", "house-sharp"
    collection = opened(small(*names))
    assert ids(collection, "round house")[0] == "house-rounded"
    assert collection.remark("round house") == ""
    assert ids(opened(small(*names, "roundhouse")), "round house")[0] == "roundhouse"


def test_a_style_that_no_icon_has_is_told(opened):
    collection = opened(small("square", "square-2", "star-rounded", "square-rounded-plus"))
    assert ids(collection, "rounded square")[0].startswith("square")
    assert "called “rounded”" in collection.remark("rounded square")
    assert collection.remark("rounded star") == collection.remark("solid square") == ""


def test_small_words_are_in_no_remark(opened, monkeypatch):
    monkeypatch.setattr("iconstudio.library.lookup._MORE", 2)
    names = [name for one in ("house", "garden", "a") for name in several(one)]
    collection = opened(small(*names, "house-with-a-garden"))
    assert "“house” and “garden”" in collection.remark("a house with a garden")
    with pytest.raises(IconstudioError, match="Alone, these words find icons: garden, house"):
        opened(small(*names)).search("a garden of a house")


@pytest.mark.parametrize(
    "typed",
    [
        "mdi-star",
        "mdi mdi-star",
        "<MdStar/>",
        '<i class="bi bi-star">',
        "star.svg",
        "MdStar",
        "fas fa-star",
        "mdiStar",
        "a-star",
        "a:star",
    ],
)
def test_a_name_as_code_writes_it_finds_the_thing(opened, typed):
    collection = opened(small("star", "star-mdi", "house"))
    assert ids(collection, typed)[0] == "star"
    assert collection.remark(typed) == ""
