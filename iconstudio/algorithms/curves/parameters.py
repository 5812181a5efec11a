"""The parameters of section 3.6, and those that the method leaves open, in one table."""

from dataclasses import dataclass


@dataclass(frozen=True, slots=True)
class Parameters:
    """How curves are learned and made. Lengths are in units of a 256 canvas.

    | parameter | paper | here | why |
    |---|---|---|---|
    | D at the finest level | 0.5 | 0.6 to 2 | as coarse as shows the example as it is |
    | D of a coarser level | 1.2 D | 1.2 D | |
    | samples | 81 or 101, D/4 apart | 13, D apart | the others weigh next to nothing |
    | w_delta | 100 or 100,000 | 3 D² | scales with the texture |
    | w of the coarser B' | 2 | 1 | |
    | w_offset | 3.8; 19 for synthesis | 3.8 | 19 lets lengths explode |
    | w_B | 0 or 2 | 0 or 2; 20 for the rotation alone if 0 | long waves keep their height |
    | kappa | 1/2, as 1 + kappa/D | 8 at all levels | one that fades loses loops |
    | epsilon | not given | 0.03 | |
    | passes a level | not given | 1 | curves begin sharp, see `Search.sharpened` |
    """

    spacing: float = 2.0
    """D at the finest level."""
    coarser: float = 1.2
    """How many times as large D is at the next coarser level."""
    levels: int = 4
    """How many coarser levels there are."""
    blur: float = 0.8
    """Standard deviation of a level's blur, over sqrt(D_l² - D_L²)."""
    sweep: float = 1.5
    """Standard deviation, over D, of the blur after which a plain line has no texture."""
    reach: int = 6
    """Samples of a neighbourhood to each side."""
    sigma: float = 2.0
    """Standard deviation of their weights, in samples."""
    tangents: float = 3.0
    """w_delta over D²."""
    coarse: float = 1.0
    """Weight of the next coarser level's neighbourhoods."""
    offset: float = 3.8
    """w_offset."""
    alignment: float = 20.0
    """Weight of A and B for the rotation if their shape does not count."""
    shape: float = 2.0
    """w_B if it does."""
    incoherent: float = 9.0
    """How many times as much a candidate costs that does not go on where the one before was."""
    late: float = 2.0
    """By how much more a jump costs the later it comes in an open example, which goes on from there
    to its end: without it, ends would be seen more often than beginnings."""
    epsilon: float = 0.03
    """Candidates within 1 + epsilon of the best are as good."""
    passes: int = 1
    """Refinements at each level."""
    longest: float = 4.0
    """A result so many times as long as it should be is no style any more: the line stays plain."""
