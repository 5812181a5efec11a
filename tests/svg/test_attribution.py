"""Lines of credit below an icon are no part of its drawing, but its credit."""

import pytest

from iconstudio.svg.credits import UNNAMED
from iconstudio.svg.reading import own_artwork
from tests.svg.pictures import assert_shows, read, svg

pytestmark = pytest.mark.thorough(but=1)

PAGE = 'viewBox="0 0 24 30"'
DISC = '<circle cx="12" cy="12" r="9"/>'
FROM = '<text y="29" font-size="1.2">from the Noun Project</text>'


def text(said, attributes='y="27" font-size="1.2" font-weight="bold"'):
    return f"<text {attributes}>{said}</text>"


LINES = {
    "Created by Ada Lovelace": "Ada Lovelace",
    "Created by verry poernomo from Noun Project": "verry poernomo",
    "Created by Éricles Batista": "Éricles Batista",
    "Icons made by Freepik from www.flaticon.com": "Freepik",
    "Designed by\n  <tspan>Ada</tspan> <tspan>Byron</tspan>": "Ada Byron",
    "Icon by Ada Byron, via svgrepo.com": "Ada Byron",
    "Downloaded from https://www.svgrepo.com": "",
    "© 2021 Ada Byron": "",
    "Licensed under CC BY 3.0": "",
}


@pytest.mark.parametrize("said", LINES)
def test_a_line_of_credit_is_left_out_and_told(said):
    document = svg(DISC + text(said), PAGE)
    assert_shows(document, DISC, remarks=["credit line"])
    assert read(document).credit.author == (LINES[said] or UNNAMED)


def test_two_lines_are_told_in_one_sentence():
    own = read(svg(DISC + text("Created by Ada") + text("") + FROM, PAGE))
    assert own.remarks == (
        "Its credit line was left out of the drawing: “Created by Ada from the Noun Project”.",
    )
    assert own.credit.author == "Ada"


@pytest.mark.parametrize(
    "said", ["©", "© ®", "CC BY", "made by hand", "by", "from me", "Copyright", "PDF", "A from B"]
)
def test_other_text_is_part_of_a_drawing(said):
    drawn = DISC + text(said, 'y="27" font-size="6"')
    assert "Inter" in read(svg(drawn, PAGE)).remarks[0]


def test_a_line_is_the_drawing_where_nothing_else_is():
    assert "Inter" in read(svg(text("Created by Ada") + FROM, PAGE)).remarks[0]


def test_a_hidden_line_is_not_told():
    assert read(svg(f'{DISC}<g display="none">{text("Created by Ada")}</g>', PAGE)).remarks == ()


def test_what_metadata_say_of_the_author_is_true():
    rdf = (
        '<metadata><rdf:RDF xmlns:rdf="http://www.w3.org/1999/02/22-rdf-syntax-ns#" '
        'xmlns:cc="http://creativecommons.org/ns#" xmlns:dc="http://purl.org/dc/elements/1.1/">'
        "<cc:Work><dc:creator>Ada</dc:creator></cc:Work></rdf:RDF></metadata>"
    )
    assert read(svg(rdf + DISC + text("Created by Eva"), PAGE)).credit.author == "Ada"


def test_a_drawing_in_its_colours_is_without_it_too():
    document = svg(DISC + text("Created by Ada", 'y="27" font-size="3"'), PAGE)
    pixels, own = own_artwork(document.encode(), "drawing.svg")
    assert not pixels[len(pixels) * 22 // 30 :, :, 3].any()
    assert own.credit.author == "Ada"
