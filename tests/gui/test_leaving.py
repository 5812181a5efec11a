"""The program ends well, whatever is on the clipboard."""

import subprocess
import sys

COPY = """
from PySide6.QtCore import QMimeData
from iconstudio.gui.app import application
app = application()
data = QMimeData()
data.setText("icon")
data.setData("image/svg+xml", b"<svg/>")
app.clipboard().setMimeData(data)
app.processEvents()
from PySide6.QtCore import QTimer
QTimer.singleShot(0, app.quit)
code = app.exec()
assert app.clipboard().text() == "icon"
raise SystemExit(code)
"""


def test_what_was_copied_does_not_crash_the_end():
    ended = subprocess.run([sys.executable, "-c", COPY], capture_output=True, check=False)
    assert ended.returncode == 0, ended
