"""What the pointer does on the canvas of a montage."""

from iconstudio.gui.canvas.tools.base import Tool
from iconstudio.gui.workspaces.montage.scene import MontageScene
from iconstudio.gui.workspaces.montage.tools.arrange import ArrangeTool
from iconstudio.gui.workspaces.montage.tools.scribble import Brush, ScribbleTool
from iconstudio.workflows.montage.page import MontageDocument


def montage_tools(document: MontageDocument, scene: MontageScene, brush: Brush) -> dict[str, Tool]:
    """Return the tools of a montage by the names of the actions that take them."""
    return {
        "arrange": ArrangeTool(document, scene),
        "brush": ScribbleTool(document, scene, brush, rubs=False),
        "eraser": ScribbleTool(document, scene, brush, rubs=True),
    }
