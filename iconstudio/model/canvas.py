"""The canvas that sketches and exemplars share (section 3.2: m = 256)."""

CANVAS = 256
"""Side m of the square canvas, in pixels. y points down; (0, 0) is the top left corner."""

MARGIN = 16
"""Free border in canvas pixels: a drawing's tight bounding box is scaled so that its longer
side measures ``CANVAS - 2 * MARGIN``, and is centred."""
