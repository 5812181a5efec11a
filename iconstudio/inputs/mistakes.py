"""What is wrong in a JSON file, and where: sentences made of what its format declares there."""

import json
import re
import sys
from collections.abc import Sequence
from difflib import get_close_matches
from typing import Any

from msgspec import ValidationError
from msgspec.inspect import (
    BoolType,
    CollectionType,
    CustomType,
    EnumType,
    Field,
    FloatType,
    IntType,
    Metadata,
    NoneType,
    StrType,
    StructType,
    TupleType,
    Type,
    UnionType,
    type_info,
)

from iconstudio.inputs.formats import LARGEST, LONGEST_TEXT, ODD, Record, Reference
from iconstudio.model import IconstudioError

_FIELD = re.compile(r"\.(\w+)((?:\[[\d.]+\])*)")
"""A step of a path of msgspec's, ``$.layers[0].strokes[1].width``."""
_OBJECT = 'n object such as {"key": "value"}'
_ICON = '"set:name", or the path of an SVG or a scan'


def refused(record: Record) -> str | None:
    """Return what the ``check`` of a record, or of one in it, refuses; its place comes first."""
    for key in record.__struct_fields__:
        value = getattr(record, key)
        for number, one in enumerate(value if isinstance(value, tuple) else (value,), start=1):
            if not isinstance(one, Record):
                break
            if found := refused(one):
                return f", {_named(key, number if isinstance(value, tuple) else None)}{found}"
    try:
        record.check()
    except IconstudioError as error:
        return f": {error}"
    return None


def mistake(error: ValidationError, data: Any, kind: type[Record]) -> str:
    """Return what is wrong in ``data``, and where; ``error`` is what converting it raised."""
    record, place = type_info(kind), ""
    steps = iter(_FIELD.findall(str(error).rpartition(" - at `$")[2]))
    while isinstance(record, StructType) and not (wrong := _in_object(record, data)):
        key, indices = next(steps)
        field = next(one for one in record.fields if one.encode_name == key)
        numbers = [int(index) + 1 for index in re.findall(r"\d+", indices)]
        record, value = _plain(field.type), data[key]
        if numbers and isinstance(record, CollectionType):
            record = _plain(record.item_type)
        if isinstance(record, StructType):
            place += f", {_named(key, *numbers)}"
            data = value[numbers[0] - 1] if numbers else value
        else:
            wrong = _in_value(field.type, value, numbers, json.dumps(key), key)
    return f"{place}: {wrong}"


def _in_object(kind: StructType, data: Any) -> str:
    """Say what is wrong with an object itself: that it is none, has too many fields or too few."""
    if not isinstance(data, dict):
        return f"A{_OBJECT} is needed."
    known = [field.encode_name for field in kind.fields]
    unknown = [key for key in data if key not in known] if kind.forbid_unknown_fields else []
    missing = [one for one in kind.fields if one.required and one.encode_name not in data]
    if unknown:
        lists = [one.encode_name for one in missing if isinstance(_plain(one.type), CollectionType)]
        some = lists if isinstance(data[unknown[0]], list) else []
        near = _meant(unknown[0].lower(), known, some)
        return f"{json.dumps(unknown[0][:60], ensure_ascii=False)} is not known here. " + (
            f"Write {json.dumps(near)} if you mean that."
            if near
            else f"There are {', '.join(map(json.dumps, known))}. Remove it, or mend its name."
        )
    if missing:
        return f"{json.dumps(missing[0].encode_name)} is missing: {_needed(missing[0])}."
    return ""


def likely(word: str, known: Sequence[str]) -> str:
    """Return which of some words in lower case one stands for; empty if it is like none."""
    return next(iter(get_close_matches(word.strip().casefold(), known, n=1)), "")


def _meant(name: str, known: Sequence[str], missing: Sequence[str]) -> str:
    """Return which field an unknown name stands for, if any: of unlike ones the missing one."""
    very = get_close_matches(name, known, n=1, cutoff=0.85)
    near = very or list(missing) or get_close_matches(name, known, n=1)
    return near[0] if near else ""


def _needed(field: Field) -> str:
    reference = isinstance(field.type, CustomType) and field.type.cls is Reference
    return _ICON if reference else _wanted(field.type, field.encode_name)


def _in_value(kind: Type, value: Any, numbers: list[int], name: str, key: str) -> str:
    """Say what is wrong with a value, or with what ``numbers`` lead to in its lists."""
    inner, the = _plain(kind), name if name == json.dumps(key) else f"The {name}"
    if not isinstance(inner, CollectionType):
        texts, leaf = [value], inner
    elif not isinstance(value, list):
        return f"{the} must be {_wanted(kind, key)}."
    else:
        if inner.max_length is not None and len(value) > inner.max_length:
            entries = "entries" if the == name else "points"
            return f"{the} has {len(value):,} {entries}; at most {inner.max_length:,} are read."
        texts, leaf = value, _plain(inner.item_type)
    if numbers and isinstance(inner, CollectionType) and _is_point(inner.item_type):
        longest = leaf.max_length if isinstance(leaf, CollectionType) else None
        found = _in_point(value[numbers[0] - 1], longest or 2, _range(leaf))
        return f"Point {numbers[0]} of {name} {found}"
    if numbers and isinstance(leaf, CollectionType) and isinstance(inner, CollectionType):
        first, *rest = numbers
        title = f"{_title(inner.item_type)} {first} of {name}"
        return _in_value(inner.item_type, value[first - 1], rest, title, key)
    if isinstance(leaf, StrType | CustomType) and all(isinstance(one, str) for one in texts):
        wrong = filter(None, map(_in_text, texts))
        return f"{name} {next(wrong, f'is empty: write {_ICON}.')}"
    return f"{the} must be {_wanted(kind, key)}." + _in_words(leaf, value)


def _in_words(kind: Type, value: Any) -> str:
    """Return which of a few words was meant by a text, as a sentence after a blank, if any."""
    words = [str(one.value) for one in kind.cls] if isinstance(kind, EnumType) else []
    near = likely(value, words) if isinstance(value, str) else ""
    return f' Write "{near}" if you mean that.' if near else ""


def _in_text(text: str) -> str:
    if len(text) > LONGEST_TEXT:
        return f"has {len(text):,} characters; at most {LONGEST_TEXT:,} are read."
    if ODD.search(text):
        return "holds characters that are none."
    return ""


def _is_point(kind: Type) -> bool:
    """Whether a type is that of points: pairs, or lists that may have more numbers."""
    return isinstance(_plain(kind), TupleType) or _title(kind) == "point"


def _range(point: Type) -> tuple[float, float]:
    """Return the least and the largest number of points of a type."""
    item = point.item_types[0] if isinstance(point, TupleType) else None
    if isinstance(point, CollectionType):
        item = point.item_type
    number = None if item is None else _plain(item)
    return getattr(number, "ge", None) or 0.0, getattr(number, "le", None) or LARGEST


def _in_point(point: Any, longest: int, within: tuple[float, float]) -> str:
    numbers = isinstance(point, list) and all(map(_is_number, point))
    if not numbers or not 2 <= len(point) <= longest:
        more = " or [12, 34.5, 6]" if longest > 2 else ""
        return f"is not {'a pair of ' if longest == 2 else ''}numbers such as [12, 34.5]{more}."
    if not all(abs(one) <= sys.float_info.max for one in point):
        return "is not a number, or too large. Remove it."
    at = ", ".join(f"{one:g}" for one in point)
    least, most = within
    if most < LARGEST:
        return f"is out of all scale: [{at}]. Numbers go from {least:g} to {most:g} here."
    return f"is out of all scale: [{at}]. Use a unit in which no number is larger than {most:g}."


def _is_number(value: object) -> bool:
    return isinstance(value, int | float) and not isinstance(value, bool)


def _wanted(kind: Type, key: str) -> str:
    """Describe what a value must be."""
    match _plain(kind):
        case BoolType():
            return "true or false"
        case IntType(ge=least, le=most):
            return f"a whole number{_bounds(least, None, most)}"
        case FloatType(ge=least, gt=below, le=most):
            return f"a number{_bounds(least, below, most)}"
        case EnumType(cls=some):
            null = "null or " if isinstance(kind, UnionType) else ""
            return f"{null}one of {', '.join(str(one.value) for one in some)}"
        case StrType() | CustomType():
            return "a text"
        case CollectionType(item_type=item):
            return f"a list of {_wanted_in_list(item, key)}"
    return f"a{_OBJECT}"


def _bounds(least: float | None, below: float | None, most: float | None) -> str:
    """Say from where to where a number may be: whole ones exactly, others in few digits."""
    low, lower, high = (
        f"{one:.15g}" if isinstance(one, float) else one for one in (least, below, most)
    )
    if below is not None:
        return f" above {lower}" + ("" if most is None else f" and up to {high}")
    if least is not None:
        return f" of {low} or more" if most is None else f" from {low} to {high}"
    return "" if most is None else f" up to {high}"


def _wanted_in_list(item: Type, key: str) -> str:
    match _plain(item):
        case StrType() | CustomType():
            return "texts"
        case _ if _is_point(item):
            return "[x, y] points"
        case IntType() | FloatType():
            return "numbers"
        case CollectionType():
            title = _title(item)
            return f"{title}s" if title != "list" else "lists of [x, y] points"
    return key if key.endswith("s") else "objects"


def _named(key: str, number: int | None = None) -> str:
    """Return what to call a field, or one entry of its list: ``layers`` hold ``layer 1``."""
    return key if number is None else f"{key.removesuffix('s')} {number}"


def _title(kind: Type) -> str:
    """Return what the format calls the lists in a list."""
    schema = kind.extra_json_schema if isinstance(kind, Metadata) else None
    return str((schema or {}).get("title", "list"))


def _plain(kind: Type) -> Type:
    """Return a type without what is said about it, and without null."""
    if isinstance(kind, Metadata):
        return _plain(kind.type)
    if isinstance(kind, UnionType):
        return _plain(next(one for one in kind.types if not isinstance(one, NoneType)))
    return kind
