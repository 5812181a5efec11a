"""A workflow in under 60 lines: icons are mirrored. Nothing else in the program knows of it."""

from collections.abc import Generator
from dataclasses import dataclass, replace

from iconstudio.inputs.formats import Many, Reference
from iconstudio.model import Icon, Pictogram, Transform
from iconstudio.workflows.events import Event, Progress, Result
from iconstudio.workflows.workflow import File, Find, Refer, Resources, Workflow


@dataclass(frozen=True, slots=True)
class Mirroring:
    """Icons to mirror, left to right."""

    icons: tuple[Pictogram, ...] = ()


class MirrorFile(File[Mirroring], frozen=True):
    """A MIRROR.json: ``{"mirrored": ["set:name", ...]}``."""

    mirrored: Many[Reference]

    @classmethod
    def of(cls, work: Mirroring, refer: Refer) -> "MirrorFile":
        """Return the file of some work."""
        return cls(tuple(map(refer, work.icons)))

    def resolved(self, find: Find) -> Mirroring:
        """Return the work, its icons found by ``find``."""
        return Mirroring(tuple(map(find, self.mirrored)))


def run(resources: Resources, work: Mirroring) -> Generator[Event]:
    """Mirror icons, one after the other."""
    for number, icon in enumerate(work.icons, start=1):
        drawing = resources.drawing(resources.exemplar(icon))
        yield Progress("mirror", number / len(work.icons), "Mirroring")
        path = drawing.path.transformed(LEFT_TO_RIGHT)
        yield Result(Icon(path, f"mirrored {icon.credit.title}", icon.origins))


LEFT_TO_RIGHT = Transform(-1, 0, 0, 1, 256, 0)

MIRROR = Workflow(
    name="mirror",
    title="Mirror",
    noun="mirror image",
    help="Mirror icons, left to right.",
    invitation="Mirror it",
    work=Mirroring,
    file=MirrorFile,
    run=run,
    icons=lambda work: work.icons,
    with_icons=lambda work, icons: replace(work, icons=icons),
)
