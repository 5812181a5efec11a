"""What guides a hybrid: the seed position of each icon, and the distance from it."""

from iconstudio.algorithms.iconification.guidance import seed_cost
from iconstudio.model import Icon, Remix
from iconstudio.workflows.hybrids.page import HybridsPage
from iconstudio.workflows.inner_pictures import InnerPicture


def inner_pictures(page: HybridsPage, icon: Icon | None = None) -> tuple[InnerPicture, ...]:
    """Return D_H of each icon with its seed positions, of the hybrid that is picked."""
    if not isinstance(icon, Remix) or not icon.seeds:
        return ()
    names = (source.exemplar.name for source in icon.composite.sources)
    return tuple(
        InnerPicture(f"D_H of {name}, from its seed", distances, points)
        for name, distances, points in zip(names, seed_cost(icon.seeds), icon.seeds, strict=True)
    )
