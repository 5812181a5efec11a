"""Examples to learn from: pairs of a plain curve A and a styled one A' (section 3.3).

The two have the same parameters: a point of A corresponds to the point of A' at its parameter.
"""

from dataclasses import dataclass

import numpy as np

from iconstudio.algorithms.curves.curve import Curve, Numbers, Points


@dataclass(frozen=True, eq=False)
class Pair:
    """A and A', with parameters from 0 to 1."""

    plain: Curve
    styled: Curve

    @classmethod
    def of(cls, plain: Points | None, styled: Points, closed: bool = False) -> "Pair":
        """Return a pair that corresponds point by point if both have as many, else by arc length.

        Without a plain curve it is the straight line that runs along the styled one; of a closed
        one, the ellipse.
        """
        if plain is not None and len(plain) == len(styled):
            return cls(*_side_by_side(plain, styled, closed))
        after = Curve.of(styled, closed)
        before = _sweep(after) if plain is None else Curve.of(plain, closed)
        return cls(before.unit, after.unit)

    def scaled(self, size: float, strength: float = 1.0) -> "Pair":
        """Return the pair in another size, A' nearer to A or farther from it."""
        plain, styled = self.plain, self.styled
        near = plain.at(styled.parameters)
        points = near + strength * (styled.points - near)
        return Pair(
            Curve(size * plain.points, plain.parameters, 1.0, plain.closed),
            Curve(size * points, styled.parameters, 1.0, styled.closed),
        )


def _side_by_side(plain: Points, styled: Points, closed: bool) -> tuple[Curve, Curve]:
    """Return two curves of as many points with the same parameters, from 0 to 1.

    They are the means of the relative arc lengths. Where both stand still, one point is left.
    """
    both = np.stack([plain, styled]).astype(complex)
    moves = np.append(True, (both[:, 1:] != both[:, :-1]).any(axis=0))
    both = both[:, moves]
    again = np.append(both, both[:, :1], axis=1) if closed else both
    steps = abs(np.diff(again, axis=1))
    steps /= steps.sum(axis=1, keepdims=True)
    along = np.append(0.0, np.cumsum(steps.mean(axis=0)))
    along /= along[-1]
    before, after = (_moving(one, along[: len(one)], closed) for one in both)
    return before, after


def _moving(points: Points, parameters: Numbers, closed: bool) -> Curve:
    """Return a curve that does not stand still at its ends, so that it goes on beyond them."""
    kept = np.ones(len(points), bool)
    kept[1 : np.flatnonzero(points != points[0])[0]] = False
    last = np.flatnonzero(points != points[0 if closed else -1])[-1]
    kept[last + 1 : None if closed else -1] = False
    return Curve(points[kept], parameters[kept], 1.0, closed)


def _sweep(styled: Curve) -> Curve:
    even = np.linspace(0, 1, 257)[:-1] if styled.closed else np.linspace(0, 1, 257)
    points = styled.at_arc(even * styled.length)
    if styled.closed:
        turn = np.fft.fft(points) / len(points)
        kept = np.zeros_like(turn)
        kept[[0, 1, -1]] = turn[[0, 1, -1]]
        return Curve.of(np.fft.ifft(kept * len(points)), True)
    design = np.stack([np.ones_like(even), even], axis=1)
    start, way = np.linalg.lstsq(design, points, rcond=None)[0]
    return Curve.of(start + way * np.array([0.0, 1.0]))
