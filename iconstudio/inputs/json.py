"""JSON files, read and written as their formats declare: every mistake names file, place and cure.

Python's own parser comes first: it knows all Unicode encodings, and lets us refuse fields that are
there twice. What it returns is then made what the format declares, by msgspec, which also writes.
"""

import json
import os
import re
from collections import Counter
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any, TypeVar

import msgspec

from iconstudio.files import is_address, read_bytes, write_bytes
from iconstudio.inputs.formats import ODD, Record, Reference, Text
from iconstudio.inputs.mistakes import mistake, refused
from iconstudio.model import IconstudioError

MOST_BYTES = 32_000_000
"""Size of a file."""
_OF_COLLECTION = re.compile(r"[^:/\\]+:[^:/\\]+(?<!\.svg)", re.IGNORECASE)
"""``set:name``; anything else is the path of a file."""
_NOTES = ("comment", "credit")
"""Fields that say something to people only."""

R = TypeVar("R", bound=Record)


def read(path: Path, kind: type[R]) -> R:
    """Read a file as its format declares.

    Raises
    ------
    IconstudioError
        If it cannot be read, or says anything else.
    """
    return converted(load(path), kind, path)


def load(path: Path) -> object:
    """Return the JSON in a file of the user's work.

    Raises
    ------
    IconstudioError
        If it cannot be read, or is none.
    """
    try:
        text = read_bytes(path, MOST_BYTES)
    except IconstudioError as error:
        raise IconstudioError(f"“{path}” cannot be read. {error}") from None
    return parsed(text, path)


def parsed(text: bytes, path: Path) -> object:
    """Return the JSON in some bytes, without notes; ``path`` names them in messages.

    Raises
    ------
    IconstudioError
        If it is none.
    """
    try:
        return json.loads(text, parse_int=_whole, object_pairs_hook=_object)
    except UnicodeDecodeError:
        reason = "it is no text in UTF-8, UTF-16 or UTF-32"
    except (RecursionError, MemoryError):
        reason = "it is nested too deeply, or too large"
    except json.JSONDecodeError as error:
        reason = _breach(error)
    except ValueError as error:
        reason = str(error)
    raise IconstudioError(
        f"“{path.name}” is not valid JSON: {reason}. Save it again, or mend it in an editor."
    )


def _breach(error: json.JSONDecodeError) -> str:
    """Say where text stops being JSON, without the parser's own terms."""
    if not error.doc.strip():
        return "it is empty"
    if error.pos >= len(error.doc.rstrip()):
        return "it ends too early"
    return f"it cannot be understood from line {error.lineno}, character {error.colno} on"


def converted(data: object, kind: type[R], path: Path, place: str = "") -> R:
    """Return JSON as its format declares it; ``path``, and ``place`` in it, name it in messages.

    Raises
    ------
    IconstudioError
        If it says anything else.
    """
    try:
        record = msgspec.convert(data, kind, dec_hook=_decoding(path))
        wrong = refused(record)
    except msgspec.ValidationError as error:
        wrong = mistake(error, data, kind)
    except UnicodeEncodeError:  # at half of a surrogate pair msgspec stops without a place
        return converted(_whole_characters(data), kind, path, place)
    except RecursionError:
        wrong = ": It is nested too deeply. Save it again, or mend it in an editor."
    if wrong:
        raise IconstudioError(f"In “{path.name}”{place}{wrong}")
    return record


def unknown_fields(record: Record, data: Any) -> Iterator[str]:
    """Yield the names of those fields in JSON that the ``record`` made of it does not declare."""
    declared = zip(record.__struct_encode_fields__, record.__struct_fields__, strict=True)
    names = dict(declared)
    for key, value in data.items():
        if key not in names:
            yield key
            continue
        read = getattr(record, names[key])
        for one, part in (
            zip(read, value, strict=True) if isinstance(read, tuple) else ((read, value),)
        ):
            if not isinstance(one, Record):
                break
            yield from unknown_fields(one, part)


def encoded(record: Record, path: Path | None = None) -> bytes:
    """Return JSON in UTF-8; into the file ``path``, references of files near it are short."""
    encoder = msgspec.json.Encoder(enc_hook=_encoding(path), order="deterministic")
    try:
        return encoder.encode(record)
    except UnicodeEncodeError:  # half of a surrogate pair, as a name of a file may have
        data = msgspec.to_builtins(record, enc_hook=_encoding(path), order="deterministic")
        return json.dumps(data, ensure_ascii=False).encode(errors="replace")


def write(path: Path, record: Record) -> None:
    """Write a file as its format declares.

    Raises
    ------
    IconstudioError
        If it cannot be written.
    """
    write_bytes(path, msgspec.json.format(encoded(record, path), indent=2) + b"\n")


def _whole(digits: str) -> int | float:
    """Read a whole number; Python refuses those of thousands of digits."""
    return int(digits) if len(digits) < 400 else float(digits)


def _object(pairs: list[tuple[str, Any]]) -> dict[str, Any]:
    """Make an object of its fields, each of which may be there once; null is as good as none."""
    if len({key for key, _ in pairs}) < len(pairs):
        ((twice, _),) = Counter(key for key, _ in pairs).most_common(1)
        raise ValueError(f"{json.dumps(twice[:60])} is there twice")
    return {key: value for key, value in pairs if not (_is_note(key) or _is_nothing(key, value))}


def _whole_characters(data: Any) -> Any:
    """Return JSON with a zero for each character that is none; no text may hold one either."""
    match data:
        case str():
            return ODD.sub("\0", data)
        case list():
            return list(map(_whole_characters, data))
        case dict():
            return {ODD.sub("\0", key): _whole_characters(one) for key, one in data.items()}
    return data


def _is_note(key: str) -> bool:
    return key in _NOTES or key[:1] in ("_", "$")


def _is_nothing(key: str, value: object) -> bool:
    return value is None or (key, value) == ("symmetry", "none")  # as on the command line


def _decoding(path: Path) -> Callable[[type, Any], Any]:
    """Return what reads references and paths from the folder of a file."""

    def decode(kind: type, value: object) -> object:
        try:
            text = msgspec.convert(value, Text)
        except msgspec.ValidationError:
            raise ValueError from None  # of which msgspec tells the place
        if kind is Path:
            return Path(os.path.realpath(path.parent / text))
        text = text.strip()
        if kind is not Reference or not text:
            raise ValueError
        kept = _OF_COLLECTION.fullmatch(text) or is_address(text)
        return Reference(text if kept else os.path.realpath(path.parent / text))

    return decode


def _encoding(path: Path | None) -> Callable[[Any], Any]:
    """Return what writes references and paths, near files by short ones, and NumPy's floats."""

    def encode(value: object) -> str | float:
        if isinstance(value, float):
            return float(value)
        if not isinstance(value, Path | Reference):
            raise NotImplementedError(type(value))
        file = Path(value)
        folder = None if path is None else path.resolve().parent
        if folder is None or not (file.is_absolute() and file.is_relative_to(folder)):
            return str(value)
        return file.relative_to(folder).as_posix()

    return encode
