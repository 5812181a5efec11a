"""Names of icons as code writes them: classes, components, identifiers of other sets."""

import re

_CLASSES = re.compile(r"^([a-z]{2,}?)[a-z]?((?:-[a-z]+)*)\s+(?=\1[a-z]?-\w)|^feather\s+icon-")
"""A class of a whole set before that of an icon: *fas fa-house*, *ph-bold ph-bell*."""
_SETS = (
    "bi", "bx[sl]?", "ci", "cil", "codicon", "dashicons(?:-admin)?", "ei", "ep", "eva",
    "fa[srlbdt]?", "fe", "feather", "flaticon", "fontello", "gg", "glyphicons?", "heroicons", "ic",
    "icofont", "iconoir", "ki", "la[srb]?", "lni", "lnr", "lucide", "mdi", "nf(?:-[a-z]+)?", "ph",
    "pi", "ri", "tabler", "themify", "ti", "typcn", "ui[lmstw]",
)  # fmt: skip
"""What code calls sets of icons by, where that is no word of what they show."""
_SET = re.compile(
    rf"(?:^|(?<=\s))(?:{'|'.join(_SETS)})-(?=\w)|^material-(?:icons|symbols)\S*\s+(?=\w)"
)
_COMPONENT = re.compile(
    r"^(?!WiFi|HiFi|GoPro)(?:Ai|Bi|Bs|Cg|Ci|Di|Fa6?|Fc|Fi|Gi|Go|Gr|Hi2?|Im|Io5?|Lia|Lu|Md|Pi|Ri|Rx"
    r"|Si|Sl|Tb|Tfi|Ti|Vsc|Wi|fa|mdi|Icon)(?=[A-Z][a-z])|(?<=[a-z0-9])Icon$"
)
"""What libraries of components put around names: *FaHouse*, *mdiHome*, *IconHome*, *HomeIcon*."""
_CAPITAL = re.compile(r"(?<=[a-z0-9])(?=[A-Z])")


def of_one(name: str) -> str:
    """Return what a list of classes says of one icon.

    >>> of_one("mdi mdi-home")
    'mdi-home'
    """
    return _CLASSES.sub(r"\2 ", name.strip()).strip(" -")


def uncoded(name: str) -> str:
    """Return a name without what code puts around it; any other text as it is.

    >>> [uncoded(name) for name in ("fas fa-house", "AiOutlineHome", "feather-home", "WiFi")]
    ['house', 'Outline Home', 'home', 'WiFi']
    """
    name = _SET.sub("", of_one(name))
    bare = _COMPONENT.sub("", name)
    return name if bare == name else _CAPITAL.sub(" ", bare)


def names_set(name: str) -> bool:
    """Whether a name says of which set it is, as *mdi-home* does."""
    return _SET.search(of_one(name)) is not None
