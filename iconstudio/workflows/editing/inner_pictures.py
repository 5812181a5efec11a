"""What guides an edit: the distance from the change, and what the icon gives way to."""

import numpy as np

from iconstudio.model import Icon
from iconstudio.workflows.editing.page import EditPage
from iconstudio.workflows.editing.placing import place_edit
from iconstudio.workflows.inner_pictures import InnerPicture


def inner_pictures(page: EditPage, icon: Icon | None = None) -> tuple[InnerPicture, ...]:
    """Return the outline that is wanted, D_E, and where E_0 costs, of a page with finished areas.

    Raises
    ------
    IconstudioError
        If the edit is no good.
    """
    edit = page.edit()
    if edit is None or page.icon is None or not (edit.remove or edit.add):
        return ()
    change = place_edit(edit, page.icon)
    return (
        InnerPicture("The outline that is wanted", change.silhouette.astype(np.float32)),
        InnerPicture("D_E, the distance from the change", change.mask),
        InnerPicture("Where the icon gives way", 1 - change.kept),
    )
