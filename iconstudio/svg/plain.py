"""A drawing in plain SVG 1.1: what it says of itself is applied, what is not drawn is gone.

Styles, variables, animations, switches, references and sizes are resolved; what comes out is a
tree of shapes, groups, gradients, clips, masks and filters that every renderer reads alike.
"""

import math
import xml.etree.ElementTree as ET
from collections.abc import Sequence
from dataclasses import dataclass
from typing import NamedTuple

from iconstudio.svg import attribution, classes, figma, references, shadows, sprites, templates
from iconstudio.svg.animation import as_one, finish
from iconstudio.svg.bitmaps import Shown, is_page, put_back, shown, stand_for
from iconstudio.svg.bounds import bounds
from iconstudio.svg.check import MAX_DEPTH, check
from iconstudio.svg.clipping import clip
from iconstudio.svg.embedding import embed
from iconstudio.svg.filters import bound_octaves, leave_out_distortions
from iconstudio.svg.geometry import SHAPES
from iconstudio.svg.lengths import IDENTITY, Box, Matrix, numbers, pixels, written
from iconstudio.svg.lettering import TEXTS, set_type
from iconstudio.svg.mark import ATTRIBUTE, PAGE
from iconstudio.svg.parse import SHEET_ELSEWHERE
from iconstudio.svg.pathdata import cut_off_mistakes
from iconstudio.svg.percentages import write_out
from iconstudio.svg.placing import place
from iconstudio.svg.repeats import as_groups
from iconstudio.svg.scribbles import refuse_scribbles
from iconstudio.svg.styles import ONLY_IN_STYLE, apply_styles
from iconstudio.svg.textpaths import letters_beyond
from iconstudio.svg.unscaled import keep_strokes

_GROUPS = ("svg", "g", "a", "switch", "symbol", "defs", "use")
_SERVERS = ("clipPath", "mask", "pattern", "marker", "stop", *references.GRADIENTS)
_SILENT = (
    "title", "desc", "metadata", "style", "view", "cursor", "font", "font-face", "glyph",
    "missing-glyph", "hkern", "vkern", "color-profile", "script", "slot",
)  # fmt: skip
"""Elements that draw nothing."""
_UNKNOWN = {
    "meshgradient": "A mesh gradient",
    "meshGradient": "A mesh gradient",
    "hatch": "A hatching",
    "image": "A bitmap",
    "feImage": "A bitmap in a filter",
    "foreignObject": "A part that only web pages show (foreignObject)",
    "flowRoot": "Flowed text",
    "tref": "A text",
    "video": "A film",
    "iframe": "A web page",
    "canvas": "A bitmap",
    "audio": "A sound",
}
_OF_PIXELS = (".png", ".jpg", ".jpeg", ".gif", ".webp", ".bmp", ".avif", ".tif", ".tiff", ".ico")
_CURE = {
    "A bitmap": "Trace it, or open it as a picture",
    "Flowed text": "Turn it into shapes",
    "A text": "Turn it into shapes",
}
_OF_ROOTS = (
    "viewBox", "width", "height", "x", "y", "preserveAspectRatio", "version", "baseProfile",
    "overflow", "id", "zoomAndPan", "contentScriptType", "contentStyleType",
)  # fmt: skip
_MANY = 8
"""Masks and clips, from which on they are slow to draw."""


@dataclass(frozen=True, slots=True)
class Plain:
    """A drawing in plain SVG."""

    content: ET.Element
    """A ``g`` with all of it."""
    page: Box | None
    """What of user space is seen; None if the document does not say."""
    bounds: Box | None
    """Where something may be drawn; None if there is nothing."""
    texts: tuple[str, ...]
    """What is written in it, by fonts."""
    heavy: bool
    """Whether filters, patterns or many masks are at work, which are slow to draw."""
    remarks: tuple[str, ...]
    """What could not be read, in sentences."""
    marked: bool
    """Whether it says that it was made plain and black here."""
    bitmaps: tuple[Shown, ...] = ()
    """The bitmaps that would be seen."""
    author: str = ""
    """Whom a line of text in it names as its author."""


def plain(
    root: ET.Element,
    remarks: Sequence[str] = (),
    symbol: str | None = None,
    midway: bool = False,
    with_bitmaps: bool = False,
) -> Plain:
    """Make a parsed document plain; ``root`` is changed.

    Parameters
    ----------
    remarks
        What could not be read before, in sentences.
    symbol
        The id of what is wanted of it, if that is not all.
    midway
        Whether animations are shown in the middle where they end with nothing.
    with_bitmaps
        Whether the bitmaps that it holds stay in it.

    Raises
    ------
    SpriteError
        If it only defines what others may draw.
    IconstudioError
        If nothing is called ``symbol``, or it is not safe to draw.
    """
    marked = root.attrib.pop(ATTRIBUTE, None) is not None
    said, unread = _apply(root, midway)
    remarks = [*remarks, *said]
    addresses = stand_for(root) if with_bitmaps else []
    drawn = _drawn(root, symbol)
    ids, page, kept = drawn.ids, drawn.page, drawn.elements
    remarks += drawn.remarks
    if SHEET_ELSEWHERE not in remarks:
        remarks += classes.missed(root, kept, unread)
    if without := shadows.leave_out(kept):
        remarks += without
        kept = references.drawn(root, ids)
    remarks += leave_out_distortions(kept)
    bound_octaves(kept)
    remarks += cut_off_mistakes(kept)
    bitmaps = shown(root, ids) if any(one.tag == "image" for one in kept) else []
    remarks += _without_unknown(root, kept)
    said, author = attribution.leave_out(root, kept)
    remarks += said
    texts = tuple(_texts(kept))
    references.prune(root, kept)
    # Before anything follows its references.
    check(ET.tostring(root, encoding="unicode"), MAX_DEPTH)
    refuse_scribbles(kept)
    remarks += _measure(root, page, ids)
    is_bitmap = bool(bitmaps) and is_page(root, page, ids)
    content = _content(root, drawn.stretch)
    box = None if is_bitmap else bounds(content, page or (0, 0, 100, 100), ids, painted=True)
    put_back(content, addresses)
    return Plain(
        content,
        page,
        box,
        texts,
        _is_heavy(kept),
        tuple(as_one(remarks)),
        marked,
        tuple(bitmaps),
        author,
    )


def _apply(root: ET.Element, midway: bool) -> tuple[list[str], classes.Classes]:
    """Make attributes of what a document says of itself by other means, in place.

    Returns
    -------
    What to say of it, and the classes that were not read.
    """
    references.unquote_targets(root)
    remarks = list(finish(root, midway))
    if any(True for _ in root.iter("script")):
        remarks.append("A script was not run.")
    remarks += figma.without_web_pages(root)
    unread = classes.read(root)
    return [*remarks, *apply_styles(root, midway), *embed(root)], unread


class _Drawn(NamedTuple):
    """What of a document is drawn."""

    elements: set[ET.Element]
    ids: dict[str, ET.Element]
    page: Box | None
    stretch: Matrix
    """By what all is stretched on the page."""
    remarks: list[str]


def _drawn(root: ET.Element, symbol: str | None) -> _Drawn:
    """Resolve references and return what is drawn: all, or the symbol that is wanted."""
    root.attrib.pop("display", None)  # of a sprite within a page
    sprites.turn_glyphs_into_symbols(root)
    symbols = sprites.symbols(root)
    remarks = []
    if symbol is None and (symbol := templates.usual(root)):
        remarks.append(templates.CHOSEN.format(symbol))
    if symbol is not None:
        sprites.choose(root, symbol)
    ids, outside, missing = references.resolve(root)
    remarks += references.without_circles(root, ids)
    kept = references.drawn(root, ids)
    page, stretch = _page(root)
    if not any(element.tag in SHAPES or element.tag in TEXTS for element in kept):
        if len(symbols) > 1 and symbol is None:
            raise sprites.several(list(symbols))
        for only in symbols.values() if symbol is None else ():
            sprites.show(root, only)
            page, stretch = _page(root)
            kept = references.drawn(root, ids)
    remarks += outside if kept else []
    remarks += [sentence for element, sentence in missing if element in kept]
    return _Drawn(kept, ids, page, stretch, remarks)


def _is_heavy(kept: set[ET.Element]) -> bool:
    masks = sum(one.tag in ("mask", "clipPath") for one in kept)
    return masks > _MANY or any(
        one.tag in ("filter", "pattern") or "blur" in one.get("filter", "") for one in kept
    )


def _measure(root: ET.Element, page: Box | None, ids: dict[str, ET.Element]) -> list[str]:
    """Say where everything is by numbers and matrices, in place; return what was not understood."""
    remarks = place(root, page, ids)
    as_groups(root, page, ids)
    for child in root:
        write_out(child, page or (0.0, 0.0, 100.0, 100.0))
    keep_strokes(root, page)
    remarks += clip(root, page, ids)
    remarks += letters_beyond(root, page, ids)
    _without_contexts(root, False)
    set_type(root)
    return remarks


def _page(root: ET.Element) -> tuple[Box | None, Matrix]:
    """Return what of user space the viewport shows, and by what all is stretched before that."""
    width, height = pixels(root.get("width")), pixels(root.get("height"))
    size = (width, height) if width and height and width > 0 and height > 0 else None
    box = numbers(root.get("viewBox", ""))
    if len(box) != 4 or not (box[2] > 0 and box[3] > 0 and all(map(math.isfinite, box))):
        return ((0.0, 0.0, *size) if size else None), IDENTITY
    x, y, across, down = box
    if size is None:
        return (x, y, across, down), IDENTITY
    align = root.get("preserveAspectRatio", "xMidYMid").strip()
    scales = size[0] / across, size[1] / down
    if align.startswith("none"):
        stretch = scales[1] / scales[0]
        return (x, y, across, down * stretch), (1, 0, 0, stretch, 0, y - y * stretch)
    scale = max(scales) if "slice" in align else min(scales)
    seen = size[0] / scale, size[1] / scale
    left = 0 if "xMin" in align else 1 if "xMax" in align else 0.5
    top = 0 if "YMin" in align else 1 if "YMax" in align else 0.5
    return (x + (across - seen[0]) * left, y + (down - seen[1]) * top, *seen), IDENTITY


def _without_unknown(root: ET.Element, kept: set[ET.Element]) -> list[str]:
    """Remove elements that no renderer of shapes draws; return what to say of those in sight."""
    remarks = []
    for parent in list(root.iter()):
        for child in list(parent):
            known = child.tag in (*_GROUPS, *SHAPES, *_SERVERS, *TEXTS) or (
                child.tag == "filter" or (child.tag.startswith("fe") and child.tag != "feImage")
            )
            if known:
                continue
            parent.remove(child)
            if child in kept and child.tag not in _SILENT and not child.tag.startswith("{"):
                what = _UNKNOWN.get(child.tag, f"An element <{child.tag[:30]}>")
                if child.tag == "feImage" and child.get("href", "").startswith("#"):
                    what = "A part of the drawing that a filter repeats (feImage)"
                cure = _CURE.get(what, "Turn what it shows into shapes")
                address = child.get("href", "").partition("#")[0].partition("?")[0]
                if child.tag in ("image", "feImage") and address and address[:5] != "data:":
                    what, cure = _elsewhere(address)
                remarks.append(f"{what} was left out. {cure}.")
            for one in child.iter():
                kept.discard(one)
    return remarks


def _elsewhere(address: str) -> tuple[str, str]:
    """Return what to call an image in another file, and what helps."""
    called = f"in another file (“{address[-60:]}”)"
    if address.lower().endswith(_OF_PIXELS):
        return f"A bitmap {called}", "Trace it, or open it as a picture"
    kind = "drawing" if address.lower().endswith((".svg", ".svgz")) else "picture"
    return f"A {kind} {called}", "Open that, or embed it"


def _texts(kept: set[ET.Element]) -> list[str]:
    found = ("".join(one.itertext()).strip() for one in kept if one.tag == "text")
    return [text for text in found if text]


def _without_contexts(element: ET.Element, marker: bool) -> None:
    """Let paints that stand for those of a page or a program be inherited, but in markers."""
    marker = marker or element.tag == "marker"
    for name in ("fill", "stroke"):
        if not marker and element.get(name, "").startswith("context-"):
            del element.attrib[name]
    for child in element:
        _without_contexts(child, marker)


def _content(root: ET.Element, stretch: Matrix) -> ET.Element:
    """Return the document's content as a group with the root's own attributes."""
    content = ET.Element(
        "g", {name: value for name, value in root.attrib.items() if name not in _OF_ROOTS}
    )
    content.extend(list(root))
    if not content.attrib and [child.tag for child in content] == ["g"]:
        (content,) = content
    for name in ("fill", "color"):
        content.attrib.setdefault(name, "#000000")
    for stop in content.iter("stop"):
        stop.attrib.setdefault("stop-color", "#000000")
    if stretch != IDENTITY:
        outer = ET.Element("g", transform=f"matrix({written(stretch)})")
        outer.append(content)
        content = outer
    for element in content.iter():
        if element.tag == "a":
            element.tag = "g"
        alone = [
            f"{name}:{element.attrib.pop(name)}" for name in ONLY_IN_STYLE if name in element.attrib
        ]
        if alone:
            element.set("style", ";".join(alone))
    return content


def document(
    content: ET.Element,
    box: Box,
    rdf: ET.Element | None = None,
    marked: bool = False,
    page: Box | None = None,
) -> str:
    """Return a complete document that shows ``box`` of a content; ``rdf`` are its metadata.

    ``marked`` says that it is as black as it shall be, and ``page`` what it is a part of.
    """
    root = ET.Element("svg", xmlns="http://www.w3.org/2000/svg", viewBox=written(box))
    if marked:
        root.set(ATTRIBUTE, "yes")
    if page is not None:
        root.set(PAGE, written(page))
    if rdf is not None:
        ET.SubElement(root, "metadata").append(rdf)
    root.append(content)
    return ET.tostring(root, encoding="unicode")
