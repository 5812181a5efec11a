"""Which elements selectors match, within a bound of work: the adapter of cssselect2.

Selectors look for what is around an element in every way there is: eight that may stand anywhere
above one another look more often than any machine can.
"""

import xml.etree.ElementTree as ET
from collections import Counter
from collections.abc import Iterator
from typing import Any

import cssselect2

from iconstudio.model import IconstudioError

MAX_MATCHES = 300_000
"""How often rules may apply to elements."""
MAX_TESTS = 1_000_000
"""How often selectors may be tried, and look around: about a second."""

SelectorError: type[Exception] = cssselect2.SelectorError
"""Raised of a selector that is not understood."""


def compiled(selectors: str) -> list[Any]:
    """Return selectors for a ``Matcher``; each knows its ``pseudo_element``."""
    found: list[Any] = cssselect2.compile_selector_list(selectors)
    return found


class Matcher(cssselect2.Matcher):  # type: ignore[misc]
    """Knows selectors, each with a payload (``add_selector``)."""

    def __init__(self, root: ET.Element) -> None:
        super().__init__()
        self._root = root
        self._left = MAX_TESTS
        self._expected = 0
        self._trials = _trials(root)

    def add_selector(self, selector: Any, payload: Any) -> None:
        """Add a selector, with what is known of elements that it matches.

        Raises
        ------
        IconstudioError
            If so many cannot be tried.
        """
        self._expected += self._trials[_last_name(selector)]
        if self._expected > MAX_TESTS:
            raise _too_often()
        super().add_selector(selector, payload)

    def matches(self) -> Iterator[tuple[ET.Element, list[Any]]]:
        """Yield each element with the payloads of what matches it, the most specific last.

        Raises
        ------
        IconstudioError
            If that takes too much work, or too many match.
        """
        matched = 0
        for element in _Element.watched(self._root, self).iter_subtree():
            found = self.match(element) if self.order else []
            matched += len(found)
            if matched > MAX_MATCHES:
                raise _too_often()
            own = [payload for *_, pseudo, payload in found if pseudo is None]
            yield element.etree_element, own

    def spend(self, tests: int) -> None:
        """Count work."""
        self._left -= tests
        if self._left < 0:
            raise _too_often()

    def add_relevant_selectors(self, element: Any, selectors: Any, relevant_selectors: Any) -> None:
        """Try selectors on an element."""
        self.spend(len(selectors))
        super().add_relevant_selectors(element, selectors, relevant_selectors)


class _Element(cssselect2.ElementWrapper):  # type: ignore[misc]
    """An element that counts how often selectors look around from it."""

    @classmethod
    def watched(cls, root: ET.Element, matcher: Matcher) -> "_Element":
        """Return a root, all of whose elements count what they cost."""
        found: _Element = cls.from_xml_root(root)
        found.matcher = matcher
        return found

    def __init__(self, element: ET.Element, parent: Any = None, *args: Any, **options: Any) -> None:
        super().__init__(element, parent, *args, **options)
        self.matcher: Matcher | None = None if parent is None else parent.matcher
        self._seen(1)

    def _seen(self, elements: int) -> None:
        if self.matcher is not None:
            self.matcher.spend(elements)

    @property
    def ancestors(self) -> Any:
        """All elements around it."""
        found = super().ancestors
        self._seen(len(found))
        return found

    @property
    def previous_siblings(self) -> Any:
        """All elements before it in the same one."""
        found = super().previous_siblings
        self._seen(len(found))
        return found


def _last_name(selector: Any) -> str:
    """Return what of an element says whether a selector is tried on it."""
    if selector.id is not None:
        return f"#{selector.id}"
    if selector.class_name is not None:
        return f".{selector.class_name}"
    return selector.lower_local_name or "*"


def _trials(root: ET.Element) -> Counter[str]:
    """Return how many elements a selector is tried on, by its last name."""
    found: Counter[str] = Counter()
    for element in root.iter():
        found.update(("*", element.tag.lower(), f"#{element.get('id')}"))
        found.update(f".{name}" for name in element.get("class", "").split())
    return found


def _too_often() -> IconstudioError:
    return IconstudioError(
        "Its style rules apply too often, or look too far. Save it with presentation attributes."
    )
