"""What is said if nothing answers a keyword."""

from iconstudio.library import messages
from iconstudio.library.lookup import Lookup
from iconstudio.library.words import query, symbols
from iconstudio.library.words.decency import is_insult
from iconstudio.library.words.naming import is_negated
from iconstudio.library.words.vocabulary import PREPOSITIONS


def told(keyword: str, lookup: Lookup, near: tuple[str, ...] = ()) -> str:
    """Return that no icon answers a keyword, and what does; ``near`` are identifiers like it."""
    name = query.name(keyword)
    only = messages.only(lookup.answer(keyword))
    none = f"No icon is called {messages.said(keyword)}. {only}".rstrip()
    words = query.plain(keyword)
    if is_insult(words) or PREPOSITIONS.issuperset(words.split()):
        return f"{none} {messages.THING}"
    if symbols.is_flag(keyword.strip()):
        return f"{none} {messages.FLAGS} {messages.THING}"
    if near:
        return f"{none}{messages.hint(near)}"
    if beside := lookup.beside(name):
        return f"{none} Of its kind there are: {', '.join(beside)}."
    # An identifier names an icon, whatever its words say.
    negated = is_negated(tuple(words.split())) and name == keyword.strip()
    if negated:
        none = f"{none} {messages.FORBIDDING}"
    named_by_symbol = symbols.has_symbols(keyword) and not negated
    parts = () if named_by_symbol else lookup.parts(name)
    if parts:
        none = f"{none} {messages.corrected(lookup.read_as(name))}".rstrip()
        return f"{none} Alone, these words find icons: {', '.join(parts)}."
    return f"{none}{messages.hint(_meant(keyword, lookup))} {messages.ENGLISH}"


def _meant(keyword: str, lookup: Lookup) -> tuple[str, ...]:
    """Return what else a keyword may stand for, in English.

    Of what is only spelt like it, that is likely which is in what it means elsewhere as well.
    """
    english = tuple(filter(lookup.scores, symbols.english(keyword.strip())))
    near = lookup.suggestions(query.name(keyword)) if query.is_latin(keyword) else ()
    if not english:
        return near
    known = " ".join(english).split()
    return tuple(dict.fromkeys((*(one for one in near if one in known), *english)))
