"""What guides a montage: the distance from each icon's scribbles."""

from iconstudio.algorithms.iconification.guidance import (
    MONTAGE_REACH,
    scribble,
    truncated_distance,
)
from iconstudio.model import Icon
from iconstudio.workflows.inner_pictures import InnerPicture
from iconstudio.workflows.montage.page import MontagePage


def inner_pictures(page: MontagePage, icon: Icon | None = None) -> tuple[InnerPicture, ...]:
    """Return D_M of each layer that is scribbled over."""
    return tuple(
        InnerPicture(
            f"D_M of {layer.title}, from its scribbles",
            truncated_distance(scribble(layer.strokes), MONTAGE_REACH),
        )
        for layer in page.layers
        if layer.strokes
    )
