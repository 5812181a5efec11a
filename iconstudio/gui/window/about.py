"""Who made this, and under which licences."""

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QMessageBox, QWidget

from iconstudio import __version__

ABOUT = """<h3>Iconstudio {version}</h3>
<p>Makes new icons out of parts of real ones, after the paper <i>Data-Driven Iconification</i>;
draws their lines by example, after <i>Curve Analogies</i>; and makes patterns of them, after
<i>Example-Based Art Pattern Synthesis Using Level Sets</i>.</p>
<p>Free software under the GNU General Public License, version 3 or later. Every icon it
makes carries the credits of its sources: their authors and licences are in the saved SVG.</p>
<p>Made with Qt, NumPy, SciPy, scikit-image, PyMaxflow, Numba and resvg.
The icons come from the open sets of Iconify; the file CREDITS beside the
collection names them all.</p>
"""


def show_about(parent: QWidget) -> None:
    """Show the box without blocking the window."""
    box = QMessageBox(parent)
    box.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
    box.setWindowTitle("About Iconstudio")
    box.setTextFormat(Qt.TextFormat.RichText)
    box.setText(ABOUT.format(version=__version__))
    box.open()
