"""The page of patterns in a project file."""

from collections.abc import Generator
from dataclasses import replace
from typing import Annotated

from msgspec import Meta
from msgspec.structs import replace as with_fields

from iconstudio.inputs.formats import Many, Record
from iconstudio.model import IconstudioError, Pictogram
from iconstudio.workflows.pages import PageFormat, Parts, StoredOrigin, StoredParts, StoredPhoto
from iconstudio.workflows.pattern.bounds import MOST_MOTIFS
from iconstudio.workflows.pattern.file import PatternFile
from iconstudio.workflows.pattern.page import PatternPage


class StoredPattern(Record, frozen=True):
    """The work as its files say it, the image beside it, and the motifs that are chosen."""

    work: PatternFile
    photo: StoredPhoto | None = None
    credits: Many[StoredOrigin] = ()
    """Those of the image."""
    chosen: Many[Annotated[int, Meta(ge=0, le=MOST_MOTIFS)]] = ()


class PatternPages(PageFormat[PatternPage, StoredPattern]):
    """Exemplar and pattern, whether there is one or not."""

    stored = StoredPattern

    def write(self, page: PatternPage, parts: Parts) -> StoredPattern:
        """Return a page as it is stored."""
        work = with_fields(PatternFile.of(page.work, parts.icon), image=None)
        image = page.work.image
        photo = None if image is None else parts.photo(image.photo)
        origins = [one for icon in (image.credits if image else ()) for one in icon.origins]
        credits = tuple(map(StoredOrigin.of, origins))
        return StoredPattern(work, photo, credits, tuple(sorted(page.chosen)))

    def read(self, stored: StoredPattern, parts: StoredParts) -> Generator[None, None, PatternPage]:
        """Return the page that was written; without its image, if only that is no good."""
        photo = None
        if stored.photo is not None:
            try:
                photo = yield from parts.photo(stored.photo)
            except IconstudioError as error:
                parts.complaints.append(f"The pattern was opened without its image: {error}")
        credits = tuple(Pictogram(one.id, "", one.credit) for one in stored.credits)
        work = stored.work.with_image(parts.icon, photo, credits)
        chosen = frozenset(number for number in stored.chosen if number < len(work.motifs))
        return PatternPage(work, chosen)

    def alike(self, page: PatternPage, other: PatternPage) -> bool:
        """Whether the work is the same; to choose motifs is no edit."""
        return page == replace(other, chosen=page.chosen)
