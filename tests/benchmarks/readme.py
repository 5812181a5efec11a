"""Puts tables between their markers in the README of this folder."""

import re
from pathlib import Path

README = Path(__file__).parent / "README.md"


def put(name: str, text: str, readme: Path = README) -> None:
    """Replace what stands between ``<!-- name -->`` and the next ``<!-- end -->``.

    Raises
    ------
    ValueError
        If the markers are not there exactly once.
    """
    pattern = re.compile(rf"(<!-- {re.escape(name)} -->\n).*?(<!-- end -->)", re.DOTALL)
    written, count = pattern.subn(
        lambda found: f"{found[1]}\n{text}\n\n{found[2]}", readme.read_text("utf-8")
    )
    if count != 1:
        raise ValueError(f"{readme} has {count} places for “{name}”.")
    readme.write_text(written, "utf-8")
