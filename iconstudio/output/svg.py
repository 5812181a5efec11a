"""A result as an SVG document that names everyone whose icon it was made of."""

import hashlib
import re
from xml.sax.saxutils import escape, quoteattr

from iconstudio.model import CANVAS, Composite, Credit, Drawing, Pictogram
from iconstudio.output.colours import significant_sources

_NO_XML = re.compile("[^\t\n\r\x20-\ud7ff\ue000-\ufffd\U00010000-\U0010ffff]")
"""Characters that XML cannot hold."""
_REPLACEMENT = "\ufffd"
_NO_WORD = re.compile(r"[\W_]+")
_SLUG = 40
"""Most characters that a title lends to an identifier."""


def svg_document(drawing: Drawing, composite: Composite, title: str) -> str:
    """Return a drawing as an SVG document: one path in ``currentColor``, with a title.

    It is as large as the canvas, a unit a pixel, where nothing else is said.

    The metadata credit every contributing source, in Dublin Core for machines and in words for
    people. Characters that XML cannot hold are replaced by U+FFFD.
    """
    works = "".join(_work(pictogram) for pictogram in contributors(composite))
    return (
        '<svg xmlns="http://www.w3.org/2000/svg"'
        f' width="{CANVAS}" height="{CANVAS}" viewBox="0 0 {CANVAS} {CANVAS}"'
        ' fill="currentColor">\n'
        f"<title>{_text(title)}</title>\n"
        "<metadata>\n"
        '<rdf:RDF xmlns:rdf="http://www.w3.org/1999/02/22-rdf-syntax-ns#"'
        ' xmlns:dc="http://purl.org/dc/elements/1.1/"'
        ' xmlns:cc="http://creativecommons.org/ns#">\n'
        '<cc:Work rdf:about="">\n'
        f"<dc:title>{_text(title)}</dc:title>\n"
        "<dc:format>image/svg+xml</dc:format>\n"
        f"<dc:rights>{_text(credits_text(composite))}</dc:rights>\n"
        f"<dc:source>\n<rdf:Bag>\n{works}</rdf:Bag>\n</dc:source>\n"
        "</cc:Work>\n"
        "</rdf:RDF>\n"
        "</metadata>\n"
        f"<path d={quoteattr(drawing.path)}/>\n"
        "</svg>\n"
    )


def credits_text(composite: Composite) -> str:
    """Return the credits of every contributing source as plain text, one a line."""
    lines = [_line(pictogram.credit) for pictogram in contributors(composite)]
    return "\n".join(["Made of parts of:", *lines]) if lines else ""


def contributors(composite: Composite) -> tuple[Pictogram, ...]:
    """Return the pictograms to thank for the ink, each once, from the largest part down.

    The part of a source that is itself a result counts for its origins, in equal shares. Two
    pictograms of the same name and credit are one, wherever their drawings were read from.
    """
    shares: dict[tuple[str, Credit], float] = {}
    thanked: dict[tuple[str, Credit], Pictogram] = {}
    for label in significant_sources(composite, least=0):
        origins = composite.sources[label].exemplar.pictogram.origins
        for origin in origins:
            key = origin.id, origin.credit
            thanked.setdefault(key, origin)
            shares[key] = shares.get(key, 0.0) + composite.shares[label] / len(origins)
    return tuple(thanked[key] for key in sorted(shares, key=shares.__getitem__, reverse=True))


def pictogram_of(composite: Composite, drawing: Drawing, title: str) -> Pictogram:
    """Return a result as a pictogram, to be used like any other.

    Its identifier is ``made:`` with the title's words and a digest of the drawing; its licence
    names those of everything that it was made of.
    """
    origins = contributors(composite)
    words = _NO_WORD.sub("-", title.casefold()[:_SLUG]).strip("-") or "icon"
    digest = hashlib.sha256(drawing.path.encode()).hexdigest()[:8]
    licences = dict.fromkeys(origin.credit.license for origin in origins)
    return Pictogram(
        id=f"made:{words}-{digest}",
        svg=svg_document(drawing, composite, title),
        credit=Credit(title, "you, with Iconstudio", ", ".join(licences), "", ""),
        made_of=origins,
    )


def _line(credit: Credit) -> str:
    licence = f"{credit.license} ({credit.license_url})" if credit.license_url else credit.license
    said = f"“{credit.title}” by {credit.author}", licence, credit.url
    return ", ".join(filter(None, said))


def _work(pictogram: Pictogram) -> str:
    credit = pictogram.credit
    return (
        "<rdf:li>\n<cc:Work>\n"
        f"<dc:identifier>{_text(pictogram.id)}</dc:identifier>\n"
        f"<dc:title>{_text(credit.title)}</dc:title>\n"
        f"<dc:creator>{_text(credit.author)}</dc:creator>\n"
        f"<dc:rights>{_text(credit.license)}</dc:rights>\n"
        f"{_link('cc:license', credit.license_url)}{_link('dc:source', credit.url)}"
        "</cc:Work>\n</rdf:li>\n"
    )


def _link(element: str, address: str) -> str:
    if not address:
        return ""
    return f"<{element} rdf:resource={quoteattr(_NO_XML.sub(_REPLACEMENT, address))}/>\n"


def _text(text: str) -> str:
    return escape(_NO_XML.sub(_REPLACEMENT, text), {"\r": "&#13;"})
