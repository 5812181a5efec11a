"""What would take minutes is refused at once; what leads in a circle, or nowhere, is left out."""

import pytest

from iconstudio.model import IconstudioError
from iconstudio.svg import matching, stylesheet
from iconstudio.svg.textpaths import CUT_OFF
from tests.svg.pictures import PATH, assert_shows, read, svg

pytestmark = pytest.mark.thorough(but=1)


def scribble(points):
    return "".join(f"L{i * 37 % 100} {i * 53 % 97}" for i in range(points))


HEAVY = {
    "a line across the page": (
        svg(f'<path fill="none" stroke="#000" d="M0 0{scribble(40_000)}"/>'),
        "cross the page more than 6,000 times",
    ),
    "a polygon": (
        svg(f'<polygon points="0 0 {scribble(40_000).replace("L", " ")}"/>'),
        "cross the page more than 6,000 times",
    ),
    "selectors that look everywhere": (
        svg(
            "<style>"
            + "".join(f".a{i} * * * * * * * *{{fill:red}}" for i in range(9))
            + "</style>"
            + "<g>" * 40
            + PATH
            + "</g>" * 40
        ),
        "style rules apply too often, or look too far",
    ),
}


@pytest.mark.parametrize("kind", HEAVY)
def test_what_takes_too_long_is_refused_before(kind):
    document, told = HEAVY[kind]
    with pytest.raises(IconstudioError, match=told):
        read(document)


@pytest.mark.parametrize("last", ["*", "path", ".b", ":not(:nth-child(2n+1))"])
def test_style_rules_that_cannot_all_be_tried_are_not_all_read(last, monkeypatch):
    read_so_far = []
    monkeypatch.setattr(
        stylesheet, "compiled", lambda one: read_so_far.append(one) or matching.compiled(one)
    )
    rules = "".join(f".a{i} * * {last}{{fill:red}}" for i in range(3000))
    with pytest.raises(IconstudioError, match="apply too often"):
        read(svg(f"<style>{rules}</style>" + '<path class="b" d="M0 0h9v9z"/>' * 4000))
    assert len(read_so_far) < 300


def test_many_rules_for_few_elements_are_read():
    rules = "".join(f".a{i} path{{fill:red}}" for i in range(2000))
    read(svg(f"<style>{rules}</style>" + PATH * 50))


def test_many_points_that_go_their_way_are_read():
    coast = "".join(f"L{i / 2000:.4f} {20 + i % 2 / 9:.2f}" for i in range(40_000))
    assert not read(svg(f'<path d="M0 20{coast}V4H0z"/>')).remarks


CIRCLES = {
    "one": '<g id="a"><use href="#a"/>{0}</g>',
    "two": '<g id="a"><use href="#b"/>{0}</g><g id="b"><use href="#a"/></g>',
    "in a pattern": '<pattern id="p" width="9" height="9"><path d="M0 0h9" fill="url(#p)"/>'
    '</pattern>{0}<path d="M1 1h2v1z" fill="url(#p)"/>',
    "in a mask": '<mask id="m"><path fill="#fff" d="M0 0h24v24H0z" mask="url(#m)"/></mask>'
    '<g mask="url(#m)">{0}</g>',
    "in a gradient": '<linearGradient id="g" href="#h"/><linearGradient id="h" href="#g">'
    '<stop/></linearGradient><g fill="url(#g)">{0}</g>',
}


@pytest.mark.parametrize("kind", CIRCLES)
def test_of_what_leads_in_a_circle_the_rest_is_read(kind):
    assert_shows(svg(CIRCLES[kind].format(PATH)), PATH, remarks=["leads back to where it is"])


def test_two_copies_of_one_shape_are_no_circle():
    copies = f'<defs><g id="a">{PATH}</g><g id="b"><use href="#a"/></g></defs>'
    assert_shows(svg(f'{copies}<use href="#b"/><use href="#a"/>'), PATH)


@pytest.mark.parametrize(
    ("attributes", "words", "cut"),
    [
        ("", "BADGE OF HONOUR", True),
        ("", "BADGE OF", False),
        ('startOffset="60%"', "BADGE OF", True),
        ('text-anchor="middle" startOffset="50%"', "BADGE OF HON", False),
        ('text-anchor="middle"', "BADGE", True),
    ],
)
def test_letters_that_fall_off_their_path_are_told(attributes, words, cut):
    path = '<path id="p" d="M15 60a35 35 0 0 1 70 0" fill="none"/>'
    text = f'<text font-size="12"><textPath href="#p" {attributes}>{words}</textPath></text>'
    assert (CUT_OFF in read(svg(path + text, 'viewBox="0 0 100 100"')).remarks) == cut


@pytest.mark.parametrize(
    "body", ['<use href="#no"/>', '<path fill="url(#no)" d="M0 0h9v9z"/>', '<g stroke="url(#no)"/>']
)
def test_what_refers_to_nothing_is_told_where_it_is_drawn(body):
    told = ["“#no” is not in the file, so what refers to it was left out."]
    shown = body if "<g" not in body else f"{body[:-2]}>{PATH}</g>"
    assert_shows(svg(shown + PATH), PATH, remarks=told)
    assert_shows(svg(f"<defs>{body}</defs>{PATH}"), PATH)


@pytest.mark.parametrize(
    ("document", "told"),
    [
        (bytes(1000), "nothing but zeros: it is damaged"),
        (b"  \n", "The file is empty"),
        (
            svg('<path d="M1 1L9 9" stroke="#000" stroke-width="1e9"/>').encode(),
            r"out of all scale: 1e\+09 by .* Correct the shape, the width of a stroke",
        ),
    ],
)
def test_why_a_drawing_cannot_be_read(document, told):
    with pytest.raises(IconstudioError, match=told):
        read(document)
