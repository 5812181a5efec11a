"""What is said of an icon beside its picture: how good it is, what it is made of, whom to thank."""

import math

from iconstudio.grammar import counted
from iconstudio.model import Credit, Icon, Patterned, Placement, Remix


def told_of(icon: Icon, preview: bool = False) -> str:
    """Return a line about an icon, which may be but a ``preview``."""
    match icon:
        case Remix():
            return " · ".join(_about(icon, preview))
        case Patterned():
            tiles = "tiles without a seam" if icon.tile else "does not tile"
            return "; ".join((f"{icon.width} × {icon.height}, {tiles}", *_thanks_together(icon)))
    return "; ".join(thanks(one.credit) for one in icon.credits)


def thanks(credit: Credit) -> str:
    """Return whom to thank for an icon."""
    return f"{credit.title}, by {credit.author}, {credit.license}"


def described(placement: Placement) -> str:
    """Return where a source lies."""
    mirrored = ", mirrored" if placement.flip else ""
    return f"Scaled {placement.scale:g}×, shifted by {placement.dx}, {placement.dy}{mirrored}"


def _about(icon: Remix, preview: bool) -> list[str]:
    from iconstudio.output.colours import SIGNIFICANT

    composite = icon.composite
    owners = composite.owners(SIGNIFICANT)
    icons = len({composite.sources[label].exemplar.id for label in owners})
    made = f"{counted(len(owners), 'part')} of {counted(icons, 'icon')}"
    # Of hybrids and montages, λ is always the same.
    weight = [] if composite.iou is None else [f"λ {composite.lambda_s:.2f}"]
    held = ["symmetric"] if composite.symmetry is not None else []
    held += ["for variety"] if composite.without else []
    return [*weight, "preview" if preview else made, *held, *_merits(icon)]


def _merits(icon: Remix) -> list[str]:
    """Return how well an icon does what was wanted."""
    inside = [f"inside by {icon.score.inside:.0%}"] if icon.score.inside < 1 else []
    if icon.unchanged is not None:
        return [
            f"fits the change by {icon.score.likeness:.0%}",
            *inside,
            f"unchanged elsewhere {_floor(100 * icon.unchanged)}%",
        ]
    if icon.draw >= 0:
        return [f"rank score {icon.score.total:.2f}"]
    iou = icon.composite.iou
    return [] if iou is None else [f"fits the sketch by {iou:.0%}", *inside]


def _thanks_together(icon: Icon) -> list[str]:
    """Return whom to thank, those of one author and licence in one."""
    titles: dict[tuple[str, str], list[str]] = {}
    for one in icon.credits:
        titles.setdefault((one.credit.author, one.credit.license), []).append(one.credit.title)
    return [f"{', '.join(some)}, by {who}, {how}" for (who, how), some in titles.items()]


def _floor(percent: float) -> str:
    """Return one decimal, never rounded up to 100."""
    return f"{math.floor(10 * percent) / 10:g}"
