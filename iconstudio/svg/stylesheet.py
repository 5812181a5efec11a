"""Style sheets and ``style`` attributes (CSS): the adapter of tinycss2.

Says which declarations apply to each element, and in which order; ``styles`` says what they mean.
"""

import math
import re
import xml.etree.ElementTree as ET
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field
from typing import Any

import tinycss2

from iconstudio.model import IconstudioError
from iconstudio.svg.matching import Matcher, SelectorError, compiled
from iconstudio.svg.parse import SHEET_ELSEWHERE
from iconstudio.svg.supports import supported

Declared = tuple[str, str, bool]
"""Property, value and whether it is important."""
Frame = tuple[float, list[Declared]]
Layer = tuple[float, ...]
"""The place of a cascade layer: its number in the layer around it, after all that are around."""
MAX_RULES = 5_000
_LONGEST_SELECTOR = 2_000
_SCREEN = 512.0
_FEATURES = {
    "prefers-color-scheme": ("light", "no-preference"),
    "prefers-contrast": ("no-preference",),
    "prefers-reduced-motion": ("no-preference",),
    "hover": ("hover",),
    "any-hover": ("hover",),
    "pointer": ("fine",),
    "any-pointer": ("fine",),
    "forced-colors": ("none",),
    "color": (),
}
"""What media features are taken to be."""
_PSEUDO_ELEMENTS = (
    None, "before", "after", "first-line", "first-letter", "selection", "marker", "placeholder",
    "backdrop", "cue", "part", "slotted", "file-selector-button", "target-text", "highlight",
    "view-transition", "details-content",
)  # fmt: skip
_CONDITIONAL = ("media", "supports", "layer", "scope")
_NESTING = ("media", "supports", "layer")
_OUTSIDE = (math.inf,)
"""What is in no layer (of those in a layer), and wins."""
_FONTS = re.compile(r"font", re.IGNORECASE)


@dataclass
class StyleSheet:
    """The rules of a document.

    Attributes
    ----------
    keyframes:
        For the name of each animation, its key frames: when, from 0 to 1, and the declarations.
    remarks:
        What was not understood, in sentences.
    """

    _matcher: Matcher
    keyframes: dict[str, list[Frame]] = field(default_factory=dict)
    remarks: list[str] = field(default_factory=list)
    _rules: int = 0
    _layers: dict[Layer, dict[str, float]] = field(default_factory=dict)
    """The numbers of the layers in each, by name."""

    @classmethod
    def of(cls, root: ET.Element) -> "StyleSheet":
        """Read the ``style`` elements of a document."""
        sheet = cls(Matcher(root))
        for element in root.iter("style"):
            kind = element.get("type", "text/css").strip().lower()
            if kind in ("", "text/css") and sheet._applies(element.get("media", "")):
                sheet._read("".join(element.itertext()))
        return sheet

    def matches(self) -> Iterator[tuple[ET.Element, list[Declared]]]:
        """Yield each element with the declarations for it, the strongest last.

        Presentation attributes count as the weakest.

        Raises
        ------
        IconstudioError
            If rules apply too often.
        """
        for element, layered in self._matcher.matches():
            declared = [(name, value, False) for name, value in element.items() if name != "style"]
            declared += _cascaded(layered)
            declared += declarations_of(element.get("style", ""))
            declared.sort(key=lambda one: one[2])
            yield element, declared

    def _read(self, text: str) -> None:
        text = text.strip().removeprefix("<!--").removesuffix("-->")
        self._take(tinycss2.parse_stylesheet(text, skip_comments=True, skip_whitespace=True))

    def _take(self, rules: Sequence[Any], layer: Layer = ()) -> None:
        for rule in rules:
            match rule.type:
                case "qualified-rule":
                    self._add(tinycss2.serialize(rule.prelude).strip(), rule.content, layer)
                case "at-rule":
                    self._at(rule, layer)
                case "error":
                    self.remarks.append("A part of the style sheet was not understood.")

    def _at(self, rule: Any, layer: Layer) -> None:
        keyword, prelude = rule.lower_at_keyword, tinycss2.serialize(rule.prelude).strip()
        if keyword == "layer" and rule.content is None:
            for name in prelude.split(","):
                self._layer(name, layer)
        elif keyword in _CONDITIONAL and rule.content is not None:
            inner = self._within(rule, layer)
            if inner is not None:
                self._take(
                    tinycss2.parse_rule_list(
                        rule.content, skip_comments=True, skip_whitespace=True
                    ),
                    inner,
                )
        elif keyword.endswith("keyframes") and rule.content:
            self.keyframes[prelude.strip("\"'")] = list(_frames(rule.content))
        elif keyword == "import" and not _FONTS.search(prelude):
            self.remarks.append(SHEET_ELSEWHERE)

    def _within(self, rule: Any, layer: Layer) -> Layer | None:
        """Return the layer of what is in an at-rule; None if it does not apply."""
        prelude = tinycss2.serialize(rule.prelude).strip()
        match rule.lower_at_keyword:
            case "media":
                return layer if self._applies(prelude) else None
            case "supports":
                return layer if supported(rule.prelude, _is_selector) else None
            case "layer":
                return self._layer(prelude, layer)
        return layer

    def _layer(self, name: str, outer: Layer) -> Layer:
        """Return the place of a layer, ``a.b`` or without a name: that of its first mention."""
        for part in name.split("."):
            inner = self._layers.setdefault(outer, {})
            key = part.strip() or f" {len(inner)}"  # another one for each without a name
            outer = *outer, inner.setdefault(key, float(len(inner)))
        return outer

    def _add(self, selector: str, content: Any, layer: Layer) -> None:
        """Add a rule, and those nested in it."""
        self._rules += 1
        if self._rules > MAX_RULES:
            raise IconstudioError(f"It has more than {MAX_RULES:,} style rules. Simplify it.")
        if len(selector) > _LONGEST_SELECTOR:
            self.remarks.append("A style rule with too many selectors was left out.")
            return
        parts = tinycss2.parse_blocks_contents(content, skip_comments=True, skip_whitespace=True)
        declarations = list(_declarations(parts))
        try:
            selectors = compiled(selector) if declarations else ()
        except SelectorError:
            self.remarks.append(
                f"The style rule for “{selector[:40]}” was not understood and left out."
            )
            return
        for one in selectors:
            self._matcher.add_selector(one, ((*layer, *_OUTSIDE), declarations))
        for part in parts:
            if part.type == "qualified-rule":
                self._add(_nested(tinycss2.serialize(part.prelude), selector), part.content, layer)
            elif part.type != "at-rule":
                continue
            elif part.lower_at_keyword in _NESTING and part.content:
                inner = self._within(part, layer)
                if inner is not None:
                    self._add(selector, part.content, inner)
            else:
                self.remarks.append(f"“@{part.at_keyword}” within a style rule was left out.")

    @staticmethod
    def _applies(media: str) -> bool:
        """Whether rules for these media hold on the screen that icons are for."""
        queries = [one.strip().lower() for one in media.split(",") if one.strip()]
        return not queries or any(map(_holds, queries))


def _holds(query: str) -> bool:
    """Whether a media query holds: a light screen, ``_SCREEN`` pixels wide, one to a CSS pixel."""
    negated = query.startswith("not ")
    plain = re.sub(r"^(not|only)\s+", "", query)
    kind = re.match(r"[a-z]+", plain)
    fits = (kind is None or kind[0] in ("all", "screen")) and all(
        name.strip() in _FEATURES or _within(name.strip(), value.strip())
        if value.strip() == "" or not _FEATURES.get(name.strip())
        else value.strip() in _FEATURES[name.strip()]
        for name, _, value in (one.partition(":") for one in re.findall(r"\(([^()]*)\)", plain))
    )
    return fits != negated


def _within(name: str, value: str) -> bool:
    """Whether a bound of a size or of a resolution holds."""
    number = re.match(r"[\d.]+", value)
    if number is None or not name.startswith(("min-", "max-")):
        return False
    size = 1.0 if "resolution" in name or "pixel-ratio" in name else _SCREEN
    bound = float(number[0]) * (16 if value.endswith("em") else 1)
    return size >= bound if name.startswith("min-") else size <= bound


def _is_selector(said: str) -> bool:
    """Whether browsers may know a selector."""
    try:
        found = compiled(said)
    except SelectorError:
        return False
    return all(one.pseudo_element in _PSEUDO_ELEMENTS for one in found)


def _cascaded(layered: Sequence[tuple[Layer, list[Declared]]]) -> list[Declared]:
    """Return what rules declare, the strongest last: where it is important, of the first layer."""
    found = [(layer, one) for layer, declarations in layered for one in declarations]
    plain = sorted((one for one in found if not one[1][2]), key=lambda one: one[0])
    important = sorted(
        (one for one in found if one[1][2]), key=lambda one: [-number for number in one[0]]
    )
    return [one for _, one in [*plain, *important]]


def declarations_of(style: str) -> list[Declared]:
    """Return the declarations of a ``style`` attribute."""
    if not style.strip():
        return []
    parts = tinycss2.parse_blocks_contents(style, skip_comments=True, skip_whitespace=True)
    return list(_declarations(parts))


def tokens_of(value: str) -> list[Any]:
    """Return a value as tokens, which know their ``type`` and how to ``serialize``."""
    tokens: list[Any] = tinycss2.parse_component_value_list(value)
    return tokens


def _declarations(parts: Sequence[Any]) -> Iterator[Declared]:
    for one in parts:
        if one.type == "declaration":
            name = one.name if one.name.startswith("--") else one.lower_name
            yield name, tinycss2.serialize(one.value).strip(), one.important


def _nested(selector: str, outer: str) -> str:
    """Return the selector of a nested rule as one that stands alone (CSS Nesting)."""
    parts = [
        part.replace("&", f":is({outer})") if "&" in part else f":is({outer}) {part}"
        for part in selector.split(",")
    ]
    return ", ".join(part.strip() for part in parts)


def _frames(content: Any) -> Iterator[Frame]:
    """Yield the key frames of an animation."""
    for rule in tinycss2.parse_rule_list(content, skip_comments=True, skip_whitespace=True):
        if rule.type != "qualified-rule":
            continue
        parts = tinycss2.parse_blocks_contents(
            rule.content, skip_comments=True, skip_whitespace=True
        )
        declared = list(_declarations(parts))
        for when in tinycss2.serialize(rule.prelude).lower().split(","):
            part = re.sub("^from$", "0%", re.sub("^to$", "100%", when.strip()))
            if re.fullmatch(r"[\d.]+%", part):
                yield float(part[:-1]) / 100, declared
