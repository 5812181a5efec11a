"""Files of the user's own: good ones, with their credits, and all kinds of bad ones."""

import os
from dataclasses import replace

import pytest

from iconstudio.model import Credit, IconstudioError, Pictogram
from iconstudio.output.svg import contributors, credits_text, svg_document
from iconstudio.session import Session
from iconstudio.svg.check import MAX_BYTES
from iconstudio.svg.rasterise import rasterise
from iconstudio.svg.reading import UNLICENSED, UNNAMED, read_own_svg
from tests.output.made import BLOCK, RING, SOURCES, credited, made, quarters, with_shares
from tests.svg.test_check import HARMLESS, HOSTILE, svg

SQUARE = '<path d="M4 4h16v16H4z"/>'


@pytest.fixture
def file(tmp_path):
    """Return a function that writes a file and returns its path."""

    def write(content, name="logo.svg"):
        path = tmp_path / name
        path.write_bytes(content if isinstance(content, bytes) else content.encode())
        return path

    return write


@pytest.fixture
def session(tmp_path):
    with Session(tmp_path / "cache") as one:
        yield one


def refusal(path):
    """Return the sentence that says what is wrong with a file."""
    with pytest.raises(IconstudioError) as caught:
        read_own_svg(path)
    sentence = str(caught.value)
    assert sentence.startswith(f"“{path}” cannot be used. ")
    assert sentence.endswith(".") or "Add xmlns" in sentence
    return sentence


def test_a_drawing_is_read_as_it_is(file):
    path = file(svg(SQUARE), "Mein Haus.svg")
    own = read_own_svg(path)
    assert own.id.startswith("own:Mein Haus-")
    assert own.svg == svg(SQUARE)
    assert own.credit == Credit("Mein Haus.svg", UNNAMED, UNLICENSED, "", "")
    assert own.made_of == ()
    rasterise(own.svg)


def test_the_name_tells_two_drawings_apart_and_one_from_its_next_version(file, tmp_path):
    first = read_own_svg(file(svg(SQUARE)))
    changed = read_own_svg(file(svg(SQUARE + SQUARE)))
    (tmp_path / "copy").mkdir()
    copy = read_own_svg(file(svg(SQUARE), "copy/logo.svg"))
    assert first.id == copy.id != changed.id


@pytest.mark.parametrize(
    ("declared", "encoding"),
    [
        ("", "utf-8"),
        ("", "utf-8-sig"),
        ("UTF-8", "utf-8"),
        ("UTF-16", "utf-16"),
        ("ISO-8859-1", "iso-8859-1"),
        ("windows-1252", "windows-1252"),
    ],
)
def test_any_usual_encoding(file, declared, encoding):
    prolog = f'<?xml version="1.0" encoding="{declared}"?>' if declared else ""
    own = read_own_svg(file((prolog + svg(f"<title>Gemüse</title>{SQUARE}")).encode(encoding)))
    assert "<title>Gemüse</title>" in own.svg
    rasterise(own.svg)


@pytest.mark.parametrize("kind", HARMLESS)
def test_what_is_harmless_is_read(file, kind):
    assert read_own_svg(file(HARMLESS[kind])).svg == HARMLESS[kind]


@pytest.mark.parametrize("kind", sorted(HOSTILE.keys() - {"lone surrogate", "empty"}))
def test_what_is_hostile_is_refused_by_name(file, kind):
    document, word = HOSTILE[kind]
    assert word in refusal(file(document))


@pytest.mark.parametrize(
    ("content", "words"),
    [
        (b"", "is empty. Save"),
        (b" \n", "is empty. Save"),
        (b"\x89PNG\r\n\x1a\n\0\0\0\rIHDR\xff\xfe\x80", "no SVG drawing"),
        (b"\x1f\x8b\x08\0\0\0\0\0", "compressed (SVGZ). Save it as plain SVG"),
        (b"\xff\xfe<", "no SVG drawing"),
        (b"<svg>\xe4</svg>", "no SVG drawing, or not in UTF-8"),
        ('<?xml version="1.0" encoding="punycode"?><svg>\xe4</svg>'.encode("latin-1"), "UTF-8"),
        ("Dear dog,", "not well-formed XML"),
        ("<!DOCTYPE html><html><body>404</body></html>", "not an SVG drawing"),
        ('<svg viewBox="0 0 24 24">' + SQUARE + "</svg>", "Add xmlns="),
        (" " * MAX_BYTES + "x", f"more than {MAX_BYTES:,} bytes. Simplify"),
        (svg('<image href="file:///etc/passwd"/>'), "bitmap"),
        (svg('<use href="https://example.org/a.svg#b"/>'), "outside itself"),
        (svg("<foreignObject><script xmlns='http://www.w3.org/1999/xhtml'/></foreignObject>"),
         "script"),
        ('<!DOCTYPE svg [<!ENTITY x SYSTEM "file:///etc/passwd">]>' + svg("<text>&x;</text>"),
         "DOCTYPE"),
    ],
)  # fmt: skip
def test_what_is_no_drawing_is_refused_by_name(file, content, words):
    assert words in refusal(file(content))


def test_a_file_that_is_not_there(tmp_path):
    assert "no such file. Check" in refusal(tmp_path / "gone.svg")
    assert "no such file" in refusal(tmp_path / "gone" / "gone.svg")


def test_a_name_that_no_file_can_have(tmp_path):
    assert "cannot be read" in refusal(tmp_path / ("long" * 999 + ".svg"))
    assert "cannot be read" in refusal(tmp_path / "a\0b.svg")


def test_a_folder(tmp_path):
    assert "folder. Choose" in refusal(tmp_path)


@pytest.mark.skipif(not hasattr(os, "mkfifo"), reason="there are no pipes")
@pytest.mark.timeout(20)
def test_a_pipe_is_not_waited_for(tmp_path):
    os.mkfifo(tmp_path / "pipe.svg")
    assert "no file on a disk" in refusal(tmp_path / "pipe.svg")


@pytest.mark.skipif(not hasattr(os, "geteuid") or os.geteuid() == 0, reason="root may read all")
def test_a_file_that_may_not_be_read(file):
    path = file(svg(SQUARE))
    path.chmod(0)
    assert "Permission denied" in refusal(path)


@pytest.fixture(scope="module")
def saved():
    """A result whose sources have all kinds of credits, as a composite and as a document."""
    licensed = Credit("Ring & <co>", "Ann", "CC-BY-4.0", "https://example.org/by", "https://a.org")
    bare = Credit("Block", UNNAMED, UNLICENSED, "", "")
    sources = (
        replace(SOURCES[0], exemplar=credited(RING, licensed)),
        replace(SOURCES[1], exemplar=credited(RING, licensed)),
        replace(SOURCES[2], exemplar=credited(BLOCK, bare)),
        SOURCES[3],
    )
    result = made(quarters(), sources=sources)
    return result.composite, svg_document(result.drawing, result.composite, "Dog")


def test_the_credits_of_a_saved_result_are_read_back(file, saved):
    composite, document = saved
    own = read_own_svg(file(document))
    assert own.credit.title == "Dog"
    assert own.made_of == tuple(replace(one, svg="") for one in contributors(composite))
    assert [one.id for one in own.origins] == ["test:ring", "test:block"]


def test_the_credits_survive_being_used_again(file, saved):
    """Saved, opened, made part of another result, and that saved."""
    composite, document = saved
    own = read_own_svg(file(document))
    sources = (replace(SOURCES[0], exemplar=replace(RING, pictogram=own)), *SOURCES[1:])
    again = with_shares(replace(composite, sources=sources), 0.8, 0.0, 0.0, 0.2)
    assert [one.id for one in contributors(again)] == ["test:ring", "test:block", "test:disc"]
    assert credits_text(composite).splitlines()[1:] == credits_text(again).splitlines()[1:3]


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
    assert read_own_svg(file(document)).credit == Credit("Old oak", "Ann Other", licence, "", "")


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
    first, second = read_own_svg(file(document)).made_of
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
    for nowhere in ("long" * 9999, "a\0b", "", str(file("").parent)):
        assert session.icon(nowhere) == f"the collection's {nowhere}"
    with pytest.raises(IconstudioError, match="no such file"):
        session.icon("nowhere.svg")


DRAWN = {
    "black": SQUARE,
    "red": f'<g fill="#d00000">{SQUARE}</g>',
    "of a dark and a pale colour": f'<path d="M0 0h24v24H0z" fill="#ff0"/>{SQUARE}',
    "shaded": '<linearGradient id="g"><stop stop-color="#000"/><stop offset="1" stop-color="#00f"/>'
    '</linearGradient><path d="M4 4h16v16H4z" fill="url(#g)"/>',
}
INVISIBLE = {
    "empty": "",
    "white": f'<g fill="#fff">{SQUARE}</g>',
    "yellow": f'<g fill="#ff0">{SQUARE}</g>',
    "half transparent": f'<g opacity=".4">{SQUARE}</g>',
    "outside its canvas": '<path d="M44 44h16v16H44z"/>',
    "text": "<text y='20'>Dog</text>",
}


def test_what_is_dark_enough_is_taken_in_black_and_white(session, file):
    drawn = [session.exemplar(read_own_svg(file(svg(body)))) for body in DRAWN.values()]
    for exemplar in drawn:
        assert (exemplar.ink == drawn[0].ink).all()
        assert exemplar.ink.sum() == 224 * 224


def test_what_has_no_dark_ink_says_so(session, file):
    for kind, body in INVISIBLE.items():
        with pytest.raises(IconstudioError, match=r"dark ink.*Fill its shapes") as caught:
            session.exemplar(read_own_svg(file(svg(body), f"{kind}.svg")))
        assert str(caught.value).startswith(f"own:{kind}-")


@pytest.mark.parametrize("size", ['width="1e9" height="1e9"', 'width="5000mm" height="2500mm"'])
def test_huge_drawings_are_drawn_small_or_refused(session, file, size):
    document = f'<svg xmlns="http://www.w3.org/2000/svg" {size}><path d="M0 0h9e9v9e9H0z"/></svg>'
    own = read_own_svg(file(document))
    if "1e9" in size:
        with pytest.raises(IconstudioError, match="out of all scale"):
            session.exemplar(own)
    else:
        assert session.exemplar(own).ink.any()
