"""A drawing as an SVG document that credits everyone whose work is in it."""

import re
from xml.sax.saxutils import escape, quoteattr

from iconstudio.model import CANVAS, Composite, Credit, Drawing

_FORBIDDEN = re.compile("[^\t\n\r\u0020-\ud7ff\ue000-\ufffd\U00010000-\U0010ffff]")
"""Characters that XML cannot hold."""


def credited(composite: Composite) -> list[tuple[str, Credit]]:
    """Return identifier and credit of each pictogram with ink in the result, most ink first."""
    ink: dict[str, float] = {}
    found: dict[str, Credit] = {}
    for source, share in zip(composite.sources, composite.shares, strict=True):
        if share > 0:
            name = source.exemplar.id
            ink[name] = ink.get(name, 0.0) + share
            found[name] = source.exemplar.pictogram.credit
    return [(name, found[name]) for name in sorted(found, key=lambda name: (-ink[name], name))]


def credits_text(composite: Composite) -> str:
    """Return the credits as plain text, a line for each pictogram."""
    lines = [
        f"“{credit.title}” ({name}) by {credit.author}, {credit.license}"
        f"{f' <{credit.license_url}>' if credit.license_url else ''}, {credit.url}"
        for name, credit in credited(composite)
    ]
    return "\n".join(["Remixed from parts of:", *lines])


def svg_document(drawing: Drawing, composite: Composite, title: str) -> str:
    """Return an SVG document of one path filled with ``currentColor``.

    Its metadata names title, author, licence and address of every pictogram with ink in it, both
    in a sentence (``dc:description``) and for programs (``dc:source``).
    """
    sources = "".join(_work(name, credit) for name, credit in credited(composite))
    return f"""<?xml version="1.0" encoding="UTF-8"?>
<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {CANVAS} {CANVAS}">
<title>{_text(title)}</title>
<metadata>
<rdf:RDF xmlns:rdf="http://www.w3.org/1999/02/22-rdf-syntax-ns#" \
xmlns:dc="http://purl.org/dc/elements/1.1/" xmlns:cc="http://creativecommons.org/ns#">
<cc:Work rdf:about="">
<dc:title>{_text(title)}</dc:title>
<dc:format>image/svg+xml</dc:format>
<dc:type rdf:resource="http://purl.org/dc/dcmitype/StillImage"/>
<dc:description>{_text(credits_text(composite))}</dc:description>
<dc:source><rdf:Bag>
{sources}</rdf:Bag></dc:source>
</cc:Work>
</rdf:RDF>
</metadata>
<path fill="currentColor" d={_attribute(drawing.path)}/>
</svg>
"""


def _work(name: str, credit: Credit) -> str:
    licence = f"<cc:license rdf:resource={_attribute(credit.license_url)}/>"
    return (
        f"<rdf:li><cc:Work rdf:about={_attribute(credit.url)}>"
        f"<dc:identifier>{_text(name)}</dc:identifier>"
        f"<dc:title>{_text(credit.title)}</dc:title>"
        f"<dc:creator><cc:Agent><dc:title>{_text(credit.author)}</dc:title></cc:Agent></dc:creator>"
        f"<dc:rights>{_text(credit.license)}</dc:rights>"
        f"{licence if credit.license_url else ''}</cc:Work></rdf:li>\n"
    )


def _text(text: str) -> str:
    return escape(_FORBIDDEN.sub("\ufffd", text))


def _attribute(text: str) -> str:
    return quoteattr(_FORBIDDEN.sub("\ufffd", text))
