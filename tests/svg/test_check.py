from unittest.mock import patch

import pytest
from hypothesis import given
from hypothesis import strategies as st

from iconstudio.model import IconstudioError
from iconstudio.svg import check as svgcheck
from iconstudio.svg.check import MAX_BYTES, MAX_DEPTH, MAX_ELEMENTS, check


def svg(body, attributes=""):
    return (
        '<svg xmlns="http://www.w3.org/2000/svg" xmlns:xlink="http://www.w3.org/1999/xlink"'
        f' viewBox="0 0 24 24" {attributes}>{body}</svg>'
    )


def entity_bomb():
    lines = "".join(f'<!ENTITY e{i} "' + f"&e{i - 1};" * 10 + '">' for i in range(1, 10))
    return f'<!DOCTYPE svg [<!ENTITY e0 "ha">{lines}]>' + svg("<text>&e9;</text>")


def nested_use(levels, copies):
    groups = '<g id="a0"><path d="M0 0h1v1z"/></g>'
    for i in range(1, levels):
        groups += f'<g id="a{i}">' + f'<use href="#a{i - 1}"/>' * copies + "</g>"
    return svg(f'<defs>{groups}</defs><use href="#a{levels - 1}"/>')


def nested_pattern(levels):
    patterns = "".join(
        f'<pattern id="p{i}" width="1" height="1">'
        f'<rect width="9" height="9" fill="url(#p{i + 1})"/></pattern>'
        for i in range(levels)
    )
    return svg(f'{patterns}<rect width="9" height="9" fill="url(#p0)"/>')


HOSTILE = {
    "entity bomb": (entity_bomb(), "DOCTYPE"),
    "document type": ('<!DOCTYPE svg [<!ATTLIST svg x CDATA "y">]>' + svg(""), "DOCTYPE"),
    "deep": (svg("<g>" * 5000 + "</g>" * 5000), "deep"),
    "deep by reference": (nested_use(80, 1), "deep"),
    "a thousand million copies": (nested_use(10, 10), "repeats"),
    "nested pattern": (nested_pattern(2), "pattern"),
    "pattern in a style": (
        svg(
            '<pattern id="p"><rect style="fill:url(#q)"/></pattern>'
            '<pattern id="q"><rect/></pattern><rect fill="url(#p)"/>'
        ),
        "pattern",
    ),
    "pattern in a style sheet": (
        svg(
            '<style>@media all{/* } */.a , .b{fill:url("#q")}</style>'
            '<pattern id="p"><rect class="b"/></pattern><pattern id="q"><rect/></pattern>'
        ),
        "pattern",
    ),
    "style sheet for a tag": (svg("<style>rect{fill:url(#q)}</style>"), "style sheet"),
    "style sheet that multiplies": (
        svg("<style>" + ".a{fill:url(#b)}" * 50_000 + "</style>" + '<g class="a"/>' * 10_000),
        "repeats",
    ),
    "circle": (svg('<g id="a"><use xlink:href="#b"/></g><g id="b"><use href="#a"/></g>'), "circle"),
    "external image": (svg('<image href="https://example.org/a.png"/>'), "bitmap"),
    "embedded image": (svg('<image href="data:image/png;base64,AAAA"/>'), "bitmap"),
    "image filter": (svg('<filter id="f"><feImage href="a.svg"/></filter>'), "bitmap"),
    "external use": (svg('<use href="other.svg#a"/>'), "outside"),
    "external paint": (svg('<path fill="url(other.svg#a)"/>'), "outside"),
    "script": (svg("<script>alert(1)</script>"), "script"),
    "NUL": (svg("<path d='M0 0\0'/>"), "well-formed"),
    "lone surrogate": (svg("\ud800"), "Unicode"),
    "no XML": ("what is this?", "well-formed"),
    "empty": ("", "well-formed"),
    "unclosed": (svg("<g>"), "well-formed"),
    "another language": ("<html/>", "root"),
    "undefined entity": (svg("&nbsp;"), "well-formed"),
    "50 MB": (svg(f"<text>{'x' * 50_000_000}</text>"), "bytes"),
    "too many bytes": (svg(" " * MAX_BYTES), "bytes"),
    "too many elements": (svg("<g/>" * MAX_ELEMENTS), "elements"),
}


@pytest.mark.parametrize("kind", HOSTILE)
def test_what_is_hostile_is_refused_in_a_sentence(kind):
    document, word = HOSTILE[kind]
    with pytest.raises(IconstudioError, match=word) as caught:
        check(document)
    assert str(caught.value).endswith(".")
    assert len(str(caught.value)) < 250


HARMLESS = {
    "5,000 elements": svg("<path d='M0 0h1v1z'/>" * 5000),
    "a mention of the SVG 1.1 DTD": '<?xml version="1.0" encoding="UTF-16"?><!DOCTYPE svg PUBLIC '
    '"-//W3C//DTD SVG 1.1//EN" "http://www.w3.org/Graphics/SVG/1.1/DTD/svg11.dtd">' + svg("<g/>"),
    "one pattern": nested_pattern(1),
    "some copies": nested_use(3, 10),
    "a link": svg('<a href="https://example.org"><path d="M0 0h1v1z"/></a>'),
    "an animation of its parent": svg('<g id="a"><animate href="#a" attributeName="x"/></g>'),
    "a dangling reference": svg('<use href="#nothing"/><path fill="url(#nothing)"/>'),
    "a style sheet": svg("<style>.a{fill:url(#g)}path{fill:red}</style><path class='a b'/>"),
    "metadata": svg(
        '<metadata xmlns:r="http://www.w3.org/1999/02/22-rdf-syntax-ns#">'
        '<r:a r:resource="https://example.org"/></metadata>'
    ),
    "a prefix": '<s:svg xmlns:s="http://www.w3.org/2000/svg"><s:g/></s:svg>',
    "depth": svg("<g>" * (MAX_DEPTH - 1) + "</g>" * (MAX_DEPTH - 1)),
}


@pytest.mark.parametrize("kind", HARMLESS)
def test_what_is_harmless_passes(kind):
    check(HARMLESS[kind])


LONG = {
    "style without rules": svg(f"<style>{'a' * 1_900_000}</style>"),
    "comments without end": svg(f"<style>{'/*' * 900_000}</style>"),
    "braces": svg(f"<style>{'{' * 1_900_000}</style>"),
    "classes": svg('<style>.b{fill:url(#c)}</style><g class="' + "a " * 900_000 + '"/>'),
}


@pytest.mark.parametrize("kind", LONG)
@pytest.mark.timeout(60)
def test_the_check_takes_time_in_proportion(kind):
    check(LONG[kind])  # in proportion to the square, it would take hours


@st.composite
def references(draw):
    """For each of several groups, the numbers of the later groups that it repeats."""
    size = draw(st.integers(1, 6))
    later = [st.integers(number + 1, size - 1) for number in range(size - 1)]
    return [*(draw(st.lists(numbers, max_size=3)) for numbers in later), []]


@given(references())
def test_copies_count_as_if_they_were_written_out(groups):
    def drawn(number):
        return 1 + sum(1 + drawn(other) for other in groups[number])

    body = "".join(
        f'<g id="g{number}">' + "".join(map('<use href="#g{}"/>'.format, others)) + "</g>"
        for number, others in enumerate(groups)
    )
    total = 1 + sum(map(drawn, range(len(groups))))
    with patch.object(svgcheck, "MAX_EXPANSION", total):
        check(svg(body))
    with (
        patch.object(svgcheck, "MAX_EXPANSION", total - 1),
        pytest.raises(IconstudioError, match="repeats"),
    ):
        check(svg(body))
