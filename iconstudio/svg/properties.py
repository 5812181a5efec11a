"""The properties of CSS that browsers know, and whether a value may be one of theirs.

Properties, keywords and functions are those of the browsers of 2024. Where a property takes
more than colours, numbers or a few keywords, only the functions in its value are looked at.
"""

import re
from collections.abc import Callable, Sequence
from typing import Any

from iconstudio.svg.colours import colour

_LONGEST = 60
"""Most characters of a value that is quoted."""


def is_known(name: str, tokens: Sequence[Any]) -> bool:
    """Whether browsers know a property and may take a value, in tokens without blanks."""
    if name.startswith("--"):
        return True
    name = _PREFIXED.get(name.lower(), name.lower())
    value = " ".join(one.serialize() for one in tokens)
    if name not in _PROPERTIES or not value:
        return False
    if value.lower() in _OF_ALL:
        return True
    functions = set(_functions(tokens))
    if functions & _SUBSTITUTED:
        return True
    if not functions <= _FUNCTIONS:
        return False
    return next((fits(value) for names, fits in _VALUES if name in names), True)


def not_understood(name: str, value: str) -> str:
    """Return the sentence that says that the value of a property was left out."""
    said = " ".join(value.split())
    said = said if len(said) <= _LONGEST else f"{said[:_LONGEST]}…"
    return f"“{name}: {said}” was not understood and left out."


def _functions(tokens: Sequence[Any]) -> list[str]:
    """Return the names of all functions in a value, nested ones too."""
    found: list[str] = []
    for one in tokens:
        if one.type == "function":
            found += [one.lower_name, *_functions(one.arguments)]
        elif one.type.endswith("block"):
            found += _functions(one.content)
    return found


def _words(text: str) -> frozenset[str]:
    return frozenset(text.split())


def _one_of(text: str) -> Callable[[str], bool]:
    """Return whether a value consists of such words."""
    known = _words(text)
    return lambda value: _words(value.lower()) <= known


def _is_colour(value: str) -> bool:
    return colour(value) is not None or value.lower() in _SYSTEM_COLOURS


def _is_paint(value: str) -> bool:
    plain = re.sub(r"url\([^)]*\)", "", value).strip()
    return plain.lower() in ("", "none", "context-fill", "context-stroke") or _is_colour(plain)


_NUMBER = r"[+-]?(?:\d+\.?\d*|\.\d+)(?:e[+-]?\d+)?"
_CALCULATED = r"(?:calc|min|max|clamp|round|abs|sign|mod|rem|sin|cos|tan|sqrt|pow|hypot|exp|log)"
_AMOUNT = re.compile(rf"{_NUMBER}%?|{_CALCULATED}\(.*\)", re.IGNORECASE)
_LENGTH = re.compile(
    rf"{_NUMBER}(?:px|pt|pc|mm|cm|in|q|r?em|r?ex|r?ch|r?ic|r?lh|r?cap|%|[sld]?v[wh]|[sld]?vmin"
    rf"|[sld]?vmax|[sld]?v[ib]|cq[whib]|cqmin|cqmax)?|{_CALCULATED}\(.*\)"
    r"|(?:fit-content|anchor|anchor-size|calc-size)\(.*\)",
    re.IGNORECASE,
)


def _is_length(value: str) -> bool:
    return _LENGTH.fullmatch(value) is not None or value.lower() in _SIZES


def _is_amount(value: str) -> bool:
    return _AMOUNT.fullmatch(value) is not None


_OF_ALL = _words("inherit initial unset revert revert-layer")
_SUBSTITUTED = _words("var env attr")
_PREFIXED = {
    f"-webkit-{name}": name
    for name in _words(
        "mask mask-image mask-size mask-position mask-repeat mask-composite filter clip-path "
        "transform transform-origin animation animation-name transition appearance user-select "
        "backface-visibility perspective box-shadow border-radius background-clip box-sizing flex "
        "align-items justify-content order columns text-size-adjust backdrop-filter "
        "background-size box-reflect line-clamp text-stroke text-fill-color "
        "text-stroke-width text-stroke-color tap-highlight-color overflow-scrolling font-smoothing"
    )
}
_SYSTEM_COLOURS = _words(
    "canvas canvastext linktext visitedtext activetext buttonface buttontext buttonborder field "
    "fieldtext highlight highlighttext selecteditem selecteditemtext mark marktext graytext "
    "accentcolor accentcolortext currentcolor transparent"
)
_SIZES = _words(
    "auto none normal min-content max-content fit-content stretch content -webkit-fill-available "
    "-moz-available thin medium thick xx-small x-small small large x-large xx-large xxx-large "
    "smaller larger math"
)
_FUNCTIONS = _words(
    "calc min max clamp round mod rem abs sign sin cos tan asin acos atan atan2 pow sqrt hypot log "
    "exp rgb rgba hsl hsla hwb lab lch oklab oklch color color-mix light-dark url src image-set "
    "linear-gradient radial-gradient conic-gradient repeating-linear-gradient "
    "repeating-radial-gradient repeating-conic-gradient -webkit-linear-gradient "
    "-webkit-radial-gradient -webkit-image-set cross-fade matrix matrix3d translate translatex "
    "translatey translatez translate3d scale scalex scaley scalez scale3d rotate rotatex rotatey "
    "rotatez rotate3d skew skewx skewy perspective blur brightness contrast drop-shadow grayscale "
    "hue-rotate invert opacity saturate sepia inset circle ellipse polygon path rect xywh shape "
    "ray cubic-bezier steps linear minmax repeat fit-content counter counters symbols anchor "
    "anchor-size calc-size scroll view"
)
_DISPLAY = (
    "none contents inline block flow flow-root flex grid table ruby list-item inline-block "
    "inline-flex inline-grid inline-table table-row table-cell table-column table-caption "
    "table-row-group table-header-group table-footer-group table-column-group ruby-base ruby-text "
    "math -webkit-box -webkit-inline-box -webkit-flex -webkit-inline-flex"
)
_BLENDING = (
    "normal multiply screen overlay darken lighten color-dodge color-burn hard-light soft-light "
    "difference exclusion hue saturation color luminosity plus-lighter"
)
_VALUES: tuple[tuple[frozenset[str], Callable[[str], bool]], ...] = (
    (_words("fill stroke"), _is_paint),
    (
        _words(
            "color stop-color flood-color lighting-color background-color border-color "
            "outline-color text-decoration-color column-rule-color border-top-color "
            "border-right-color border-bottom-color border-left-color text-fill-color "
            "text-stroke-color tap-highlight-color"
        ),
        _is_colour,
    ),
    (_words("accent-color caret-color"), lambda value: value == "auto" or _is_colour(value)),
    (
        _words(
            "opacity fill-opacity stroke-opacity stop-opacity flood-opacity flex-grow flex-shrink"
        ),
        _is_amount,
    ),
    (
        _words(
            "stroke-width stroke-dashoffset x y cx cy r rx ry width height min-width min-height "
            "max-width max-height inline-size block-size top right bottom left font-size "
            "letter-spacing word-spacing line-height row-gap column-gap margin-top margin-right "
            "margin-bottom margin-left padding-top padding-right padding-bottom padding-left "
            "flex-basis text-indent column-width outline-offset text-stroke-width"
        ),
        _is_length,
    ),
    (_words("display"), _one_of(_DISPLAY)),
    (_words("visibility"), _one_of("visible hidden collapse")),
    (_words("position"), _one_of("static relative absolute fixed sticky -webkit-sticky")),
    (_words("float"), _one_of("none left right inline-start inline-end")),
    (_words("clear"), _one_of("none left right both inline-start inline-end")),
    (_words("overflow overflow-x overflow-y"), _one_of("visible hidden clip scroll auto overlay")),
    (_words("box-sizing"), _one_of("content-box border-box")),
    (_words("fill-rule clip-rule"), _one_of("nonzero evenodd")),
    (_words("stroke-linecap"), _one_of("butt round square")),
    (_words("stroke-linejoin"), _one_of("miter round bevel")),
    (_words("paint-order"), _one_of("normal fill stroke markers")),
    (_words("vector-effect"), _one_of("none non-scaling-stroke")),
    (_words("mask-type"), _one_of("luminance alpha")),
    (_words("mask-composite"), _one_of("add subtract intersect exclude source-over source-in "
                                       "source-out xor ,")),
    (_words("mix-blend-mode background-blend-mode"), _one_of(_BLENDING)),
    (_words("isolation"), _one_of("auto isolate")),
    (_words("text-anchor"), _one_of("start middle end")),
    (_words("text-transform"), _one_of("none uppercase lowercase capitalize full-width "
                                       "full-size-kana math-auto")),
    (_words("writing-mode"), _one_of("horizontal-tb vertical-rl vertical-lr sideways-rl "
                                     "sideways-lr lr lr-tb rl tb tb-rl")),
    (_words("direction"), _one_of("ltr rtl")),
    (_words("transform-box"), _one_of("content-box border-box fill-box stroke-box view-box")),
    (_words("transform-style"), _one_of("flat preserve-3d")),
    (_words("backface-visibility"), _one_of("visible hidden")),
    (_words("pointer-events"), _one_of("auto none all fill stroke painted visible visiblefill "
                                       "visiblestroke visiblepainted bounding-box")),
    (_words("shape-rendering"), _one_of("auto optimizespeed crispedges geometricprecision")),
    (_words("image-rendering"), _one_of("auto smooth crisp-edges pixelated high-quality "
                                        "-webkit-optimize-contrast optimizespeed optimizequality")),
    (_words("object-fit"), _one_of("fill contain cover none scale-down")),
    (_words("flex-direction"), _one_of("row row-reverse column column-reverse")),
    (_words("flex-wrap"), _one_of("nowrap wrap wrap-reverse")),
    (_words("user-select"), _one_of("auto text none contain all")),
    (_words("color-scheme"), _one_of("normal light dark only")),
    (_words("font-style"), lambda value: value.split()[0] in ("normal", "italic", "oblique")),
    (
        _words("font-weight"),
        lambda value: _is_amount(value) or value in ("normal", "bold", "bolder", "lighter"),
    ),
    (
        _words("transform"),
        lambda value: value == "none" or re.fullmatch(r"(?:[a-z0-9]+\(.*\)\s*)+", value.lower())
        is not None,
    ),
    (_words("d"), lambda value: value == "none" or value.lower().startswith("path(")),
)  # fmt: skip
_PROPERTIES = frozenset().union(*(names for names, _ in _VALUES)) | _words(
    "all accent-color align-content align-items align-self alignment-baseline animation "
    "animation-composition animation-delay animation-direction animation-duration "
    "animation-fill-mode animation-iteration-count animation-name animation-play-state "
    "animation-range animation-timeline animation-timing-function appearance aspect-ratio "
    "backdrop-filter background background-attachment background-clip background-image "
    "background-origin background-position background-repeat background-size baseline-shift "
    "border border-bottom border-collapse border-image border-left border-radius border-right "
    "border-spacing border-style border-top border-width box-reflect box-shadow break-after "
    "break-before break-inside caption-side clip clip-path color-interpolation "
    "color-interpolation-filters column-count column-fill column-rule column-span columns contain "
    "container container-name container-type content content-visibility counter-increment "
    "counter-reset counter-set cursor dominant-baseline empty-cells field-sizing filter flex "
    "flex-flow font font-family font-feature-settings font-kerning font-optical-sizing "
    "font-palette font-size-adjust font-smoothing font-stretch font-synthesis font-variant "
    "font-variation-settings forced-color-adjust gap grid grid-area grid-auto-columns "
    "grid-auto-flow grid-auto-rows grid-column grid-column-end grid-column-gap grid-column-start "
    "grid-gap grid-row grid-row-end grid-row-gap grid-row-start grid-template grid-template-areas "
    "grid-template-columns grid-template-rows hyphens inset inset-block inset-inline "
    "interpolate-size justify-content justify-items justify-self line-break line-clamp list-style "
    "list-style-image list-style-position list-style-type margin margin-block margin-inline marker "
    "marker-end marker-mid marker-start mask mask-border mask-clip mask-image mask-mode "
    "mask-origin mask-position mask-repeat mask-size object-position offset offset-anchor "
    "offset-distance offset-path offset-position offset-rotate order orphans outline outline-style "
    "outline-width overflow-anchor overflow-clip-margin overflow-wrap overscroll-behavior padding "
    "padding-block padding-inline page perspective perspective-origin place-content place-items "
    "place-self quotes resize rotate scale scroll-behavior scroll-margin scroll-padding "
    "scroll-snap-align scroll-snap-type scroll-timeline scrollbar-color scrollbar-gutter "
    "scrollbar-width shape-image-threshold shape-margin shape-outside stroke-dasharray "
    "stroke-miterlimit tab-size table-layout text-align text-align-last text-combine-upright "
    "text-decoration text-decoration-line text-decoration-style text-decoration-thickness "
    "text-emphasis text-orientation text-overflow text-rendering text-shadow text-size-adjust "
    "text-stroke text-underline-offset text-wrap touch-action transform-origin transition "
    "transition-behavior transition-delay transition-duration transition-property "
    "transition-timing-function translate unicode-bidi vertical-align view-timeline "
    "view-transition-name white-space widows will-change word-break word-wrap z-index zoom"
)
