"""Lines of text that say who made an icon, below it: its credit, and no part of the drawing.

Sites write them into the files that they offer: “Created by Ada” and “from the Noun Project”, say.
"""

import re
import xml.etree.ElementTree as ET
from collections.abc import Collection

from iconstudio.svg.geometry import SHAPES

LEFT_OUT = "Its credit line was left out of the drawing: “{}”."

_SITE = r"(?:(?:the )?noun ?project|[\w.-]+\.(?:com|org|net|io|cc))"
_WORK = r"(?:icons?|vectors?|images?|graphics?|illustrations?|pictograms?|symbols?|svgs?|logos?)"
_MADE = r"(?:created|designed|made|drawn|illustrated)"
_CREATED = re.compile(
    rf"(?:{_WORK} )?created by:? (?P<any>.+)"
    rf"|(?:{_WORK} (?:{_MADE} )?|{_MADE} )by:? (?P<name>(?-i:[A-Z]).+)",
    re.IGNORECASE,
)
"""What names an author; but for “created by”, capitalised: “made by hand” may be a drawing's."""
_SOURCE = re.compile(
    rf"(?:{_WORK} |downloaded )?from:? (?:https?://)?(?:www\.)?{_SITE}\W*"
    r"|(?:licen[sc]ed under|(?:©|\(c\)|copyright)(?: ©| \(c\))?(?: \d{4}[\d, -]*)?(?: by)?) ?\w.+",
    re.IGNORECASE,
)
_FROM = re.compile(rf",? (?:from|via|on|at) (?:https?://)?(?:www\.)?{_SITE}.*", re.IGNORECASE)
_LONGEST = 200
"""Characters of a line of text that may be one."""


def leave_out(root: ET.Element, kept: set[ET.Element]) -> tuple[list[str], str]:
    """Take the lines of credit out of what is ``kept`` of a document, in place.

    They are kept where nothing else is drawn.

    Returns
    -------
    What to say of it, in sentences, and the author's name; empty if none is named.
    """
    texts = [one for one in root.iter("text") if one in kept]
    lines = {one: said for one in texts if _is_credit(said := _line(one))}
    if not lines or not _holds_more(kept, lines):
        return [], ""
    for text in lines:
        kept.difference_update(text.iter())
    found = (_CREATED.fullmatch(said) for said in lines.values())
    authors = (_FROM.sub("", match["any"] or match["name"]) for match in found if match)
    return [LEFT_OUT.format(" ".join(dict.fromkeys(lines.values())))], next(authors, "")


def _line(text: ET.Element) -> str:
    """Return all of a text on one line."""
    return " ".join("".join(text.itertext()).split())


def _is_credit(line: str) -> bool:
    return len(line) <= _LONGEST and bool(_CREATED.fullmatch(line) or _SOURCE.fullmatch(line))


def _holds_more(kept: set[ET.Element], lines: Collection[ET.Element]) -> bool:
    """Whether anything is drawn but some lines of text."""
    return any(
        one.tag in SHAPES or (one.tag == "text" and one not in lines and _line(one)) for one in kept
    )
