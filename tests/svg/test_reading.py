"""Files of the user's own: good ones, with their credits, and all kinds of bad ones."""

import os
from dataclasses import replace

import pytest

from iconstudio.model import Credit, IconstudioError, Pictogram
from iconstudio.output.svg import credits_text, svg_document
from iconstudio.svg.check import MAX_DEPTH, check
from iconstudio.svg.credits import UNLICENSED, UNNAMED
from tests.output.made import BLOCK, RING, SOURCES, credited, made, quarters, titled, with_shares
from tests.svg.pictures import ink, read
from tests.svg.test_check import HARMLESS, HOSTILE, svg

pytestmark = pytest.mark.thorough(but=1)

SQUARE = '<path d="M4 4h16v16H4z"/>'


@pytest.fixture
def file(tmp_path):
    """Return a function that writes a file and returns its path."""

    def write(content, name="logo.svg"):
        path = tmp_path / name
        path.write_bytes(content if isinstance(content, bytes) else content.encode())
        return path

    return write


def refusal(session, reference):
    """Return the sentence that says what is wrong with a file."""
    with pytest.raises(IconstudioError) as caught:
        session.icon(str(reference))
    sentence = str(caught.value)
    assert sentence.startswith(f"“{reference}” cannot be used. ")
    assert sentence.endswith(".")
    return sentence


def test_a_drawing_is_read_with_its_name(session, file):
    own = session.icon(str(file(svg(SQUARE), "Mein Haus.svg")))
    assert own.id.startswith("own:Mein Haus-")
    assert own.credit == Credit("Mein Haus.svg", UNNAMED, UNLICENSED, "", "")
    assert (own.made_of, own.remarks) == ((), ())
    assert session.exemplar(own).ink.sum() == 224 * 224


def test_the_name_tells_two_drawings_apart_and_one_from_its_next_version():
    first = read(svg(SQUARE), "logo.svg")
    changed = read(svg(SQUARE + SQUARE), "logo.svg")
    assert first.id == read(svg(SQUARE), "copy/logo.svg").id != changed.id


@pytest.mark.parametrize("kind", sorted(HARMLESS.keys() - {"a prefix", "depth", "some copies"}))
def test_what_is_harmless_is_read(kind):
    document = HARMLESS[kind]
    end = document.rindex("</")
    drawn = read(document[:end] + SQUARE + document[end:])
    assert "<path" in drawn.svg


LEFT_OUT = ("external image", "embedded image", "external use", "external paint", "script")
"""Kinds of hostile documents of which the rest is drawn, with a remark."""


@pytest.mark.parametrize("kind", LEFT_OUT)
def test_what_is_hostile_in_a_drawing_is_left_out_with_a_remark(kind):
    document = HOSTILE[kind][0].replace("</svg>", f"{SQUARE}</svg>")
    own = read(document)
    assert own.remarks
    check(own.svg)
    for word in ("image", "http", "other", "a.svg", "script"):
        assert word not in own.svg.replace("http://www.w3.org/2000/svg", "")


@pytest.mark.parametrize("kind", sorted(HOSTILE.keys() - {"lone surrogate", *LEFT_OUT}))
def test_what_is_hostile_is_refused_or_shows_nothing(kind):
    with pytest.raises(IconstudioError, match=r"\.$") as caught:
        read(HOSTILE[kind][0])
    assert len(str(caught.value)) < 250


def test_a_file_that_is_not_there(session, tmp_path):
    assert "no such file. Check" in refusal(session, tmp_path / "gone.svg")
    assert "no such file" in refusal(session, tmp_path / "gone" / "gone.svg")


def test_a_name_that_no_file_can_have(session, tmp_path):
    assert "Its name is too long" in refusal(session, tmp_path / ("long" * 999 + ".svg"))
    assert "No file can have such a name" in refusal(session, f"{tmp_path}/a\0b.svg")


@pytest.mark.skipif(not hasattr(os, "mkfifo"), reason="there are no pipes")
@pytest.mark.timeout(20)
def test_a_pipe_is_not_waited_for(session, tmp_path):
    os.mkfifo(tmp_path / "pipe.svg")
    assert "Choose a file on a disk" in refusal(session, tmp_path / "pipe.svg")


@pytest.mark.skipif(not hasattr(os, "geteuid") or os.geteuid() == 0, reason="root may read all")
def test_a_file_that_may_not_be_read(session, file):
    path = file(svg(SQUARE))
    path.chmod(0)
    assert "You have no permission" in refusal(session, path)


@pytest.fixture(scope="module")
def saved():
    """A result whose sources have all kinds of credits, as an icon and as a document."""
    licensed = Credit("Ring & <co>", "Ann", "CC-BY-4.0", "https://example.org/by", "https://a.org")
    bare = Credit("Block", UNNAMED, UNLICENSED, "", "")
    sources = (
        replace(SOURCES[0], exemplar=credited(RING, licensed)),
        replace(SOURCES[1], exemplar=credited(RING, licensed)),
        replace(SOURCES[2], exemplar=credited(BLOCK, bare)),
        SOURCES[3],
    )
    result = made(quarters(), sources=sources)
    return result, svg_document(titled(result, "Dog"))


def test_the_credits_of_a_saved_result_are_read_back(file, saved):
    remix, document = saved
    own = read(document)
    assert own.credit.title == "Dog"
    assert own.made_of == tuple(replace(one, svg="") for one in remix.credits)
    assert [one.id for one in own.origins] == ["test:ring", "test:block"]


def test_the_credits_stay_in_the_drawing(saved):
    """So that it can be saved beside the work that uses it."""
    _, document = saved
    once = read(document)
    again = read(once.svg)
    assert (again.credit, again.made_of) == (once.credit, once.made_of)


def test_the_credits_survive_being_used_again(file, saved):
    """Saved, opened, made part of another result, and that saved."""
    remix, document = saved
    own = read(document)
    sources = (replace(SOURCES[0], exemplar=replace(RING, pictogram=own)), *SOURCES[1:])
    again = with_shares(replace(remix.composite, sources=sources), 0.8, 0.0, 0.0, 0.2)
    assert [one.id for one in again.contributors] == ["test:ring", "test:block", "test:disc"]
    assert (
        credits_text(remix).splitlines()[1:]
        == credits_text(titled(remix, "Dog", again)).splitlines()[1:3]
    )


RDF = 'xmlns:rdf="http://www.w3.org/1999/02/22-rdf-syntax-ns#"'
DC = 'xmlns:dc="http://purl.org/dc/elements/1.1/"'
CC = 'xmlns:cc="http://creativecommons.org/ns#"'


def with_work(properties):
    return svg(
        f'<metadata><rdf:RDF {RDF} {DC} {CC}><cc:Work rdf:about="">{properties}</cc:Work>'
        f"</rdf:RDF></metadata>{SQUARE}"
    )


def test_an_author_named_in_the_file_is_credited(file):
    """As Inkscape writes it."""
    document = with_work(
        "<dc:title>Old oak</dc:title>"
        "<dc:creator><cc:Agent>\n <dc:title>Ann\n Other</dc:title>\n</cc:Agent></dc:creator>"
        '<cc:license rdf:resource="https://creativecommons.org/licenses/by/4.0/"/>'
    )
    licence = "https://creativecommons.org/licenses/by/4.0/"
    assert read(document).credit == Credit("Old oak", "Ann Other", licence, "", "")


def listed(*works):
    items = "".join(f"<rdf:li><cc:Work>{work}</cc:Work></rdf:li>" for work in works)
    return with_work(f"<dc:source><rdf:Bag>{items}</rdf:Bag></dc:source>")


def test_credits_that_are_broken_or_sly_do_no_harm(file):
    document = listed(
        "<dc:identifier>a:b</dc:identifier>"
        '<cc:license rdf:resource="file:///etc/passwd"/>'
        '<dc:source rdf:resource="javascript:alert(1)"/>',
        "<dc:title>without a name</dc:title>",
        "<dc:identifier>a:b</dc:identifier><dc:title>again</dc:title>",
        f"<dc:identifier>a:c</dc:identifier><dc:title>{'long ' * 9999}</dc:title>",
        "",
    )
    first, second = read(document).made_of
    assert first == Pictogram("a:b", "", Credit("a:b", UNNAMED, UNLICENSED, "", ""))
    assert second.id == "a:c"
    assert len(second.credit.title) <= 500


def test_the_session_finds_files_and_icons_of_the_collection(session, file, monkeypatch):
    class Shelf:
        def get(self, reference):
            return f"the collection's {reference}"

        def close(self):
            pass

    monkeypatch.setattr(session, "_collection", Shelf())
    upper, bare = file(svg(SQUARE), "A.SVG"), file(svg(SQUARE), "bare")
    assert session.icon(str(upper)).id.startswith("own:A-")
    assert session.icon(str(bare)).id.startswith("own:bare-")
    assert session.icon("set:name") == "the collection's set:name"
    for nowhere in ("long" * 9999, "a\0b", ""):
        assert session.icon(nowhere) == f"the collection's {nowhere}"
    for nowhere in ("nowhere.svg", "nowhere/plain.svgz", "../nowhere-at-all"):
        assert "no such file" in refusal(session, nowhere)
    assert "It is a folder" in refusal(session, file("").parent)


@pytest.mark.parametrize("size", ['width="1e9" height="1e9"', 'width="5000mm" height="2500mm"'])
def test_huge_drawings_are_drawn(size):
    document = f'<svg xmlns="http://www.w3.org/2000/svg" {size}><path d="M0 0h9e9v9e9H0z"/></svg>'
    assert ink(document).any()


@pytest.mark.thorough
def test_a_hostile_drawing_ends_in_a_sentence_and_leaves_the_session_at_work(session, file):
    path = file(svg("<style>" + "a " * 300_000 + "{fill:red}</style>" + "<g/>" * 15_000))
    with pytest.raises(IconstudioError, match="cannot be used"):
        session.icon(str(path))
    assert session.icon(str(file(svg(SQUARE), "good.svg"))).id.startswith("own:good-")


@pytest.mark.parametrize(
    "group", ["<g>", '<g transform="translate(.01 0)">', '<g opacity=".999" fill="red">']
)
def test_what_is_as_deep_as_the_limit_is_drawn(group):
    groups = MAX_DEPTH - 2  # between the root and the shape
    drawn = ink(svg(group * groups + SQUARE + "</g>" * groups))
    assert drawn.sum() == pytest.approx(224 * 224, rel=0.01)


@pytest.mark.parametrize("box", ["100 100 24 24", '0 0 24 24" width="48" height="24'])
def test_what_is_put_around_a_drawing_does_not_make_it_too_deep(box):
    groups = MAX_DEPTH - 2
    body = SQUARE + "<g>" * groups + SQUARE + "</g>" * groups
    assert ink(svg(body, f'viewBox="{box}" preserveAspectRatio="none"')).any()


@pytest.mark.parametrize("depth", [MAX_DEPTH - 1, 100, 240, 260, 400])
def test_all_that_is_too_deep_is_refused_at_one_limit(depth):
    with pytest.raises(IconstudioError, match=f"more than {MAX_DEPTH} deep"):
        read(svg("<g>" * depth + SQUARE + "</g>" * depth))


@pytest.mark.parametrize("box", ["0 0 1e400 NaN", "none"])
def test_what_has_no_number_for_a_size_is_out_of_all_scale(box):
    body = '<circle cx="5" cy="5" r="1e300"/><path d="M1e308 0L-1e308 5"/>'
    with pytest.raises(IconstudioError, match="out of all scale"):
        read(svg(body).replace("0 0 24 24", box))


@pytest.mark.parametrize(
    ("root", "advice"),
    [("adaptive-icon", "open the drawings that it names"), ("Viewbox", "save the drawing as SVG")],
)
def test_of_files_of_other_kinds_it_is_told_what_to_do(root, advice):
    with pytest.raises(IconstudioError, match=f"<{root}>.*{advice}"):
        read(f'<{root} xmlns="http://example.org/a"><a/></{root}>')
