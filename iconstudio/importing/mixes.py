"""Gathers the icons to mix: sent, dropped, picked by the program, or named in a file."""

from collections.abc import Callable, Generator, Sequence
from contextlib import closing
from dataclasses import replace
from pathlib import Path

from iconstudio.grammar import counted
from iconstudio.importing.importer import IconImporter, Opened
from iconstudio.inputs.together import ReadTogether, quoted_list
from iconstudio.model import Exemplar
from iconstudio.workflows.events import Event
from iconstudio.workflows.hybrids import page as edits
from iconstudio.workflows.hybrids.file import read_hybrids
from iconstudio.workflows.hybrids.hybrids import MOST
from iconstudio.workflows.hybrids.page import HybridsDocument, HybridsPage, PickRequest, page_of


class MixImporter(IconImporter[HybridsPage]):
    """Adds icons, or puts others in place of all that are there; favourites stay."""

    question = "Open a mix"
    kinds = "Mixes"
    most = MOST
    limit = f"at most {MOST} icons can be mixed"

    def opening(
        self, path: Path, then: Callable[[], object] = lambda: None
    ) -> Generator[Event | Opened]:
        """Yield the mix that a file describes; ``then`` is called once it is on the page."""
        page = yield from page_of(read_hybrids(path), path.stem, self.session)

        def put(document: HybridsDocument) -> None:
            document.change("open mix", replace(page, favourites=document.page.favourites))
            then()

        yield Opened(f"Opened “{page.title}”.", put)

    def picking(self, ask: PickRequest) -> Generator[Event | Opened]:
        """Yield icons that the program picks."""
        session = self.session
        with closing(session.choose(ask.keyword, ask.count, ask.symmetry, ask.group)) as choosing:
            icons = yield from choosing
        picked = tuple(map(session.exemplar, icons))
        yield Opened(
            f"Picked {counted(len(picked), 'icon')} for “{ask.keyword}”.",
            lambda document: self._complaints(edits.set_picked(document, picked, ask)),
        )

    def put(self, gathered: ReadTogether) -> tuple[str, ...]:
        """Add icons, as many as there is room for."""
        before, icons = self.document.page.ids, {one.id: one for one in gathered.found}
        left = edits.add_icons(self.document, gathered.found)
        there = [one for one in icons.values() if one.id in before]
        added = [one for one in icons.values() if one.id in self.document.page.ids - before]
        said = f"Added {quoted_list(_titles(added))}." if added else "", _there(_titles(there))
        return " ".join(filter(None, said)), *self._complaints(left)

    def _complaints(self, left: Sequence[Exemplar]) -> tuple[str, ...]:
        return (self.no_room((), _titles(left)),) if left else ()


def _titles(icons: Sequence[Exemplar]) -> list[str]:
    return [one.pictogram.credit.title or one.id for one in icons]


def _there(names: Sequence[str]) -> str:
    if not names:
        return ""
    return f"{quoted_list(names)} {'is' if len(names) == 1 else 'are'} among the icons already."
