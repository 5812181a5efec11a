"""The list of workspaces, as they stand on the switch."""

from iconstudio.gui.workspaces.base import Workspace
from iconstudio.gui.workspaces.editing.workspace import EditWorkspace
from iconstudio.gui.workspaces.hybrids.workspace import HybridsWorkspace
from iconstudio.gui.workspaces.montage.workspace import MontageWorkspace
from iconstudio.gui.workspaces.sketching.workspace import SketchWorkspace

WORKSPACES: tuple[type[Workspace], ...] = (
    SketchWorkspace,
    EditWorkspace,
    HybridsWorkspace,
    MontageWorkspace,
)
