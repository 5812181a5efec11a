"""What guides the remixes of a sketch: its distances, its salience, and its regions."""

import numpy as np

from iconstudio.algorithms.iconification.energy import distance_field
from iconstudio.algorithms.iconification.saliency import saliency, salient_regions
from iconstudio.algorithms.raster import fill_polygon
from iconstudio.model import Icon
from iconstudio.workflows.inner_pictures import InnerPicture, scaled
from iconstudio.workflows.modelling.modelling import details_of
from iconstudio.workflows.modelling.page import SketchPage


def inner_pictures(page: SketchPage, icon: Icon | None = None) -> tuple[InnerPicture, ...]:
    """Return D_P, the saliency S, and the masks M of the regions, of a finished outline.

    Raises
    ------
    IconstudioError
        If the outline is no good.
    """
    if not page.closed:
        return ()
    fitted = page.sketch.fitted()
    filled = fill_polygon(fitted.polygon)
    salience = saliency([fitted.polygon], filled)
    regions = (*salient_regions(salience), *details_of(fitted))
    weights = np.max([region.mask for region in regions], axis=0)
    centres = tuple((float(x), float(y)) for x, y in (region.centre for region in regions))
    return (
        InnerPicture("D_P, the distance from the outline", scaled(distance_field(filled))),
        InnerPicture("S, how salient each place is", scaled(salience)),
        InnerPicture("M, the regions as they are weighted", scaled(weights), centres),
    )
