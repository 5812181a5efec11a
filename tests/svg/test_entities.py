"""Entities: those of the document itself mean what they say, within bounds; others are refused."""

import pytest

from iconstudio.model import IconstudioError
from iconstudio.svg.entities import DEEPEST, MOST, written_out
from tests.svg.pictures import HOUSE, PATH, assert_shows, read, svg

EVENODD = f'<path fill-rule="evenodd" d="{HOUSE}"/>'
HOUSES = {
    "nested": ("<!ENTITY d \"{}\"><!ENTITY p \"<path fill-rule='evenodd' d='&d;'/>\">", "&p;"),
    "declared later": ("<!ENTITY p \"<g>&q;</g>\"><!ENTITY q '{}'>", "&p;"),
    "one that is not declared": ("<!ENTITY p '{}'><!ENTITY h \"#000\">", "&nothing;&p;&no-thing;"),
    "quotation marks in an attribute": (
        "<!ENTITY s 'fill:#000;font-family:\"a\"'>",
        f'<g style="&s;">{PATH}</g>',
    ),
    "numbers of characters": ("<!ENTITY p '&#60;g>{}&#x3c;/g>'>", "&p;"),
    "one of parameters, within": ("<!ENTITY % x 'a'><!ENTITY p '{}'>", "&p;"),
    "one of parameters, used": ("<!ENTITY p '{}'><!ENTITY % x 'a'>%x;", "&p;"),
    "a tag that is not closed": ('<!ENTITY d "{}">', '<path d="&d;" fill-rule="evenodd">'),
    "not in text as it is": ('<!ENTITY d "x">', f"<![CDATA[&d;]]><!-- &d;&d; -->{PATH}"),
    "seven deep": (
        "".join(f'<!ENTITY e{n} "&e{n + 1};">' for n in range(1, 7)) + "<!ENTITY e7 '{}'>",
        "&e1;",
    ),
}


def typed(entities, document):
    return f"<!DOCTYPE svg [{entities}]>{document}"


@pytest.mark.parametrize("kind", HOUSES)
def test_entities_of_the_document_are_written_out(kind):
    entities, body = HOUSES[kind]
    inner = HOUSE if "d='&d;'" in entities or 'd="&d;"' in body else EVENODD
    assert_shows(typed(entities.replace("{}", inner), svg(body)), PATH)


LAUGHS = '<!ENTITY e0 "ha">' + "".join(
    f'<!ENTITY e{n} "{f"&e{n - 1};" * 10}">' for n in range(1, 8)
)
HOSTILE = {
    "laughs": (typed(LAUGHS, svg("<text>&e7;</text>")), "more than 1,000,000"),
    "laughs in an attribute": (typed(LAUGHS, svg('<g id="&e7;"/>')), "more than 1,000,000"),
    "laughs that say nothing": (
        typed(LAUGHS.replace("ha", ""), svg("<text>&e7;</text>")),
        "more than 1,000,000",
    ),
    "quadratic": (
        typed(f'<!ENTITY a "{"x" * 20_000}">', svg(f"<text>{'&a;' * 20_000}</text>")),
        "more than 1,000,000",
    ),
    "in a circle": (typed('<!ENTITY a "&b;"><!ENTITY b "&a;">', svg("&a;")), "8 deep"),
    "deep": (
        typed("".join(f'<!ENTITY e{n} "&e{n + 1};">' for n in range(99)), svg("&e0;")),
        "8 deep",
    ),
    "from a file": (typed('<!ENTITY a SYSTEM "file:///etc/passwd">', svg("&a;")), "'a' from out"),
    "of a type by another name": (
        f'<?xml version="1.0"?><!DOCTYPE s [<!ENTITY a SYSTEM "a.txt">]>{svg("<text>&a;</text>")}',
        "'a' from outside",
    ),
    "published": (typed('<!ENTITY a PUBLIC "a" "http://a.org/">', svg("&a;")), "'a' from out"),
    "unparsed": (
        typed('<!NOTATION p SYSTEM "p"><!ENTITY a SYSTEM "a.png" NDATA p>', svg(PATH)),
        "'a' from outside",
    ),
    "parameters from a file": (typed('<!ENTITY % a SYSTEM "a.dtd">%a;', svg(PATH)), "from outside"),
}


def test_entities_are_those_of_a_type_by_any_name():
    assert_shows(
        f'<!DOCTYPE drawing [<!ENTITY d "{HOUSE}">]>{svg(PATH.replace(HOUSE, "&d;"))}', PATH
    )


@pytest.mark.parametrize("kind", HOSTILE)
def test_others_are_refused(kind):
    document, words = HOSTILE[kind]
    with pytest.raises(IconstudioError, match=words):
        read(document)


def test_bounds_are_those_that_are_told():
    def document(length, depth):
        nested = "".join(f'<!ENTITY e{n} "&e{n + 1};">' for n in range(depth - 1))
        return typed(f'{nested}<!ENTITY e{depth - 1} "{"x" * length}">', "<svg>&e0;</svg>")

    assert written_out(document(MOST - 99, DEEPEST)).endswith("xxx</svg>")
    for length, depth in ((MOST, 1), (1, DEEPEST + 1)):
        with pytest.raises(IconstudioError, match="more than"):
            written_out(document(length, depth))
