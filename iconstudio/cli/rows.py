"""Rows of a table on standard output, their cells parted by tabs."""

import json
import re

_BREAKS = re.compile('^"|[\0-\x1f\x7f-\x9f\u2028\u2029\ud800-\udfff]')


def row(*cells: str) -> str:
    """Return a row of one line; a cell that would break it is quoted, as in JSON."""
    return "\t".join(json.dumps(cell) if _BREAKS.search(cell) else cell for cell in cells)
