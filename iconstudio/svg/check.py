"""Refuses an SVG document that a renderer might not survive, before any renderer sees it.

Renderers crash on deep nesting, hang on nested patterns, and multiply without
end what ``use`` elements repeat, so all of it is counted beforehand. What this misses ends
the worker process that renders it, by its limits of time and memory. Every check here takes time
in proportion to the document, whatever it holds.
"""

import re
from dataclasses import dataclass, field
from xml.parsers import expat

from iconstudio.model import IconstudioError

MAX_BYTES = 2_000_000
MAX_ELEMENTS = 20_000
MAX_DEPTH = 100
"""Nesting of a drawing, references followed: resvg overflows its stack at 300."""
_AROUND = 3
"""Levels that are put around a drawing as it is read: a root, a stretch, a space that is near."""
MAX_EXPANSION = 50_000
"""Elements that are drawn once every reference has been replaced by what it names."""

_URL = re.compile(r"url\(\s*[\"']?\s*([^)\"'\s]*)")
_CLASS = re.compile(r"\.([\w-]+)")
_COMMENT = re.compile(r"/\*.*?(?:\*/|\Z)", re.DOTALL)
_UNFOLLOWED = ("a", "animate", "animateMotion", "animateTransform", "mpath", "set")
"""Elements whose reference a renderer of still pictures does not follow."""
_INHERITING = ("linearGradient", "radialGradient", "pattern", "filter")
"""Elements that take over the content of the one they refer to."""


def check(svg: str, depth: int = MAX_DEPTH + _AROUND) -> None:
    """Return if ``svg`` is safe to render in a worker process.

    It may be nested as deep as ``depth``, references followed: a drawing that was not read yet
    ``MAX_DEPTH``.

    Raises
    ------
    IconstudioError
        If the document is not well-formed XML, is too large or too deep, defines entities, holds
        bitmaps or scripts, refers to anything outside itself, refers to itself in a circle,
        nests patterns, or repeats elements too often.
    """
    document = _read(svg, depth)
    if not document.nodes or document.nodes[0].tag != "svg":
        raise IconstudioError("The file is not an SVG drawing: its root element is not <svg>.")
    document.apply_style_sheet()
    _Expansion(document, depth).measure(0, 1)


@dataclass(slots=True)
class _Node:
    tag: str
    classes: list[str] = field(default_factory=list)
    below: list[int] = field(default_factory=list)
    """Children."""
    names: list[str] = field(default_factory=list)
    """Identifiers of the elements that it shows."""
    inherited: list[str] = field(default_factory=list)
    """Identifiers of the elements whose content it takes over as its own."""


@dataclass(slots=True)
class _Document:
    nodes: list[_Node] = field(default_factory=list)
    ids: dict[str, list[int]] = field(default_factory=dict)
    """All elements of each identifier: of several, renderers differ in which they take."""
    style_sheet: list[str] = field(default_factory=list)

    def apply_style_sheet(self) -> None:
        """Give every element the references of the rules for its classes."""
        rules: dict[str, list[str]] = {}
        for rule in _COMMENT.sub("", "".join(self.style_sheet)).split("}"):
            before, _, body = rule.rpartition("{")
            names = [_local(target) for target in _URL.findall(body)]
            if not names:
                continue
            # A brace further left is that of an @media block around it.
            for selector in before.rpartition("{")[2].split(","):
                match = _CLASS.fullmatch(selector.strip())
                if match is None:
                    raise IconstudioError(
                        f"The style sheet refers to #{names[0]} for {selector.strip()!r}; "
                        "only rules for a class may do so. Export with presentation attributes."
                    )
                rules.setdefault(match[1], []).extend(names)
        if not rules:
            return
        count = 0
        for node in self.nodes:
            for names in filter(None, map(rules.get, node.classes)):
                count += len(names)
                if count > MAX_EXPANSION:
                    raise _too_often()
                node.names += names


def _read(svg: str, depth: int) -> _Document:
    """Parse ``svg`` within bounds of bytes, elements and depth."""
    try:
        data = svg.encode()
    except UnicodeEncodeError:
        raise IconstudioError("The SVG holds characters that are no valid Unicode.") from None
    if len(data) > MAX_BYTES:
        raise IconstudioError(
            f"The SVG has {len(data):,} bytes; at most {MAX_BYTES:,} are read. Simplify it."
        )
    document = _Document()
    stack: list[int] = []

    def start(name: str, attributes: dict[str, str]) -> None:
        node = _node(_local_name(name), attributes)
        number = len(document.nodes)
        if number >= MAX_ELEMENTS:
            raise IconstudioError(f"The SVG has more than {MAX_ELEMENTS:,} elements. Simplify it.")
        if len(stack) >= depth:
            raise _too_deep()
        if stack:
            document.nodes[stack[-1]].below.append(number)
        for key, value in attributes.items():
            if _local_name(key) == "id":  # in whatever namespace: so the renderer reads it
                document.ids.setdefault(value, []).append(number)
        document.nodes.append(node)
        stack.append(number)

    def end(_name: str) -> None:
        stack.pop()

    def text(data: str) -> None:
        if stack and document.nodes[stack[-1]].tag == "style":
            document.style_sheet.append(data)

    def doctype(_name: str, _system: str | None, _public: str | None, internal: bool) -> None:
        if internal:  # a mere mention of the SVG 1.1 DTD, as old programs write it, is harmless
            raise IconstudioError("The SVG defines its own document type; remove its DOCTYPE.")

    parser = expat.ParserCreate("utf-8")
    parser.StartElementHandler = start
    parser.EndElementHandler = end
    parser.CharacterDataHandler = text
    parser.StartDoctypeDeclHandler = doctype
    try:
        parser.Parse(data, True)
    except expat.ExpatError as error:
        raise IconstudioError(f"The SVG is not well-formed XML: {error}. Save it again.") from None
    return document


def _node(tag: str, attributes: dict[str, str]) -> _Node:
    """Return the element with what it refers to."""
    if tag in ("image", "feImage"):
        raise IconstudioError(f"The SVG shows a bitmap (<{tag}>); only shapes can be remixed.")
    if tag == "script":
        raise IconstudioError("The SVG holds a script; remove it.")
    node = _Node(tag)
    for name, value in attributes.items():
        if _local_name(name) == "class":
            node.classes += value.split()
        elif _local_name(name) == "href":
            if tag in _INHERITING:
                node.inherited.append(_local(value))
            elif tag not in _UNFOLLOWED:
                node.names.append(_local(value))
        elif "url(" in value:
            node.names += [_local(target) for target in _URL.findall(value)]
    return node


def _local_name(name: str) -> str:
    return name.rpartition(":")[2]


def _local(target: str) -> str:
    """Return the identifier of a reference ``#id`` within the document."""
    target = target.strip()
    if not target.startswith("#"):
        raise IconstudioError(
            f"The SVG refers to {target[:60]!r} outside itself; embed what it uses."
        )
    return target[1:]


class _Expansion:
    """Measures what the document becomes once references are followed."""

    def __init__(self, document: _Document, deepest: int) -> None:
        self._document = document
        self._deepest = deepest
        self._known: dict[int, tuple[int, int, int]] = {}
        self._open: set[int] = set()

    def measure(self, number: int, depth: int) -> tuple[int, int, int]:
        """Return elements drawn, levels, and levels of patterns at and below a node."""
        known = self._known.get(number)
        if known is None:
            if number in self._open:
                raise IconstudioError("The SVG refers to itself in a circle; remove the reference.")
            if depth > self._deepest:
                raise _too_deep()
            self._open.add(number)
            known = self._known[number] = self._sum(number, depth)
            self._open.remove(number)
        if depth + known[1] > self._deepest + 1:
            raise _too_deep()
        return known

    def _named(self, names: list[str]) -> list[int]:
        return [number for name in names for number in self._document.ids.get(name, ())]

    def _sum(self, number: int, depth: int) -> tuple[int, int, int]:
        node = self._document.nodes[number]
        drawn, levels, patterns = 1, 0, 0
        for next_node in [*node.below, *self._named(node.names)]:
            more, deeper, inner = self.measure(next_node, depth + 1)
            drawn, levels, patterns = drawn + more, max(levels, deeper), max(patterns, inner)
        patterns += node.tag == "pattern"
        for next_node in self._named(node.inherited):
            more, deeper, inner = self.measure(next_node, depth + 1)
            drawn, levels, patterns = drawn + more, max(levels, deeper), max(patterns, inner)
        if drawn > MAX_EXPANSION:
            raise _too_often()
        if patterns > 1:
            raise IconstudioError("The SVG fills a pattern with a pattern; replace one by shapes.")
        return drawn, levels + 1, patterns


def _too_deep() -> IconstudioError:
    return IconstudioError(
        f"The SVG nests its elements more than {MAX_DEPTH} deep. Ungroup some of them."
    )


def _too_often() -> IconstudioError:
    return IconstudioError(
        f"The SVG repeats its elements more than {MAX_EXPANSION:,} times. Simplify it."
    )
