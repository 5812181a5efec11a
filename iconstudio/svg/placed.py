"""Exemplars at their placement: their pictures and their outlines."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from iconstudio.model import Frame, Placement
from iconstudio.model.path import Path
from iconstudio.svg.resvg import Window, render_coverage


@dataclass(frozen=True)
class Renderer:
    """Draws documents, which are hostile: use it in a worker process. All are equal."""

    def __call__(
        self,
        svg: str,
        frame: Frame,
        placement: Placement,
        size: int,
        window: Window | None = None,
    ) -> NDArray[np.uint8]:
        """Draw the exemplar of ``frame`` at ``placement``: the canvas, (size, size), or part."""
        if not placement.flip:
            return render_coverage(svg, placement.frame(frame), size, window)
        left, top, right, bottom = window or (0, 0, size, size)
        mirrored = size - right, top, size - left, bottom
        coverage = render_coverage(svg, placement.frame(frame), size, mirrored)
        return np.ascontiguousarray(coverage[:, ::-1])

    def outline(self, svg: str, frame: Frame) -> Path:
        """Return the outline of an exemplar that is not moved; empty if its shapes do not tell."""
        # What reads shapes loads libraries, which the window's own process can do without.
        from iconstudio.svg.outline import outline_of

        return outline_of(svg, frame)


render_placed = Renderer()
