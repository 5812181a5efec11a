"""Of what cannot be read, it is told which part it is."""

import copy
import xml.etree.ElementTree as ET

import pytest
from hypothesis import given
from hypothesis import strategies as st

from iconstudio.model import IconstudioError
from iconstudio.svg import plain
from iconstudio.svg.culprit import culprit
from iconstudio.svg.reading import own_svg
from tests.svg.test_check import svg


def is_readable(root):
    return not any("bad" in one.attrib.values() or one.tag == "bad" for one in root.iter())


@pytest.mark.parametrize(
    ("text", "told"),
    [
        ('<svg><g><path d="M0"/></g><g><path/><path id="x" d="bad"/></g></svg>', '<path d="bad">'),
        ('<svg><g id="a"><bad id="b"/></g><path/></svg>', '<bad id="b">'),
        ('<svg><bad id="b"><bad/></bad></svg>', '<bad id="b">'),
        ('<svg width="bad"><g/></svg>', '<svg width="bad">'),
        ('<svg><bad/><g><path/><bad/></g></svg>', None),
        ('<svg><bad a="{}"/></svg>', '<bad a="0123'),
    ],
)  # fmt: skip
def test_the_smallest_part_is_told(text, told):
    root = ET.fromstring(text.format("0123" * 30))
    before = ET.tostring(root)
    found = culprit(root, is_readable)
    assert found == told or (found.startswith(told) and len(found) < 70)
    assert ET.tostring(root) == before


trees = st.recursive(
    st.builds(lambda tag: ET.Element(tag), st.sampled_from(["path", "rect"])),
    lambda parts: st.lists(parts, max_size=5).map(lambda found: _group(found)),
    max_leaves=20,
)


def _group(parts):
    group = ET.Element("g")
    group.extend(copy.deepcopy(parts))
    return group


@given(trees, st.randoms(use_true_random=False))
def test_one_mistake_is_found_wherever_it_is(tree, random):
    root = ET.Element("svg")
    root.append(tree)
    for number, element in enumerate(root.iter()):
        element.set("id", str(number))
    wrong = random.choice(list(root.iter()))
    wrong.set("fill", "bad")
    assert culprit(root, is_readable) == f'<{wrong.tag} fill="bad">'


def test_a_part_that_nobody_foresaw_is_told(monkeypatch):
    real = plain.cut_off_mistakes

    def fail(drawn):
        drawn = list(drawn)
        if any(one.get("d", "").startswith("M7") for one in drawn):
            raise ValueError
        return real(drawn)

    monkeypatch.setattr(plain, "cut_off_mistakes", fail)
    drawing = svg('<g><path d="M1 1h9v9z"/><path d="M7 7h3v4z"/></g>').encode()
    with pytest.raises(IconstudioError) as caught:
        own_svg(drawing, "a.svg")
    assert str(caught.value) == (
        '“a.svg” cannot be used. The part <path d="M7 7h3v4z"> of it is not understood. '
        "Leave it out, or save the drawing as plain SVG."
    )
