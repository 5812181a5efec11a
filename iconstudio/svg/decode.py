"""The characters of an SVG file: unpacked and decoded."""

import base64
import binascii
import codecs
import re
import zlib
from urllib.parse import unquote_to_bytes

from iconstudio.model import IconstudioError
from iconstudio.svg import signatures

MAX_BYTES = 32_000_000
"""Of a file, unpacked; most of a large one is private data of the program that wrote it."""

_MOST_PACKED = 3
"""How many times a file may be compressed: servers compress what is compressed already."""
_GZIP = b"\x1f\x8b"
_BYTE_ORDER_MARKS = (
    (codecs.BOM_UTF8, "utf-8"),
    (codecs.BOM_UTF32_LE, "utf-32"),
    (codecs.BOM_UTF32_BE, "utf-32"),
    (codecs.BOM_UTF16_LE, "utf-16"),
    (codecs.BOM_UTF16_BE, "utf-16"),
)
_FIRST_CHARACTERS = (
    (b"<\0\0\0", "utf-32-le"),
    (b"\0\0\0<", "utf-32-be"),
    (b"<\0", "utf-16-le"),
    (b"\0<", "utf-16-be"),
)
"""How a document begins in encodings that need no byte order mark."""
_DECLARED = re.compile(rb"""<\?xml[^>]{0,200}?encoding\s*=\s*["']([A-Za-z][\w.:-]{0,40})["']""")
_NOT_OF_FILES = ("idna", "punycode", "raw_unicode_escape", "undefined", "unicode_escape", "utf-7")
"""Python's encodings of text that no file is in."""
_DATA_ADDRESS = re.compile(
    rb"\s*data:(?:image/svg(?:\+xml)?|(?:text|application)/xml)\b([^,]{0,99}),", re.IGNORECASE
)
_OF_ADDRESSES = bytes.maketrans(b"-_", b"+/")
"""The letters of base64 in addresses, and the usual ones."""
_ROOT = re.compile(r"<([\w.-]+:)?svg[\s>/]", re.IGNORECASE)


def decode(data: bytes) -> str:
    """Return the text of a file, without blanks around it.

    ``data`` may be compressed (SVGZ), in any encoding that it declares or that its first characters
    tell, or a ``data:`` address.

    Raises
    ------
    IconstudioError
        If it is no text, cannot be unpacked, or is too large.
    """
    data = _unaddressed(data)
    for _ in range(_MOST_PACKED):
        if data.startswith(_GZIP):
            data = _unpacked(data)
    if len(data) > MAX_BYTES:
        raise _too_large()
    if not data.strip():
        raise IconstudioError("The file is empty. Save the drawing again.")
    if not data.strip(b"\0 \t\r\n"):
        raise IconstudioError(
            "The file holds nothing but zeros: it is damaged. Save, copy or download it again."
        )
    what = signatures.binary(data)
    if what is not None:
        raise IconstudioError(what)
    return _text(data).strip(" \t\r\n\0\ufeff")


def _unaddressed(data: bytes) -> bytes:
    """Return what a ``data:`` address holds, as style sheets and pages have it."""
    match = _DATA_ADDRESS.match(data)
    if match is None:
        return data
    content = unquote_to_bytes(data[match.end() :].strip())
    if b"base64" not in match[1].lower():
        return content
    letters = b"".join(content.split()).rstrip(b"=").translate(_OF_ADDRESSES)
    try:
        return base64.b64decode(letters + b"=" * (-len(letters) % 4), validate=True)
    except binascii.Error:
        raise IconstudioError("The data: address is cut short. Copy it again, whole.") from None


def _unpacked(data: bytes) -> bytes:
    unpacker = zlib.decompressobj(wbits=31)
    try:
        text = unpacker.decompress(data, MAX_BYTES + 1)
    except zlib.error:
        raise IconstudioError("The compressed file (SVGZ) is damaged. Save it again.") from None
    if not unpacker.eof and len(text) <= MAX_BYTES:
        raise IconstudioError("The compressed file (SVGZ) is cut short. Save it again.")
    return text


def _text(data: bytes) -> str:
    encoding = _encoding(data)
    try:
        text = data.decode(encoding)
    except (UnicodeDecodeError, LookupError):
        if encoding == "utf-8" and b"\0" not in data and _ROOT.search(data.decode("latin-1")):
            return data.decode("cp1252", errors="replace")  # as browsers read what declares nothing
        raise IconstudioError(
            f"It is no SVG drawing, or not in its encoding, {encoding.upper()}. "
            "Choose another file, or save it again as SVG in UTF-8."
        ) from None
    return text.removeprefix("\ufeff")


def _encoding(data: bytes) -> str:
    """Return what the first bytes, or else the XML declaration, say of the encoding."""
    for mark, encoding in _BYTE_ORDER_MARKS:
        if data.startswith(mark):
            return encoding
    start = data.lstrip(b" \t\r\n")
    for first, encoding in _FIRST_CHARACTERS:
        if start.startswith(first):
            return encoding
    declared = _DECLARED.match(start)
    name = declared[1].decode().lower() if declared else "utf-8"
    if name in ("utf-16", "utf-32", "ucs-2", "ucs-4"):  # the declaration was read as ASCII
        return "utf-8"
    return name if _is_of_files(name) else "utf-8"


def _is_of_files(name: str) -> bool:
    try:
        b"<".decode(name)  # what encodes bytes as bytes, such as base64, is none either
        return codecs.lookup(name).name not in _NOT_OF_FILES
    except (LookupError, UnicodeDecodeError):
        return False


def _too_large() -> IconstudioError:
    return IconstudioError(f"It has more than {MAX_BYTES:,} bytes. Simplify the drawing.")
