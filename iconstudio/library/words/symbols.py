"""What emoji and other symbols are called: by Unicode's names for readers (CLDR), or plainly.

Variants are one: with and without colour, of every skin; a flag has the name of its country.
"""

import re
import unicodedata
from collections import Counter
from functools import cache

from iconstudio.library.words.usage import EVERYDAY

_SKINS = dict.fromkeys(range(0x1F3FB, 0x1F400))
_KEYCAP = "\u20e3"
_JOINER = "\u200d"
_ARROW = re.compile(r"^(left|right|up|down)wards arrow$")


def has_symbols(text: str) -> bool:
    """Whether a text holds an emoji or another symbol that has a name."""
    return any(
        character == _KEYCAP
        or unicodedata.category(character) in ("So", "Cn")
        or (unicodedata.category(character) == "Sm" and not character.isascii())
        for character in text
    )  # "Cn": an emoji that is younger than this Python


def is_flag(text: str) -> bool:
    """Whether a text is the flag of a country or of a part of one, which tags name."""
    is_part = text[:1] == "\U0001f3f4" and "\U000e0020" <= text[1:2] <= "\U000e007f"
    return is_part or "\U0001f1e6" <= text[:1] <= "\U0001f1ff"


def is_joined(text: str) -> bool:
    """Whether a text holds emoji that several are joined to: a woman and a fire engine."""
    return _JOINER in text


def spoken(text: str) -> str:
    """Return a text with names, between spaces, for its symbols."""
    if not has_symbols(text):
        return text
    import emoji

    named = emoji.replace_emoji(text.translate(_SKINS), lambda _, data: f" {_words(data['en'])} ")
    return "".join(map(_spoken, named))


def called(name: str) -> str:
    """Return the emoji of a name in plain words; empty if there is none, or it is a country's."""
    import emoji

    code = f":{name.replace(' ', '_')}:"
    symbol = emoji.emojize(code)
    return "" if symbol == code else symbol


def other_names(text: str) -> list[str]:
    """Return by what else the one emoji that a text consists of is known."""
    if not has_symbols(text):
        return []
    import emoji

    one = text.translate(_SKINS).strip()
    aliases = emoji.EMOJI_DATA.get(one, {}).get("alias", ())
    return [name for name in map(_words, aliases) if re.fullmatch("[a-z ]{3,}", name)]


def english(word: str) -> list[str]:
    """Return in English what has an emoji that is called ``word`` in another language.

    With accents or without. Or that several emoji are kinds of, in languages that write words
    without spaces: of a guide dog and a service dog, whose names end in it, a dog.
    """
    word = _bare(word)
    if meant := EVERYDAY.get(word):
        return list(meant)
    called = _translations()
    if (found := called.get(word, [])) or not word or word.isascii():
        return found
    heads = Counter(
        head
        for name, meanings in called.items()
        if name.endswith(word) and not name[-len(word) - 1].isspace()
        for head in {meaning.split()[-1] for meaning in meanings}
    )
    ((head, count),) = heads.most_common(1) or [("", 0)]
    return [head] if count > 1 and 2 * count > heads.total() else []


@cache
def _translations() -> dict[str, list[str]]:
    """Return the names of emoji in other languages, each with its English ones."""
    import emoji

    others = [language for language in emoji.LANGUAGES if language != "en"]
    emoji.config.load_language(others)
    found: dict[str, list[str]] = {}
    for data in emoji.EMOJI_DATA.values():
        meant = _words(data["en"])
        for language in others:
            names = found.setdefault(_bare(_words(data.get(language, ""))), [])
            if meant not in names:
                names.append(meant)
    return found


def _bare(word: str) -> str:
    """Return a word in lower case without accents, as it may be typed."""
    decomposed = unicodedata.normalize("NFKD", word.casefold())
    return unicodedata.normalize("NFC", "".join(filter(_is_no_accent, decomposed)))


def _is_no_accent(character: str) -> bool:
    # Those of other scripts, as of Hindi and Japanese, make letters.
    return not "\u0300" <= character <= "\u036f"


def _words(code: str) -> str:
    """Return the words of an emoji's name: of ``:flag_for_Germany:``, ``:keycap_1:``."""
    words = code.strip(":").replace("_", " ").lower()
    return words.removeprefix("keycap ").removeprefix("flag for ")


def _spoken(character: str) -> str:
    """Return the name of a symbol that is no emoji between spaces; a letter as it is."""
    if not has_symbols(character):
        return character
    name = _ARROW.sub(r"arrow \1", unicodedata.name(character, "").lower())
    return " " if name.startswith("regional indicator") else f" {name} "
