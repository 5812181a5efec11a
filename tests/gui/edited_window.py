"""A window that edits itself, to be killed: prints the number of each edit once it is made.

An edit is one point more on the canvas of the sketch, or a mark on the icon to be edited, in turn.
"""

import os
import sys

os.environ.setdefault("QT_QPA_PLATFORM", "offscreen")

from fake_session import FakeSession, exemplar
from PySide6.QtCore import QTimer

from iconstudio.gui.app import application
from iconstudio.gui.window.main_window import MainWindow
from iconstudio.workflows.areas import Area, Kind
from iconstudio.workflows.editing.page import EditPage

PAUSE = 90
"""Milliseconds between two edits: more of them than a hand makes."""


def main() -> None:
    app = application()
    window = MainWindow(FakeSession())
    window.show()
    window.workspace_of("Edit").document.change("icon", EditPage(exemplar(1)))
    made = 0

    def edit() -> None:
        nonlocal made
        made += 1
        name = "Sketch" if made % 2 else "Edit"
        document = window.workspace_of(name).document
        page = document.page
        if name == "Sketch":
            after = page.with_outline((*page.vertices, (float(made), made % 7.0)), False)
        else:
            corners = (float(made), 0.0), (9.0, 9.0), (0.0, 9.0)
            after = page.with_areas((*page.areas, Area(Kind.ADD, corners)))
        document.change("edit", after)
        print(made, flush=True)

    timer = QTimer(interval=PAUSE)
    timer.timeout.connect(edit)
    timer.start()
    print("ready", flush=True)
    sys.exit(app.exec())


if __name__ == "__main__":
    main()
