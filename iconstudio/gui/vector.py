"""SVG path data as a Qt path, so that icons are drawn crisp at any size and pixel density."""

import re

from PySide6.QtCore import Qt
from PySide6.QtGui import QPainterPath

_TOKEN = re.compile(r"[MLHVCZ]|[-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?")
_COUNT = {"M": 2, "L": 2, "H": 1, "V": 1, "C": 6}


def painter_path(d: str) -> QPainterPath:
    """Return the outline of path data made of the absolute commands M, L, H, V, C and Z.

    That is what ``Drawing.path`` consists of; the path is filled with the nonzero rule.
    """
    path = QPainterPath()
    path.setFillRule(Qt.FillRule.WindingFill)
    draw = {
        "M": path.moveTo,
        "L": path.lineTo,
        "H": lambda x: path.lineTo(x, path.currentPosition().y()),
        "V": lambda y: path.lineTo(path.currentPosition().x(), y),
        "C": path.cubicTo,
    }
    tokens = _TOKEN.findall(d)
    command, at = "", 0
    while at < len(tokens):
        if tokens[at].isalpha():
            command = tokens[at]
            at += 1
            if command == "Z":
                path.closeSubpath()
                continue
        count = _COUNT[command]
        draw[command](*map(float, tokens[at : at + count]))
        at += count
        command = "L" if command == "M" else command
    return path
