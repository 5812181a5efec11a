"""The page of patterns in a project file."""

from collections.abc import Generator
from dataclasses import asdict, replace
from typing import Annotated, Self

from msgspec import Meta
from msgspec.structs import replace as with_fields

from iconstudio.inputs.formats import Many, Record, Text, plain_text
from iconstudio.model import Credit, IconstudioError, Pictogram
from iconstudio.workflows.pages import PageFormat, Parts, StoredParts, StoredPhoto
from iconstudio.workflows.pattern.bounds import MOST_MOTIFS
from iconstudio.workflows.pattern.file import PatternFile
from iconstudio.workflows.pattern.page import PatternPage


class StoredCredit(Record, frozen=True):
    """What an image was made of, and whom to thank for that."""

    id: Text = ""
    title: Text = ""
    author: Text = ""
    license: Text = ""
    license_url: Text = ""
    url: Text = ""

    @classmethod
    def of(cls, pictogram: Pictogram) -> Self:
        """Describe an icon."""
        texts = {"id": pictogram.id} | asdict(pictogram.credit)
        return cls(**{key: plain_text(text) for key, text in texts.items()})

    @property
    def pictogram(self) -> Pictogram:
        """The icon, without its drawing."""
        thanks = Credit(self.title, self.author, self.license, self.license_url, self.url)
        return Pictogram(self.id, "", thanks)


class StoredPattern(Record, frozen=True):
    """The work as its files say it, the image beside it, and the motifs that are chosen."""

    work: PatternFile
    photo: StoredPhoto | None = None
    credits: Many[StoredCredit] = ()
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
        credits = tuple(map(StoredCredit.of, origins))
        return StoredPattern(work, photo, credits, tuple(sorted(page.chosen)))

    def read(self, stored: StoredPattern, parts: StoredParts) -> Generator[None, None, PatternPage]:
        """Return the page that was written; without its image, if only that is no good."""
        photo = None
        if stored.photo is not None:
            try:
                photo = yield from parts.photo(stored.photo)
            except IconstudioError as error:
                parts.complaints.append(f"The pattern was opened without its image: {error}")
        credits = tuple(one.pictogram for one in stored.credits)
        work = stored.work.with_image(parts.icon, photo, credits)
        chosen = frozenset(number for number in stored.chosen if number < len(work.motifs))
        return PatternPage(work, chosen)

    def alike(self, page: PatternPage, other: PatternPage) -> bool:
        """Whether the work is the same; to choose motifs is no edit."""
        return page == replace(other, chosen=page.chosen)
