"""A workspace with one result, which follows the page."""

from dataclasses import replace

from iconstudio.gui.workspaces.actions import COMMON
from iconstudio.gui.workspaces.base import Workspace


class FollowingWorkspace(Workspace):
    """A result that is of something else than the page turns pale, and cannot be taken along."""

    keeps_last = True
    sends_to_itself = False

    @property
    def stale(self) -> bool:
        """Whether the result in sight is of something else than the page."""
        raise NotImplementedError

    @property
    def takeable(self) -> bool:
        """Whether the result in sight is finished, and that of the page."""
        return self.picture is not None and not self.picture.preview and not self.stale

    def show_age(self) -> None:
        """Say whether the result is of the page as it is now, and may be taken along."""
        self.detail.large.paling.set_stale(self.stale)
        self.detail.set_takeable(self.takeable)
        self.actions_by_name.refresh()


TAKING_OUT = tuple(
    replace(one, enabled=lambda place: place.takeable)
    for one in COMMON
    if one.name in ("svg", "png", "copy")
)
"""The ways to take the result along."""
