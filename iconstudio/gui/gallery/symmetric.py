"""The switch that says whether symmetric results stand in the places of others."""

from PySide6.QtWidgets import QPushButton

from iconstudio.gui.preferences import prefer, preferred

_NAME = "symmetric"
"""Under which it is remembered."""


class SymmetricButton(QPushButton):
    """On: symmetric results are shown where there are any. It is hidden until then."""

    def __init__(self) -> None:
        super().__init__("Symmetric")
        self.setCheckable(True)
        self.setChecked(preferred(_NAME, True))
        self.setToolTip(
            "The outline is nearly symmetric: show symmetric results where they look better"
        )
        self.toggled.connect(lambda on: prefer(_NAME, on))
        self.hide()
