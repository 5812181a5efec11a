"""Which words of the collection are misspelt, by a small WordNet."""

from collections import Counter

import pytest
from hypothesis import given
from hypothesis import strategies as st
from small_world import write_wordnet

from iconstudio.library.words.misspellings import misspellings
from iconstudio.library.words.nearness import is_one_mistake
from iconstudio.library.words.wordnet import WordNet

RIGHT = {"teapot": 60, "scissors": 60, "horse": 60, "mouse": 60, "poodle": 60}


@pytest.fixture(scope="module")
def wordnet(tmp_path_factory):
    folder = tmp_path_factory.mktemp("words") / "wordnet"
    write_wordnet(folder / "dict")
    return WordNet(folder)


@pytest.mark.parametrize(
    ("word", "count", "right"),
    [
        ("teapt", 1, "teapot"),
        ("teapoot", 1, "teapot"),
        ("taepot", 1, "teapot"),
        ("teapod", 1, "teapot"),
        ("sissors", 2, "scissors"),
        ("teapots", 1, None),  # several
        ("teapt", 9, None),  # not so rare
        ("tapt", 1, None),  # two mistakes
        ("xeapot", 1, None),  # another beginning
        ("house", 1, None),  # a word of its own
        ("horsey", 1, None),  # made of the word
    ],
)
def test_misspelt_words(wordnet, word, count, right):
    found = misspellings(Counter({**RIGHT, word: count}), wordnet)
    assert found == ({word: right} if right else {})


LETTERS = st.text(alphabet="abc", min_size=1, max_size=5)


@given(LETTERS, LETTERS)
def test_one_mistake_is_one_step_away(word, other):
    near = {word[:i] + word[i + 1 :] for i in range(len(word))}
    near |= {word[:i] + c + word[i:] for i in range(len(word) + 1) for c in "abc"}
    near |= {word[:i] + c + word[i + 1 :] for i in range(len(word)) for c in "abc"}
    near |= {word[:i] + word[i : i + 2][::-1] + word[i + 2 :] for i in range(len(word) - 1)}
    if word != other:
        assert is_one_mistake(word, other) == (other in near)
