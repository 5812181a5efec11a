"""Names taken apart, and what they say about the drawing."""

import pytest
from hypothesis import given
from hypothesis import strategies as st
from small_world import write_wordnet

from iconstudio.library.words.inflections import is_irregular, singulars, verb_forms, verbs
from iconstudio.library.words.naming import is_negated, take_apart
from iconstudio.library.words.readings import (
    BADGED,
    COMPOUND,
    EXACT,
    MENTION,
    POSED,
    SCENE,
    readings,
)
from iconstudio.library.words.wordnet import WordNet


@pytest.fixture(scope="module")
def wordnet(tmp_path_factory):
    folder = tmp_path_factory.mktemp("words") / "wordnet"
    write_wordnet(folder / "dict")
    return WordNet(folder)


@pytest.mark.parametrize(
    ("name", "words", "styles", "size"),
    [
        ("dog", "dog", "", None),
        ("dog-side-24-filled", "dog side", "filled", 24),
        ("heart-outline-24px", "heart", "outline", 24),
        ("outline-home", "home", "outline", None),
        ("home-2-line", "home", "line", None),
        ("balls2-duotone", "balls", "duotone", None),
        ("traffic-light-bold", "traffic light", "bold", None),
        ("light-bulb", "light bulb", "", None),
        ("heart-broken-outline", "heart broken", "outline", None),
        ("home-broken", "home", "broken", None),
        ("outline", "outline", "", None),
        ("24-hours", "hours", "", None),
    ],
)
def test_take_apart(name, words, styles, size):
    parts = take_apart(name)
    assert (parts.phrase, " ".join(parts.styles), parts.size) == (words, styles, size)


@given(st.from_regex(r"[a-z0-9]{1,9}(-[a-z0-9]{1,9}){0,5}", fullmatch=True))
def test_a_name_always_leaves_words(name):
    parts = take_apart(name)
    assert parts.words and all(parts.words)
    assert set("".join(parts.words)) <= set(name)


def test_sizes_of_one_drawing_are_told_from_other_drawings():
    small, large, other = map(take_apart, ("dog-16-bold", "dog-48-bold", "dog-2-16-bold"))
    assert small.drawing == large.drawing != other.drawing


def test_negations():
    assert is_negated(("dog", "off")) and is_negated(("no", "dog"))
    assert not is_negated(("office",))


@pytest.mark.parametrize(
    ("name", "term", "tier"),
    [
        ("dog", "dog", EXACT),
        ("dogs", "dog", EXACT),
        ("sitting-dog", "dog", POSED),
        ("dog-left", "dog", POSED),
        ("police-dog", "dog", COMPOUND),
        ("bowl-of-apple", "bowl", COMPOUND),
        ("dog-plus", "dog", BADGED),
        ("dog-cracked", "dog", BADGED),
        ("broken-dog", "dog", BADGED),
        ("circle-dog", "dog", BADGED),
        ("person-walking-dog", "dog", SCENE),
        ("dog-bowl", "dog", MENTION),
        ("dog-bowl", "bowl", COMPOUND),
        ("hot-dog", "dog", MENTION),
        ("hot-dog", "hot dog", EXACT),
        ("tic-tac-toe", "toe", MENTION),
        ("table-lamp", "table lamp", EXACT),
        ("lamp-table", "table lamp", EXACT),
        ("tea-pot", "teapot", EXACT),
        ("scissor", "scissors", EXACT),
    ],
)
def test_readings(wordnet, name, term, tier):
    assert readings(take_apart(name).words, wordnet)[term] == tier


@pytest.mark.parametrize(
    ("plural", "singular"),
    [
        ("dogs", "dog"),
        ("mice", "mouse"),
        ("boxes", "box"),
        ("churches", "church"),
        ("ponies", "pony"),
        ("police cars", "police car"),
        ("coffee knives", "coffee knife"),
        ("geese", "goose"),
        ("wolves", "wolf"),
        ("toes", "toe"),
        ("shoes", "shoe"),
        ("heroes", "hero"),
        ("lenses", "lens"),
        ("bookshelves", "bookshelf"),
        ("feet", "foot"),
        ("teeth", "tooth"),
        ("policemen", "policeman"),
        ("grandchildren", "grandchild"),
        ("dice", "die"),
        ("cacti", "cactus"),
        ("giraffes", "giraffe"),
        ("vertebrae", "vertebra"),
    ],
)
def test_singulars(plural, singular):
    assert singular in singulars(plural)


@pytest.mark.parametrize(
    ("plural", "singular"),
    [("toes", "toe"), ("waves", "wave"), ("caves", "cave"), ("roses", "rose"), ("boxes", "box")],
)
def test_the_likeliest_singular_comes_first(plural, singular):
    assert next(iter(singulars(plural))) == singular


@pytest.mark.parametrize("word", ["dogs", "glasses", "omen", "news", "beef"])
def test_regular_plurals_and_words_of_other_ends_are_not_irregular(word):
    assert not is_irregular(word)


@pytest.mark.parametrize(
    ("verb", "forms"),
    [
        ("run", "running ran"),
        ("swim", "swimming swam swum"),
        ("ride", "riding rode ridden"),
        ("dance", "dancing danced"),
        ("carry", "carrying carried"),
        ("play", "playing played"),
        ("travel", "travelling traveling travelled traveled"),
    ],
)
def test_verb_forms(verb, forms):
    assert set(forms.split()) <= set(verb_forms(verb))
    assert all(verb in verbs(form) for form in forms.split())


@pytest.mark.parametrize(("verb", "wrong"), [("run", "runing"), ("swim", "swiming")])
def test_of_a_short_verb_the_last_letter_is_doubled(verb, wrong):
    assert wrong not in verb_forms(verb)


@pytest.mark.parametrize("word", ["as", "new", "ga"])
def test_a_word_is_no_half_of_a_plural(wordnet, word):
    assert wordnet.lemma(word) == word


def test_kinds(wordnet):
    assert wordnet.is_kind_of("poodle", "dog") and wordnet.is_kind_of("poodle", "canine")
    assert not wordnet.is_kind_of("dog", "poodle") and not wordnet.is_kind_of("hot dog", "dog")
