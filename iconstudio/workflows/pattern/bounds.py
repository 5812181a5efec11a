"""What can be asked for of a pattern."""

from iconstudio.algorithms.patterns.exemplar import MOST_LAYERS

SMALLEST, LARGEST = 64, 10_000
"""Width and height, in units."""
SMALLER, LARGER = 0.25, 4.0
"""What elements are scaled by, and how dense they lie."""
LARGEST_SEED = 2**53
"""More would not be the same number everywhere in JSON."""
MOST_COLOURS = MOST_LAYERS + 1
"""Of an image, with its ground."""
SMALLEST_MOTIF = 4.0
"""Side of a motif, in units."""
MOST_MOTIFS = 200
"""On the canvas of an exemplar."""
SEEDS = 6
"""How many seeds there are to choose from, side by side."""
