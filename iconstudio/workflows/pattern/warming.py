"""Worker processes get ready to make patterns, before the first one is asked for."""

from iconstudio.model import Contour, Credit, Motif, Path, Pictogram


def warm_up() -> None:
    """Load what makes patterns, and compile it if it never was, on a pattern of two squares."""
    from iconstudio.workflows.pattern.drawing import draw
    from iconstudio.workflows.pattern.layout import Arrangement

    icon = Pictogram("", "", Credit("", "", "", "", ""))
    square = Path((Contour((40, 40), (((216, 40),), ((216, 216),), ((40, 216),))),))
    motifs = Motif(icon, 64, 64, 96), Motif(icon, 192, 192, 96)
    arrangement = Arrangement(motifs, (square, square), 256.0, "#ffffff")
    for coarse in (True, False):
        draw(arrangement, None, (128, 128), True, 0, coarse)
