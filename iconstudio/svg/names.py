"""Names of elements and attributes as SVG spells them: HTML forgets their case, JSX has its own.

``strokeWidth``, ``className``, ``viewbox`` and ``<LinearGradient>`` are read as pages read them.
"""

import re
from functools import lru_cache

_CAPITAL = re.compile(r"[A-Z]")
_TAGS = (
    "linearGradient", "radialGradient", "clipPath", "textPath", "foreignObject", "animateMotion",
    "animateTransform", "animateColor", "feBlend", "feColorMatrix", "feComponentTransfer",
    "feComposite", "feConvolveMatrix", "feDiffuseLighting", "feDisplacementMap", "feDistantLight",
    "feDropShadow", "feFlood", "feFuncA", "feFuncB", "feFuncG", "feFuncR", "feGaussianBlur",
    "feImage", "feMerge", "feMergeNode", "feMorphology", "feOffset", "fePointLight",
    "feSpecularLighting", "feSpotLight", "feTile", "feTurbulence",
)  # fmt: skip
_ATTRIBUTES = (
    "viewBox", "preserveAspectRatio", "gradientUnits", "gradientTransform", "spreadMethod",
    "patternUnits", "patternTransform", "patternContentUnits", "clipPathUnits", "maskUnits",
    "maskContentUnits", "filterUnits", "primitiveUnits", "markerUnits", "markerWidth",
    "markerHeight", "refX", "refY", "pathLength", "stdDeviation", "textLength", "lengthAdjust",
    "startOffset", "attributeName", "repeatCount", "repeatDur", "keyTimes", "keyPoints",
    "keySplines", "calcMode", "systemLanguage", "requiredExtensions", "baseFrequency", "numOctaves",
)  # fmt: skip
_PROPERTIES = frozenset(
    (
        "stroke-width", "stroke-linecap", "stroke-linejoin", "stroke-miterlimit", "stroke-opacity",
        "stroke-dasharray", "stroke-dashoffset", "fill-opacity", "fill-rule", "clip-path",
        "clip-rule", "stop-color", "stop-opacity", "flood-color", "flood-opacity", "font-size",
        "font-family", "font-weight", "font-style", "text-anchor", "dominant-baseline",
        "alignment-baseline", "letter-spacing", "marker-start", "marker-mid", "marker-end",
        "mask-type", "paint-order", "vector-effect", "transform-origin", "transform-box",
        "mix-blend-mode", "color-interpolation-filters",
    )
)  # fmt: skip
_OTHERS = {"className": "class", "classname": "class", "class_": "class", "xlinkHref": "href"}
_TAG_OF = {one.lower(): one for one in _TAGS}
_ATTRIBUTE_OF = {one.lower(): one for one in _ATTRIBUTES}


def tag_name(name: str) -> str:
    """Return the name of an element of a document whose root is ``Svg`` or ``SVG``, say."""
    return _TAG_OF.get(name.lower(), name if name.lower() not in _PLAIN else name.lower())


_PLAIN = frozenset(
    (
        "svg", "g", "defs", "symbol", "use", "path", "rect", "circle", "ellipse", "line",
        "polyline", "polygon", "text", "tspan", "image", "mask", "pattern", "marker", "stop",
        "filter", "style", "title", "desc", "a", "switch", "animate", "set",
    )
)  # fmt: skip


@lru_cache(maxsize=1024)
def attribute_name(name: str) -> str:
    """Return the name of an attribute as SVG spells it."""
    if name in _OTHERS:
        return _OTHERS[name]
    found = _ATTRIBUTE_OF.get(name.lower())
    if found is not None:
        return found
    property_name = name.lower() if name.isupper() else hyphenated(name)
    if property_name in _PROPERTIES:
        return property_name
    return name.lower() if name[:1].isupper() else name  # of HTML, which knows no case


def hyphenated(name: str) -> str:
    """Return a property's name as CSS writes it: ``strokeWidth`` is ``stroke-width``."""
    return _CAPITAL.sub(lambda match: f"-{match[0].lower()}", name)
