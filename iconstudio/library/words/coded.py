"""Names of icons as code writes them: markup, classes, components, identifiers of other sets."""

import re

from iconstudio.library.words.usage import BRANDS

_TAG = re.compile(r"<\s*([A-Za-z][\w.-]*)(?=[\s/>])([^<>]*)>?(?:\s*([\w-]+)\s*<)?")
"""The beginning of an element of markup: its name, its attributes, and the word in it."""
_VALUE = r"""\s*=\s*[{\["'\s]*(?:['"]?\w+['"],\s*)?['"]?([^"'}\]]+)"""
_NAMING = re.compile(
    r"(?:^|[\s:\[])(?:icon|name|fonticon|svgicon|data-(?:lucide|feather|icon|eva))\]?" + _VALUE,
    re.IGNORECASE,
)
"""Attributes that say which icon it is: *icon="mdi:home"*, *icon={faHouse}*, *data-lucide=home*."""
_LINK = re.compile(r"""href\s*=\s*["'][^"'#]*#([\w-]+)""")
_CLASS = re.compile(r"(?:^|\s)class(?:Name)?" + _VALUE)
_NAMED_ELEMENT = re.compile(r"i-|.*-icon$|.*[A-Z]")
"""Elements that are icons by their own names, if nothing else says which."""
_AROUND = (
    re.compile(r"^import\s+\{?\s*([A-Za-z]\w+)\s*\}?\s+from\s+['\"]\S+$"),
    re.compile(r"""\bsystem(?:Name|Image):\s*["']([\w.]+)["']"""),
    re.compile(r"^(?:~icons|virtual:icons|@iconify-icons|@iconify)/(?:icons-)?(\S+)$"),
    re.compile(r"^(?:\S*/)?([^\s/]{2,})\.(?:svg|png|ico|vue|[jt]sx|xml)$", re.IGNORECASE),
    re.compile(r"^(?:\w*Icons?|R\.drawable|Symbols)\.(?:(?:Default|AutoMirrored)\.)?(\w[\w.]*)$"),
    re.compile(r"^@drawable/(\w+)$"),
)
"""What else code writes around the name of one icon: imports, calls, files, constants."""
_MODIFIER = re.compile(
    r"\s+(?:fa|mdi|bx|ti|ri|la|zmdi)-(?:\d*x[sl]|\d+x|\d+px|lg|sm|fw|spin|pulse|inverse|border|tada"
    r"|(?:flip|rotate)-\w+)(?=\s|$)"
    r"|_(?:(?:black|white)_)?\d+(?:dp|px)$"
)
"""What stands beside the name of an icon for its size and colour: *fa-2x*, *mdi-24px*, *_24dp*."""
_CLASSES = re.compile(r"^([a-z]{2,}?)[a-z]?((?:-[a-z]+)*)\s+(?=\1[a-z]?-\w)|^feather\s+icon-")
"""A class of a whole set before that of an icon: *fas fa-house*, *ph-bold ph-bell*."""
_SETS = (
    "bi", "bx[sl]?", "ci", "cil", "codicon", "dashicons(?:-admin)?", "ei", "ep", "eva",
    "fa[srlbdt]?", "fe", "feather", "fi(?:-[bstr][rs])?", "flaticon", "fontello", "gg",
    "glyphicons?", "heroicons?(?:-[osm])?", "ic", "icofont", "iconoir", "ion(?:-(?:ios|md|logo))?",
    "ki",
    "la[srb]?", "lni", "lnr", "lucide", "mdi", "nf(?:-[a-z]+)?", "octicon", "oi", "ph", "pi", "ri",
    "tabler", "themify", "ti", "typcn", "ui[lmstw]", "zmdi",
)  # fmt: skip
"""What code calls sets of icons by, where that is no word of what they show."""
_SET = re.compile(
    rf"(?:^|(?<=\s))(?:(?:{'|'.join(_SETS)})(?:-|--|/)|ic_|ico[-_])(?=\w)"
    r"|^material-(?:icons|symbols)\S*\s+(?=\w)"
)
_COMPONENT = re.compile(
    r"^(?!WiFi|HiFi|GoPro)(?:"
    r"(?:Ai|Bi|Bs|Bx[sl]?|Cg|Ci|Di|Fa6?(?:Reg)?|Fc|Fi|Gi|Go|Gr|Hi2?|Im|Io5?(?:Md|Ios|Logo)?|Lia|Lu|Md"
    r"|Ph|Pi|Ri|Rx|Si|Sl|Tb|Tfi|Ti|Vsc|Wi|Uil|Lucide|Icon(?:Brand)?"
    r"|bootstrap|bx[sl]?|cil|fa[srb]?|feather|hero|ion|lucide|mat|mdi|octicon|ph|phosphor|remix|tabler"
    r")(?=[A-Z][a-z]))|(?<=[a-z0-9])Icon$"
    r"|(?<=[a-z0-9])(?=(?:Fill(?:ed)?|Outlined?|Regular|Rounded|Sharp|Solid|TwoTone|Duotone)(?:Icon)?$)"
)
"""What libraries of components put around names: *FaHouse*, *mdiHome*, *IconHome*, *HomeIcon*; and
where a style follows: *HomeOutlined*, *Trash24Filled*."""
_CAPITAL = re.compile(r"(?<=[a-z0-9])(?=[A-Z])|(?<=[a-z])(?=\d\d[A-Z])")


def of_one(name: str) -> str:
    """Return what a list of classes, or an element of markup, says of one icon.

    >>> [of_one(name) for name in ("mdi mdi-home", '<Icon icon="mdi:home" />', "<MdHome />")]
    ['mdi-home', 'mdi:home', 'MdHome']
    """
    name = " ".join(name.split())  # patterns are slow on long runs of blanks
    if tag := _TAG.match(name):
        name = _of_element(name, *tag.groups(""))
    around = (found[1] for one in _AROUND if (found := one.search(name)))
    name = _MODIFIER.sub("", next(around, name))
    return _CLASSES.sub(r"\2 ", name).strip(" -")


def _of_element(markup: str, element: str, attributes: str, text: str) -> str:
    """Return what an element of markup says of its icon: by an attribute, its text, or its name."""
    if found := _NAMING.search(attributes) or _LINK.search(markup):
        return found[1].strip()
    if text or _NAMED_ELEMENT.match(element):
        return text or element
    named = _CLASS.search(attributes)
    return named[1] if named else element


def uncoded(name: str) -> str:
    """Return a name without what code puts around it; any other text as it is.

    >>> [uncoded(name) for name in ("fas fa-house", "AiOutlineHome", "feather-home", "WiFi")]
    ['house', 'Outline Home', 'home', 'WiFi']
    >>> [uncoded(name) for name in ("HomeFilled", "Home24Regular", "i-lucide-home", "home.svg")]
    ['Home Filled', 'Home 24 Regular', 'i-lucide-home', 'home']
    """
    name = _SET.sub("", of_one(name))
    bare = _COMPONENT.sub("", name)
    coded = bare != name or _COMPONENT.search(name) is not None
    if not coded or bare.casefold() in BRANDS:
        return bare
    return _CAPITAL.sub(" ", bare)


def names_set(name: str) -> bool:
    """Whether a name says of which set it is, as *mdi-home* does."""
    name = of_one(name)
    return ":" in name or _SET.search(name) is not None
