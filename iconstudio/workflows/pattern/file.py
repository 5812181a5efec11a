"""PATTERN.json: an exemplar, of icons on a canvas or of an image, and the pattern to make of it."""

from collections.abc import Generator
from pathlib import Path
from typing import Annotated, Self

from msgspec import Meta

from iconstudio.inputs.formats import Many, Reference, StrictRecord, Text
from iconstudio.inputs.lines import line, rounded
from iconstudio.model import (
    CANVAS,
    Correction,
    IconstudioError,
    Motif,
    Patterning,
    Photo,
    Pictogram,
    Separation,
    Stroke,
)
from iconstudio.model.patterning import GROUND, INK
from iconstudio.svg.colours import colour
from iconstudio.workflows.events import Event
from iconstudio.workflows.pattern.bounds import (
    LARGER,
    LARGEST,
    LARGEST_SEED,
    MOST_COLOURS,
    MOST_MOTIFS,
    SMALLER,
    SMALLEST,
    SMALLEST_MOTIF,
)
from iconstudio.workflows.workflow import File, Find, Refer, Resources

NO_GROUND = "none"
"""What is written for a transparent ground."""

FAR = 4.0 * CANVAS
"""No coordinate of a motif is larger."""

_Place = Annotated[float, Meta(ge=-FAR, le=FAR)]
_Turn = Annotated[float, Meta(ge=-3600, le=3600)]
_Side = Annotated[int, Meta(ge=SMALLEST, le=LARGEST)]
_Scale = Annotated[float, Meta(ge=SMALLER, le=LARGER)]


class MotifFile(StrictRecord, frozen=True):
    """An icon on the exemplar's canvas: its middle, its side, and degrees clockwise."""

    icon: Reference
    x: _Place = CANVAS / 2
    y: _Place = CANVAS / 2
    size: Annotated[float, Meta(ge=SMALLEST_MOTIF, le=FAR)] = CANVAS / 4
    turn: _Turn = 0.0
    flip: bool = False
    colour: Text = INK

    @classmethod
    def of(cls, motif: Motif, refer: Refer) -> Self:
        """Return a motif as it is written."""
        x, y, size, turn = (round(one, 2) for one in (motif.x, motif.y, motif.size, motif.turn))
        return cls(refer(motif.icon), x, y, size, turn, motif.flip, motif.colour)

    def resolved(self, find: Find) -> Motif:
        """Return the motif, its icon found by ``find``."""
        at = self.x, self.y, self.size, self.turn, self.flip
        return Motif(find(self.icon), *at, _plain(self.colour))

    def check(self) -> None:
        """Refuse what is no colour."""
        _plain(self.colour)


class CorrectionFile(StrictRecord, frozen=True):
    """A stroke of the brush over an image, in its pixels, and the layer that it gives."""

    layer: Annotated[int, Meta(ge=0, le=MOST_COLOURS - 1)]
    width: Annotated[float, Meta(gt=0, le=10_000)]
    points: Annotated[tuple[tuple[float, float], ...], Meta(max_length=20_000)]

    @classmethod
    def of(cls, correction: Correction) -> Self:
        """Return a stroke as it is written."""
        return cls(correction.layer, correction.stroke.width, rounded(correction.stroke.points))

    @property
    def correction(self) -> Correction:
        """The value."""
        return Correction(self.layer, Stroke(self.width, line(self.points)))


class PatternFile(File[Patterning], frozen=True):
    """A PATTERN.json."""

    motifs: Annotated[tuple[MotifFile, ...], Meta(max_length=MOST_MOTIFS)] = ()
    image: Path | None = None
    colours: Annotated[int, Meta(ge=2, le=MOST_COLOURS)] | None = None
    corrections: Many[CorrectionFile] = ()
    ground: Text = GROUND
    width: _Side = 2 * CANVAS
    height: _Side = 2 * CANVAS
    tile: bool = True
    seed: Annotated[int, Meta(ge=0, le=LARGEST_SEED)] = 0
    scale: _Scale = 1.0
    turn: _Turn = 0.0
    density: _Scale = 1.0
    fill: Reference | None = None

    @classmethod
    def of(cls, work: Patterning, refer: Refer) -> Self:
        """Return the file of some work."""
        image = work.image
        return cls(
            motifs=tuple(MotifFile.of(one, refer) for one in work.motifs),
            image=Path(image.photo.path) if image and image.photo.path else None,
            colours=image.colours if image else None,
            corrections=tuple(map(CorrectionFile.of, image.corrections)) if image else (),
            ground=work.ground or NO_GROUND,
            width=work.width,
            height=work.height,
            tile=work.tile,
            seed=work.seed,
            scale=round(work.scale, 3),
            turn=round(work.turn, 2),
            density=round(work.density, 3),
            fill=None if work.fill is None else refer(work.fill),
        )

    def check(self) -> None:
        """Refuse two exemplars, and what is no colour."""
        if self.motifs and self.image:
            raise IconstudioError("An exemplar is an image, or icons: give one of the two.")
        ground_of(self.ground)

    def resolved(self, find: Find) -> Patterning:
        """Return the work without its image."""
        return self.with_image(find, None)

    def resolving(self, resources: Resources) -> Generator[Event, None, Patterning]:
        """Return the work, its image read."""
        if self.image is None:
            given = {"colours": self.colours is not None, "corrections": bool(self.corrections)}
            for key in (key for key, there in given.items() if there):
                raise IconstudioError(f'"{key}" goes with "image", and there is none. Remove it.')
            return self.resolved(resources.icon)
        image = yield from resources.artwork(self.image)
        return self.with_image(resources.icon, image.photo, image.credits)

    def with_image(
        self, find: Find, photo: Photo | None, credits: tuple[Pictogram, ...] = ()
    ) -> Patterning:
        """Return the work with its image, and those to thank for it."""
        corrections = tuple(one.correction for one in self.corrections)
        return Patterning(
            motifs=tuple(one.resolved(find) for one in self.motifs),
            image=None if photo is None else Separation(photo, self.colours, corrections, credits),
            ground=ground_of(self.ground),
            width=self.width,
            height=self.height,
            tile=self.tile,
            seed=self.seed,
            scale=self.scale,
            turn=self.turn,
            density=self.density,
            fill=None if self.fill is None else find(self.fill),
        )


def ground_of(text: str) -> str:
    """Return a ground as ``#rrggbb``, or empty for ``none``.

    Raises
    ------
    IconstudioError
        If it is neither.
    """
    return "" if text.strip().lower() == NO_GROUND else _plain(text)


def _plain(text: str) -> str:
    """Return a colour as ``#rrggbb``.

    Raises
    ------
    IconstudioError
        If it is none.
    """
    found = colour(text)
    if found is None or not found.startswith("#"):
        raise IconstudioError(f"“{text[:40]}” is no opaque colour. Write one as #rrggbb.")
    return found
