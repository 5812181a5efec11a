"""What a file is that holds no SVG: said in a sentence, with what to do about it."""

import json
import re
from html import unescape

_SAVE = "Save or export the drawing as SVG."
_BINARY = (
    (rb"%PDF-|.{1,512}%PDF-1\.", f"It is a PDF, or a file of Illustrator. {_SAVE}"),
    (rb"\s*%!PS|\xc5\xd0\xd3\xc6", f"It is PostScript (EPS, or a file of Illustrator). {_SAVE}"),
    (
        rb"\x89PNG|\xff\xd8\xff|RIFF....WEBP|GIF8[79]a|BM......\0\0|II[*+]\0|MM\0[*+]|8BPS"
        rb"|....ftyp(?:avi|hei|hev|mif1)|\0\0\x01\0",
        "It is no SVG drawing but a picture made of pixels. Open it as a file with a name that "
        "ends as those of pictures do (.png, say): the drawing on it becomes an icon.",
    ),
    (rb"fig-kiwi|fig-jam", "It is a file of Figma. In Figma, export the drawing as SVG."),
    (rb"RIFF....CDR|WL\x09\0", f"It is a file of CorelDRAW. {_SAVE}"),
    (rb"\x00\xffKA", f"It is a file of Affinity. {_SAVE}"),
    (rb"gimp xcf", f"It is a file of GIMP. {_SAVE}"),
    (rb"wOF[F2]|OTTO|\0\x01\0\0\0|true\0", "It is a font. Choose a file of one drawing."),
    (rb"7z\xbc\xaf|Rar!|BZh|\xfd7zXZ", "It is an archive. Unpack it, and choose a file in it."),
)  # fmt: skip
_ZIPPED = (
    (b"canvas.fig", "It is a file of Figma. In Figma, export the drawing as SVG."),
    (b"pages/", f"It is a file of Sketch. {_SAVE}"),
    (b"maindoc.xml", f"It is a file of Krita. {_SAVE}"),
    (b"content.xml", f"It is a document of LibreOffice. {_SAVE}"),
    (b"word/", f"It is a document of Word. {_SAVE}"),
    (b"ppt/", f"It is a document of PowerPoint. {_SAVE}"),
    (b"animations/", "It is an animation for Lottie. Export a picture of it as SVG."),
)
_HEAD = 4096
_OF_WEB = re.compile(
    r"^\s*(?:import\b.*[\"']|export\b|const\b|module\.exports|[\"']use \w+[\"'])"
    r"|\brequire\(|=>|\bfunction\b|\bcreateElement\(|\b_?jsxs?\(",
    re.MULTILINE,
)
"""JavaScript and TypeScript."""
_LFS = "version https://git-lfs"
_PAGE = re.compile(r"\s*(?:<!--.*?-->\s*)*(?:<!DOCTYPE\s+html|<html[\s>])", re.I | re.S)
_TITLE = re.compile(r"<(title|h1)[^>]*>(.*?)</\1>", re.I | re.S)
_COMPOSE = re.compile(r"\bImageVector\b|\bmaterialPath\b|\bandroidx\.compose\b")
_STYLES = re.compile(r"(?:\s|/\*.*?\*/)*(?:@[a-z-]+\b|[.#:*]?[\w.#:> -]+\{[^{}<]*:[^{}<]*\})", re.S)
_CODE = re.compile(
    r"^\s*(?:import\b|export\b|const\b|let\b|var\b|function\b|module\.exports|[\"']use \w+[\"']"
    r"|package\s+[\w.]+;?\s*$|(?:public|private|internal|abstract|final)\s"
    r"|(?:data )?(?:class|struct|object)\s+\w+"
    r"|using\s+[\w.]+;|#include\b|def\s+\w+\(|from\s+\S+\s+import\b|va[lr]\s+\w+|fun\s+\w)"
    r"|\b(?:React\.createElement|createElement|_?jsxs?)\(",
    re.MULTILINE,
)


def binary(data: bytes) -> str | None:
    """Return what bytes are that are no text, as a sentence; None if that is not known."""
    head = data[:_HEAD]
    if head.startswith(b"PK\x03\x04"):
        found = (said for name, said in _ZIPPED if name in data)
        return next(found, "It is an archive (ZIP). Unpack it, and choose a drawing in it.")
    return next((said for start, said in _BINARY if re.match(start, head, re.DOTALL)), None)


def text(content: str) -> str | None:
    """Return what a text is that holds no SVG, as a sentence; None if that is not known."""
    start = content.lstrip()
    if start.startswith(_LFS):
        return (
            "It stands for a file that was not downloaded (a pointer of Git LFS). "
            "Run “git lfs pull”, and open it again."
        )
    if _PAGE.match(content):
        title = _TITLE.search(content)
        named = " ".join(unescape(title[2]).split())[:60] if title else ""
        called = f" (“{named}”)" if named else ""
        return f"It is a web page{called}, not a drawing. Download the drawing itself."
    if start.startswith(("{", "[")):
        return _json(start)
    if start.startswith("<mxfile") or "<mxGraphModel" in start[:_HEAD]:
        return f"It is a file of draw.io. {_SAVE}"
    if _COMPOSE.search(content):
        return (
            "It is the code of an app for Android (Compose) whose drawing cannot be read. "
            "Save the SVG, or the drawing in XML (VectorDrawable), that it was made of."
        )
    if _STYLES.match(start):
        return f"It is a style sheet (CSS) without a drawing. {_SAVE}"
    if _CODE.search(content):
        of_web = " (React, say)" if _OF_WEB.search(content) else ""
        return (
            f"It is the code of a program{of_web} whose drawing cannot be read. "
            "Save the SVG itself instead."
        )
    if not start.startswith("<"):
        return f"It is a text, not a drawing. {_SAVE}"
    return None


def _json(content: str) -> str:
    try:
        found = json.loads(content)
    except (ValueError, RecursionError):
        found = None
    if isinstance(found, dict) and {"v", "layers", "fr"} <= found.keys():
        return "It is an animation for Lottie (JSON). Export a picture of it as SVG."
    if isinstance(found, dict) and found.get("type") == "excalidraw":
        return f"It is a file of Excalidraw. {_SAVE}"
    return f"It holds data (JSON), not an SVG drawing. {_SAVE}"
