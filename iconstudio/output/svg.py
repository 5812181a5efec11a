"""A result as an SVG document that names everyone whose icon it was made of."""

import hashlib
import re
from collections import Counter
from collections.abc import Iterable, Sequence
from dataclasses import replace
from xml.sax.saxutils import escape, quoteattr

from iconstudio.algorithms.two_tones import in_two_tones
from iconstudio.model import CANVAS, ColouredLayer, Credit, Fill, Icon, Path, Patterned, Pictogram
from iconstudio.model.path import OVERHANG
from iconstudio.svg.mark import IN_MARKUP

_NO_XML = re.compile("[^\t\n\r\x20-\ud7ff\ue000-\ufffd\U00010000-\U0010ffff]")
"""Characters that XML cannot hold."""
_REPLACEMENT = "\ufffd"
_NO_WORD = re.compile(r"[\W_]+")
_ROUND = ' stroke-linecap="round" stroke-linejoin="round"'
_CUT = "It reached out of its canvas; what was outside is cut off."
_SLUG = 40
"""Most characters that a title lends to an identifier."""


def svg_document(icon: Icon) -> str:
    """Return an icon as an SVG document: one path in ``currentColor``, with a title.

    Of a pattern, its layers in their colours. It is as large as what it is drawn on, a unit a
    pixel; see ``document``.
    """
    if isinstance(icon, Patterned):
        return layered_document(icon.title, icon.credits, icon.layers, icon.size, icon.ground)
    return document(icon.title, icon.credits, [(icon.path, 0.0)])


def document(
    title: str,
    credits: Sequence[Pictogram],
    drawn: Iterable[tuple[Path, float]],
    size: tuple[float, float] = (CANVAS, CANVAS),
) -> str:
    """Return paths as an SVG document in ``currentColor``, a unit a pixel.

    The metadata credit everyone whose icon it was made of, in Dublin Core for machines and in
    words for people. Characters that XML cannot hold are replaced by U+FFFD.

    Parameters
    ----------
    drawn
        Paths, each with the width of its stroke, whose ends and joins are round; 0 is filled.
    size
        Width and height.
    """
    return _document(title, credits, (_stroked(path, width) for path, width in drawn), size)


def layered_document(
    title: str,
    credits: Sequence[Pictogram],
    layers: Sequence[ColouredLayer],
    size: tuple[float, float],
    ground: str = "",
) -> str:
    """Return layers as an SVG document, each a group that has its name as identifier.

    Parameters
    ----------
    layers
        From back to front, a unit a pixel.
    size
        Width and height. What reaches beyond them is not seen.
    ground
        The colour behind all layers, ``#rrggbb``; none if it is empty.
    """
    width, height = (f"{side:g}" for side in size)
    behind = f'<path id="ground" fill="{ground}" d="M0 0H{width}V{height}H0Z"/>\n'
    groups = map(_group, layers)
    return _document(title, credits, [behind, *groups] if ground else groups, size)


def _document(
    title: str,
    credits: Sequence[Pictogram],
    elements: Iterable[str],
    size: tuple[float, float],
) -> str:
    works = "".join(map(_work, credits))
    title = _text(title)
    width, height = (f"{side:g}" for side in size)
    return (
        f'<svg xmlns="http://www.w3.org/2000/svg" {IN_MARKUP}'
        f' width="{width}" height="{height}" viewBox="0 0 {width} {height}"'
        ' fill="currentColor">\n'
        f"<title>{title}</title>\n"
        "<metadata>\n"
        '<rdf:RDF xmlns:rdf="http://www.w3.org/1999/02/22-rdf-syntax-ns#"'
        ' xmlns:dc="http://purl.org/dc/elements/1.1/"'
        ' xmlns:cc="http://creativecommons.org/ns#">\n'
        '<cc:Work rdf:about="">\n'
        f"<dc:title>{title}</dc:title>\n"
        "<dc:format>image/svg+xml</dc:format>\n"
        f"<dc:rights>{_text(_in_words(credits))}</dc:rights>\n"
        f"<dc:source>\n<rdf:Bag>\n{works}</rdf:Bag>\n</dc:source>\n"
        "</cc:Work>\n"
        "</rdf:RDF>\n"
        "</metadata>\n"
        f"{''.join(elements)}"
        "</svg>\n"
    )


def credits_text(icon: Icon) -> str:
    """Return the credits of an icon as plain text, one a line."""
    return _in_words(icon.credits)


def pictogram_of(icon: Icon) -> Pictogram:
    """Return an icon that was made here as a pictogram, to be used like any other.

    Its identifier is ``made:`` with the title's words and a digest of the outline; its licence
    names those of everything that it was made of. Like the results in sight it ends where the
    canvas does; if something was beyond that, a remark says so. A pattern is in ink and paper, and
    ends at its borders anyway.
    """
    words = _NO_WORD.sub("-", icon.title.casefold()[:_SLUG]).strip("-") or "icon"
    digest = hashlib.sha256(icon.path.svg().encode()).hexdigest()[:8]
    licences = dict.fromkeys(one.credit.license for one in icon.credits)
    if isinstance(icon, Patterned):
        drawn, cut = _in_ink(icon), False
    else:
        drawn, cut = svg_document(icon), icon.path.overhang > OVERHANG
    return Pictogram(
        id=f"made:{words}-{digest}",
        svg=drawn,
        credit=Credit(icon.title, "you, with Iconstudio", ", ".join(licences), "", ""),
        made_of=icon.credits,
        remarks=(_CUT,) if cut else (),
    )


def _in_ink(icon: Patterned) -> str:
    """Return a pattern in ink and paper: pale shapes are ink, too."""
    inked = in_two_tones(fill for layer in icon.layers for fill in layer.fills)
    return layered_document(icon.title, icon.credits, [ColouredLayer("ink", inked)], icon.size)


def _in_words(credits: Sequence[Pictogram]) -> str:
    lines = [_line(pictogram.credit) for pictogram in credits]
    return "\n".join(["Made of parts of:", *lines]) if lines else ""


def _group(layer: ColouredLayer) -> str:
    """Return the element of a layer; the colour that most of it has is said once."""
    colours = Counter(fill.colour for fill in layer.fills)
    usual = colours.most_common(1)[0][0] if colours else ""
    inner = "".join(
        _filled(replace(fill, colour="") if fill.colour == usual else fill) for fill in layer.fills
    )
    painted = f" fill={quoteattr(usual)}" if usual else ""
    return f"<g id={quoteattr(layer.name)}{painted}>\n{inner}</g>\n"


def _filled(fill: Fill) -> str:
    painted = f" fill={quoteattr(fill.colour)}" if fill.colour else ""
    return f"<path d={quoteattr(fill.path.svg())}{painted}/>\n"


def _stroked(path: Path, width: float) -> str:
    """Return the element of a stroke, whose ends and joins are round."""
    painted = f' fill="none" stroke="currentColor" stroke-width="{width:.6g}"{_ROUND}'
    return f"<path d={quoteattr(path.svg())}{painted if width else ''}/>\n"


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
