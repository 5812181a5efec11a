"""How it is said that a thing is switched off, forbidden or missing, and how names of icons say it.

Of the words that say it, the collection has nearly none: such drawings are of no use as parts.
"""

from collections.abc import Iterator

Words = tuple[str, ...]


def _phrases(text: str) -> frozenset[Words]:
    return frozenset(tuple(one.split()) for one in text.split(","))


_BEFORE = _phrases(
    """
    no, non, not, do not, dont, without, mute, muted, slashed, disable, disabled, crossed out,
    turn off, turned off, switch off, switched off
    """
)
_BEHIND = _phrases(
    """
    off, slash, slashed, mute, muted, disabled, disallowed, unavailable, forbidden, prohibited,
    banned, crossed, crossed out, turned off, switched off, not available, not found, not allowed,
    not possible, not supported
    """
)
_LONGEST = 2
"""Words of the longest of them."""

_SIGNS = ("x", "x mark", "cross", "cancelled", "hide", "invisible", "silence", "quiet")
"""What names have beside a thing that is struck out."""
_MUTE = ("volume x", "speaker x", "speaker x mark", "volume zero", "sound quiet")
_NO_EYE = ("eye closed", "eye invisible", "eye hide", "eye x", "eye cross")
_OFFLINE = ("globe x", "cloud x", "cell signal x")
_BLOCKED = ("forbid", "do disturb on", "denied")
_NOT_FOUND = ("search x",)
_SWITCHED_OFF = {
    "access": _BLOCKED, "connection": (*_OFFLINE, "plug disconnected"), "entry": _BLOCKED,
    "eye": _NO_EYE, "internet": _OFFLINE, "network": _OFFLINE, "result": _NOT_FOUND,
    "results": _NOT_FOUND, "sound": _MUTE,
}  # fmt: skip
"""What things are drawn as if they are switched off, or not there."""
_FORBIDDEN_WORDS = (
    "ban", "banned", "forbidden", "notallowed", "prohibited", "unavailable", "notavailable",
)  # fmt: skip
_ALONE = {
    "mute": _MUTE, "muted": _MUTE, "unmute": ("volume",), "offline": _OFFLINE,
    "hidepassword": _NO_EYE, "showpassword": ("eye",), "hidden": _NO_EYE,
    "onoff": ("power",), "offon": ("power",), "poweroff": ("power",), "turnoff": ("power",),
    "switchoff": ("power",), "logoff": ("log out",), "signoff": ("sign out",),
    "nosmoking": ("smoke free",), "nonsmoking": ("smoke free",), "notfound": _NOT_FOUND,
    "donotdisturb": ("do disturb on",), "accessdenied": _BLOCKED, "donotenter": _BLOCKED,
    "signup": ("user plus", "user add", "account plus", "person add"),
    **dict.fromkeys(_FORBIDDEN_WORDS, _BLOCKED),
}  # fmt: skip
"""What words, joined, mean if no others stand beside them."""


def without(words: Words) -> Words:
    """Return words without those that say no, unless there are no others.

    >>> without(("no", "wifi")), without(("wifi", "not", "available")), without(("mute",))
    (('wifi',), ('wifi',), ('mute',))
    """
    for count in range(min(_LONGEST, len(words) - 1), 0, -1):
        if words[:count] in _BEFORE:
            return without(words[count:])
        if words[-count:] in _BEHIND:
            return without(words[:-count])
    return words


def drawn_as(words: Words) -> Iterator[Words]:
    """Yield what names of icons say for words that say no, with a thing or alone."""
    if meant := _ALONE.get("".join(words), ()):
        yield from (tuple(one.split()) for one in meant)
    elif (thing := without(words)) != words:
        name = "".join(thing)
        yield (f"{name}free",)
        yield from (tuple(one.split()) for one in _SWITCHED_OFF.get(name, ()))
        yield from ((*thing, *sign.split()) for sign in _SIGNS)
