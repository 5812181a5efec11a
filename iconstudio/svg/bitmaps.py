"""Bitmaps that drawings hold: no shapes, but a picture to be traced if there is nothing else."""

import base64
import binascii
import re
from collections.abc import Iterable
from urllib.parse import unquote_to_bytes

_ADDRESS = re.compile(r"\s*data:image/[\w.+-]+(?:;[\w=.-]+)*?(;base64)?,", re.IGNORECASE)


def only_bitmap(addresses: Iterable[str]) -> bytes | None:
    """Return the file of the one bitmap that is shown; None if there is none, or several.

    ``addresses`` are those of all images; one that is shown several times is one.
    """
    addresses = {one.strip() for one in addresses}
    if len(addresses) != 1:
        return None
    (address,) = addresses
    match = _ADDRESS.match(address)
    if match is None:
        return None
    data = unquote_to_bytes(address[match.end() :])
    if match[1] is None:
        return data
    try:
        return base64.b64decode(b"".join(data.split()))
    except binascii.Error:
        return None
