"""SVG documents: one path, and everyone is thanked."""

import xml.etree.ElementTree as ET
from dataclasses import replace

import numpy as np
import pytest
from hypothesis import example, given
from hypothesis import strategies as st

from iconstudio.model import (
    CANVAS,
    ColouredLayer,
    Contour,
    Credit,
    Drawing,
    Fill,
    Frame,
    Path,
    Patterned,
    Pictogram,
    Remix,
)
from iconstudio.output.svg import credits_text, layered_document, pictogram_of, svg_document
from iconstudio.svg.check import check
from iconstudio.svg.rasterise import rasterise
from iconstudio.svg.resvg import render_coverage
from tests.output.made import RING, SOURCES, credited, titled, with_shares
from tests.shapes import outline

SVG = "{http://www.w3.org/2000/svg}"
DC = "{http://purl.org/dc/elements/1.1/}"
CC = "{http://creativecommons.org/ns#}"
RDF = "{http://www.w3.org/1999/02/22-rdf-syntax-ns#}"


def parsed(result, title="A dog"):
    return ET.fromstring(svg_document(titled(result, title)))


def works(root):
    return root.findall(f".//{RDF}li/{CC}Work")


def test_one_path_in_the_current_colour(result):
    root = parsed(result)
    assert root.tag == f"{SVG}svg"
    assert root.get("viewBox") == "0 0 256 256"
    assert (root.get("width"), root.get("height")) == ("256", "256")
    assert root.get("fill") == "currentColor"
    (path,) = root.iter(f"{SVG}path")
    assert path.attrib == {"d": result.path.svg()}
    assert root.findtext(f"{SVG}title") == "A dog"


def test_it_shows_the_drawing(result):
    document = svg_document(titled(result, "A dog"))
    check(document)
    shown = render_coverage(document, Frame(0, 0, CANVAS), 512) > 127
    drawn = result.drawing.coverage > 127
    assert (shown & drawn).sum() / (shown | drawn).sum() > 0.995


def test_every_contributor_is_credited_once(result):
    shared = with_shares(result.composite, 0.3, 0.25, 0.45, 0.0)
    assert [one.id for one in shared.contributors] == ["test:ring", "test:block"]
    root = parsed(replace(result, composite=shared))
    assert [work.findtext(f"{DC}identifier") for work in works(root)] == ["test:ring", "test:block"]


def test_a_credit_names_title_author_licence_and_address(result):
    credit = Credit("Ring", "Ann Other", "CC-BY-4.0", "https://example.org/by", "https://a.org/r")
    sources = (replace(SOURCES[0], exemplar=credited(RING, credit)), *SOURCES[1:])
    one = replace(result.composite, sources=sources, shares=(1.0, 0.0, 0.0, 0.0))
    (work,) = works(parsed(replace(result, composite=one)))
    assert work.findtext(f"{DC}title") == "Ring"
    assert work.findtext(f"{DC}creator") == "Ann Other"
    assert work.findtext(f"{DC}rights") == "CC-BY-4.0"
    assert work.find(f"{CC}license").get(f"{RDF}resource") == "https://example.org/by"
    assert work.find(f"{DC}source").get(f"{RDF}resource") == "https://a.org/r"
    assert credits_text(titled(result, "x", one)) == (
        "Made of parts of:\n"
        "“Ring” by Ann Other, CC-BY-4.0 (https://example.org/by), https://a.org/r"
    )


def test_a_licence_without_address(result):
    credit = Credit("Ring", "Ann Other", "MIT", "", "https://a.org/r")
    sources = (replace(SOURCES[0], exemplar=credited(RING, credit)), *SOURCES[1:])
    one = replace(result.composite, sources=sources, shares=(1.0, 0.0, 0.0, 0.0))
    (work,) = works(parsed(replace(result, composite=one)))
    assert work.find(f"{CC}license") is None
    assert credits_text(titled(result, "x", one)).endswith("by Ann Other, MIT, https://a.org/r")


def test_a_credit_leaves_out_what_nobody_knows(result):
    credit = Credit("logo.svg", "Ann Other", "licence not stated", "", "")
    sources = (replace(SOURCES[0], exemplar=credited(RING, credit)), *SOURCES[1:])
    one = replace(result.composite, sources=sources, shares=(1.0, 0.0, 0.0, 0.0))
    assert credits_text(titled(result, "x", one)).endswith(
        "\n“logo.svg” by Ann Other, licence not stated"
    )


def made_of(result, pictogram, *shares, label=0):
    """The result's composite with another pictogram in the place of a source."""
    own = replace(SOURCES[label].exemplar, pictogram=pictogram)
    sources = list(result.composite.sources)
    sources[label] = replace(sources[label], exemplar=own)
    return with_shares(replace(result.composite, sources=tuple(sources)), *shares)


def test_a_result_is_a_pictogram_that_draws_itself(result):
    one = pictogram_of(titled(result, "Dog & Cat!"))
    assert one.id.startswith("made:dog-cat-")
    assert len(one.id) == len("made:dog-cat-") + 8
    assert one.svg == svg_document(titled(result, "Dog & Cat!"))
    assert one.credit.title == "Dog & Cat!"
    assert one.origins == one.made_of == result.composite.contributors
    _, coverage = rasterise(one.svg)
    assert (coverage > 127).sum() > 1000


def test_different_drawings_have_different_names(result):
    other = replace(result, path=Path((Contour((0, 0), (((9, 0),), ((9, 9),))),)))
    names = [pictogram_of(one).id for one in (result, other)]
    assert len(set(names)) == 2


@pytest.mark.parametrize(
    ("title", "words"), [("", "icon"), ("?!", "icon"), ("Straße_7", "strasse-7"), ("犬", "犬")]
)
def test_any_title_gives_a_name(result, title, words):
    name = pictogram_of(titled(result, title)).id
    assert name.rpartition("-")[0] == f"made:{words}"
    assert len(pictogram_of(titled(result, "long " * 99)).id) < 60


def test_a_made_icon_names_the_licences_of_its_parts(result):
    def part(name, licence):
        return Pictogram(name, "", Credit(name, "Ann", licence, "", ""))

    parts = part("a:a", "MIT"), part("a:b", "CC-BY-4.0"), part("a:c", "MIT")
    first = Pictogram("made:x", "", Credit("x", "you", "", "", ""), parts)
    one = pictogram_of(titled(result, "Dog", made_of(result, first, 1.0, 0, 0, 0)))
    assert one.credit.license == "MIT, CC-BY-4.0"


def test_what_was_made_of_results_credits_their_sources(result):
    """Twice over: a result of a result of a result."""
    first = pictogram_of(titled(result, "One", with_shares(result.composite, 0.5, 0.1, 0.4, 0)))
    assert [one.id for one in first.made_of] == ["test:ring", "test:block"]
    second = pictogram_of(titled(result, "Two", made_of(result, first, 0.2, 0, 0, 0.8)))
    assert [one.id for one in second.made_of] == ["test:disc", "test:ring", "test:block"]
    # The block's own 0.3 and its third of 0.6 are more than the others' thirds.
    third = made_of(result, second, 0.6, 0.1, 0.3, 0)
    assert [one.id for one in third.contributors] == ["test:block", "test:ring", "test:disc"]
    root = parsed(replace(result, composite=third))
    assert [w.findtext(f"{DC}identifier") for w in works(root)] == [
        "test:block",
        "test:ring",
        "test:disc",
    ]
    assert "made:" not in credits_text(titled(result, "x", third))


def test_an_origin_read_from_credits_is_the_icon_itself(result):
    """Its drawing is not known, but it is not thanked twice for that."""
    ring = replace(RING.pictogram, svg="")
    saved = Pictogram("own:saved", "<svg/>", Credit("saved", "you", "", "", ""), (ring,))
    both = made_of(result, saved, 0.4, 0, 0.6, 0, label=2)
    assert [one.id for one in both.contributors] == ["test:ring"]


def test_an_empty_drawing_credits_nobody(result):
    drawing = Drawing(Path(), np.zeros((512, 512), np.uint8))
    nobody = with_shares(result.composite, 0, 0, 0, 0)
    empty = Remix.of(nobody, drawing, result.score, "Nothing")
    root = ET.fromstring(svg_document(empty))
    assert works(root) == []
    assert credits_text(empty) == ""


@example(title="a\r\n<b>", author="&amp; ]]>")
@given(
    title=st.text(
        st.characters(exclude_categories=["Cs", "Cc"]) | st.sampled_from("\n\t\r<>&'\"]")
    ),
    author=st.text(st.characters(exclude_categories=["Cs", "Cc"]) | st.sampled_from("<>&'\"]")),
)
def test_any_text_survives(result, title, author):
    title, author = (text.replace("\ufffe", "").replace("\uffff", "") for text in (title, author))
    credit = Credit(title, author, "MIT", "https://a.org/?a=1&b='<\">", "https://a.org")
    sources = (replace(SOURCES[0], exemplar=credited(RING, credit)), *SOURCES[1:])
    one = replace(result.composite, sources=sources, shares=(1.0, 0.0, 0.0, 0.0))
    root = parsed(replace(result, composite=one), title)
    (work,) = works(root)
    assert root.findtext(f"{SVG}title") == title
    assert work.findtext(f"{DC}title") == title
    assert work.findtext(f"{DC}creator") == author
    licence = work.find(f"{CC}license").get(f"{RDF}resource")
    assert licence == credit.license_url
    assert len(list(root.iter(f"{SVG}path"))) == 1


@pytest.mark.parametrize("bad", ["\x00", "\x0b", "\x1f", "\ufffe", "\ud800"])
def test_what_xml_cannot_hold_is_replaced(result, bad):
    assert parsed(result, f"a{bad}b").findtext(f"{SVG}title") == "a\ufffdb"


def test_layers_are_groups_with_names_and_the_usual_colour_is_said_once():
    shape = Path((Contour((0, 0), (((8, 0),), ((8, 8),))),))
    fills = tuple(Fill(shape, colour) for colour in ("#ff0000", "#00ff00", "#ff0000"))
    layers = [ColouredLayer("below", fills), ColouredLayer("<above>", (Fill(shape),))]
    svg = layered_document("Two & more", (), layers, (30, 20.5), "#123456")
    root = ET.fromstring(svg)
    check(svg)
    assert (root.get("width"), root.get("height"), root.get("viewBox")) == (
        "30", "20.5", "0 0 30 20.5",
    )  # fmt: skip
    ground, below, above = list(root)[-3:]
    assert ground.get("fill") == "#123456" and below.get("id") == "below"
    assert below.get("fill") == "#ff0000"
    assert [one.get("fill") for one in below] == [None, "#00ff00", None]
    assert above.get("id") == "<above>" and above.get("fill") is None
    plain = ET.fromstring(layered_document("", (), layers, (30, 20.5)))
    assert [one.get("id") for one in list(plain)[-2:]] == ["below", "<above>"]


def test_a_pattern_goes_on_in_ink_and_paper_without_its_ground():
    white, blue = (outline([(x, 20), (x + 80, 20), (x + 80, 90), (x, 90)]) for x in (-20, 150))
    layer = ColouredLayer("layer-1", (Fill(white, "#ffffff"), Fill(blue, "#17375e")))
    path = Path((*white.contours, *blue.contours))
    icon = Patterned(
        path, "pattern", layers=(layer,), ground="#d8e8f2", width=256, height=128, tile=True, torn=0
    )
    one = pictogram_of(icon)
    assert one.remarks == (), "it ends at its borders anyway"
    ink = render_coverage(one.svg, Frame(0, 0, CANVAS), CANVAS) > 127
    assert ink.sum() == (60 + 80) * 70, "the pale one is there, the ground is not"
