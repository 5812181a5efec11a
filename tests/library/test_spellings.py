"""Search by the words that people type: short, familiar, with a hyphen, joined or parted."""

import re

import pytest
from small_world import icon_set, shape

from iconstudio.library import messages
from iconstudio.library.words import query
from iconstudio.library.words.regional import other_spellings
from iconstudio.library.words.usage import INFORMAL, STAND_INS
from iconstudio.library.words.vocabulary import words
from iconstudio.model import IconstudioError


def ids(collection, keyword):
    return [found.id.partition(":")[2] for found in collection.search(keyword)]


@pytest.mark.parametrize(
    ("typed", "spelt_out"),
    [
        ("xmas", "christmas"),
        ("xmas tree", "christmas tree"),
        ("x mas tree", "christmas tree"),
        ("old pics", "old picture"),
        ("big tnt", "big dynamite"),
        ("tee", "t shirt"),
        ("dog", "dog"),
        ("", ""),
    ],
)
def test_informal_words_are_spelt_out(typed, spelt_out):
    assert " ".join(query.spelt_out(tuple(typed.split()))) == spelt_out


def test_a_word_may_be_parted_in_two_and_in_three():
    parted = set(query.partings("jackolanterns"))
    assert {"jack olantern", "jack o lantern", "jack o lanterns"} <= parted
    assert not list(query.partings("x" * 5000))


@pytest.mark.parametrize(
    ("keyword", "names"),
    [
        ("xmas", {"christmas-hat", "christmas-horse"}),
        ("X-Mas hats", {"christmas-hat"}),
        ("doggo", {"dog"}),
        ("hotdog", {"hot-dog"}),
        ("hot-dog", {"hot-dog", "hotdog-bun"}),
        ("table-lamp", {"lamp-table"}),
        ("tablelamps", {"lamp-table"}),
        ("horse tablelamp", {"horse-table-lamp"}),
        ("horse table-lamp", {"horse-table-lamp"}),
        ("check-in", {"check-in"}),
        ("checkin", {"check-in"}),
        ("toes", {"toe"}),
        ("jack-o-lantern", {"jack-o-lantern"}),
        ("jackolantern", {"jack-o-lantern"}),
    ],
)
def test_however_it_is_spelt(opened, keyword, names):
    names_there = (
        "christmas-hat", "christmas-horse", "dog", "hot-dog", "hotdog-bun", "lamp-table",
        "horse-table-lamp", "check", "check-in", "to", "toe", "jack-o-lantern",
    )  # fmt: skip
    collection = opened(icon_set("a", {one: shape(n) for n, one in enumerate(names_there)}))
    found = ids(collection, keyword)
    assert set(found[: len(names)]) == names


def test_every_informal_word_finds_what_it_stands_for(bundled):
    missed = [
        word
        for word, meant in INFORMAL.items()
        if not (wanted := set(bundled._lookup.scores(" ".join(meant))))
        or not wanted <= set(bundled._lookup.scores(word))
    ]
    assert missed == []


@pytest.mark.parametrize(
    "feeling",
    [
        "angry", "bored", "in love", "sleepy", "nervous", "scared", "tired", "embarrassed",
        "furious", "stressed", "joyful", "disgusted", "hungry", "melancholy", "shocked",
    ],
)  # fmt: skip
def test_how_people_feel_finds_faces(bundled, feeling):
    names = ids(bundled, feeling)[:4]
    faces = re.compile("face|angry|tired|flushed|happy|sad|heart-eyes|in-love|smil|eye-heart")
    assert sum(faces.search(name) is not None for name in names) >= min(3, len(names))


@pytest.mark.parametrize(
    ("misspelt", "right"),
    [
        ("accomodation", "accommodation"),
        ("calender", "calendar"),
        ("recieve", "receive"),
        ("adress", "address"),
        ("seperate", "separate"),
        ("enviroment", "environment"),
        ("comittee", "committee"),
        ("embarased", "embarrassed"),
        ("exausted", "exhausted"),
        ("accessable", "accessible"),
        ("rythm", "rhythm"),
    ],
)
def test_a_frequent_mistake_is_told(bundled, misspelt, right):
    try:
        told = bundled.remark(misspelt) if bundled.search(misspelt) else ""
    except IconstudioError as error:
        told = str(error)
    assert f"Did you mean {right}" in told


def test_a_word_of_three_letters_is_no_hint_for_a_long_one(bundled):
    with pytest.raises(IconstudioError) as error:
        bundled.search("theif")
    assert "Did you mean" not in str(error.value)


def test_a_word_is_read_as_one_that_is_named(bundled):
    assert "“”" not in bundled.remark("scard")
    assert bundled.remark("max") == "“max” was read as “maximize”."


def test_every_word_that_has_a_stand_in_finds_it(bundled):
    missed = [
        (word, term)
        for word, terms in STAND_INS.items()
        for term in terms
        if not set(bundled._lookup.plainly(term)) & set(bundled._lookup.scores(word))
    ]
    assert missed == []


HYPHENATED = sorted(
    words(
        """
        x-mas t-shirt e-mail wi-fi x-ray u-turn ice-cream hot-dog log-in sign-out drop-down
        paw-print ear-ring head-phones smart-phone fire-works thumbs-up anti-virus co-pilot hi-fi
        check-in merry-go-round jack-o-lantern jack-in-the-box fast-forward pick-up-truck
        first-aid-kit yo-yo walkie-talkie hot-air-balloon air-bag key-ring rock-paper-scissors
        """
    )
)


@pytest.mark.parametrize("word", HYPHENATED)
def test_with_a_hyphen_or_without_one_finds_the_same(bundled, word):
    spellings = (word, word.replace("-", " "), word.replace("-", ""))
    hyphenated, spaced, joined = (set(bundled._lookup.scores(one)) for one in spellings)
    assert joined <= hyphenated == spaced


@pytest.mark.parametrize(
    ("keyword", "part"),
    [
        ("sign-in", "sign"), ("log-out", "out"), ("xmas tree", "christmas"), ("toe", "foot"),
        ("toes", "foot"), ("legs", "leg"), ("eyes", "eye"), ("arms", "arm"), ("hands", "hand"),
        ("jack-o'-lantern", "lantern"), ("bday cake", "cake"),
    ],
)  # fmt: skip
def test_what_is_meant_comes_first(bundled, keyword, part):
    assert all(part in name for name in ids(bundled, keyword)[:2])


@pytest.mark.parametrize(("keyword", "never"), [("bum", "git"), ("sole", "bottom")])
def test_a_far_fetched_word_answers_none(bundled, keyword, never):
    try:
        found = ids(bundled, keyword)
    except IconstudioError:
        found = []
    assert not [name for name in found if never in name]


@pytest.mark.parametrize(
    ("british", "american"),
    [
        ("colour", "color"), ("grey", "gray"), ("theatre", "theater"), ("licence", "license"),
        ("organiser", "organizer"), ("catalogue", "catalog"), ("labelled", "labeled"),
        ("neighbours", "neighbors"), ("analyse", "analyze"), ("metres", "meters"),
        ("coloured", "colored"), ("tyre", "tire"), ("travelling", "traveling"),
    ],
)  # fmt: skip
def test_british_and_american_spellings_lead_to_each_other(british, american):
    assert american in other_spellings(british)
    assert british in other_spellings(american)


@pytest.mark.parametrize(
    "word", ["hour", "four", "for", "your", "poet", "filing", "filling", "door"]
)
def test_a_word_that_only_looks_so_is_spelt_one_way(word):
    assert list(other_spellings(word)) == []


@pytest.mark.parametrize(
    ("one", "other"),
    [
        ("colour picker", "color picker"),
        ("colour palette", "color palette"),
        ("colour", "color"),
        ("shopping centre", "shopping center"),
        ("fire alarm theatre", "fire alarm theater"),
        ("favourite folder", "favorite folder"),
        ("car tyre", "car tire"),
        ("data centre", "data center"),
    ],
)
def test_a_phrase_finds_the_same_however_it_is_spelt(bundled, one, other):
    assert set(bundled._lookup.scores(one)) == set(bundled._lookup.scores(other))


@pytest.mark.parametrize("typed", ["bell off", "bell-slash", "bell muted", "disabled bell"])
def test_what_is_switched_off_is_found_as_its_names_say_it(opened, typed):
    names = ("bell", "bell-x", "box", "bell-plus")
    assert ids(opened(icon_set("a", {one: shape(n) for n, one in enumerate(names)})), typed) == [
        "bell-x"
    ]


@pytest.mark.parametrize(
    ("typed", "found"),
    [("no bell", ["bell-x"]), ("without gluten", ["gluten-free"]), ("no smoking", ["smoke-free"])],
)
def test_what_is_forbidden_or_missing_is_found_as_its_names_say_it(opened, typed, found):
    names = ("bell", "bell-x", "free-bell", "gluten-free", "smoke-free", "smoking")
    assert (
        ids(opened(icon_set("a", {one: shape(n) for n, one in enumerate(names)})), typed) == found
    )


@pytest.mark.parametrize(
    ("typed", "left_out"),
    [
        ("no parking", "“no” was"),
        ("🚷", "“no” was"),
        ("wifi not available", "“not” and “available” were"),
        ("turn off wifi", "“turn” and “off” were"),
    ],
)
def test_however_it_is_said_that_there_is_none_the_thing_is_shown_and_that_is_told(
    bundled, typed, left_out
):
    assert bundled.search(typed)
    assert bundled.remark(typed) == f"{left_out} left out: {messages.NO_SIGNS}"


@pytest.mark.parametrize(
    ("typed", "plainly"),
    [
        ("no wifi", "wifi off"),
        ("without wi-fi", "wifi off"),
        ("camera not allowed", "camera off"),
        ("crossed out bell", "bell slash"),
        ("user not found", "user off"),
        ("no sound", "mute"),
        ("no internet", "offline"),
        ("⛔", "not allowed"),
        ("access denied", "forbidden"),
        ("hide password", "hidden"),
    ],
)
def test_however_it_is_said_the_same_is_shown_first(bundled, typed, plainly):
    assert ids(bundled, typed)[:4] == ids(bundled, plainly)[:4]


@pytest.mark.parametrize("typed", ["crossed swords", "crossed fingers"])
def test_what_only_sounds_like_no_is_none(bundled, typed):
    with pytest.raises(IconstudioError):
        bundled.search(typed)


@pytest.mark.parametrize(
    ("typed", "parts"),
    [
        ("eye slash", ("eye-",)),
        ("power off", ("power",)),
        ("switch off", ("power",)),
        ("turn off", ("power",)),
        ("log off", ("out", "exit", "leave")),
        ("camera off", ("camera-x", "camera-cancelled")),
        ("mic off", ("microphone-cancelled",)),
        ("bluetooth off", ("bluetooth-x",)),
        ("on/off", ("power",)),
        ("on off", ("power",)),
        ("mute", ("volume-x", "speaker-x", "volume-zero", "quiet")),
        ("volume off", ("volume-x",)),
        ("no phone", ("phone-x", "phone-cross")),
        ("🚭", ("smoke-free",)),
        ("no location", ("location-x", "location-cross")),
        ("do not disturb", ("do-disturb-on",)),
        ("no results", ("search-x",)),
        ("sign up", ("user-plus", "user-add", "account-plus", "person-add")),
    ],
)
def test_what_is_off_comes_first(bundled, typed, parts):
    assert all(any(part in name for part in parts) for name in ids(bundled, typed)[:4])


def test_what_no_icon_is_switched_off_of_is_told(bundled):
    for keyword in ("spin off", "bell off mute slash", "dog off"):
        assert "“x”" not in bundled.remark(keyword)
    for word in ("off", "slash", "muted"):
        left_out = f"“{word}” was left out: {messages.NO_SIGNS}"
        assert bundled.remark(f"teapot {word}") == left_out
        assert bundled.remark(f"wifi {word}") == left_out
