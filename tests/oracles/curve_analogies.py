"""REFINEANALOGY as a plain loop over points and candidates: *Curve Analogies*, section 3.3."""

import numpy as np

from iconstudio.algorithms.curves.curve import Curve
from iconstudio.algorithms.curves.example import Pair
from iconstudio.algorithms.curves.parameters import Parameters

STEP = 0.5


class Refinement:
    """Goes once over an open B', from its start on; the best candidate wins, ties the first."""

    def __init__(self, pair: Pair, parameters: Parameters, spacing: float, rotation: bool) -> None:
        self.parameters, self.spacing, self.rotation = parameters, spacing, rotation
        self.pair = pair
        self.sweep = self.swept(pair.plain)
        k = np.arange(-parameters.reach, parameters.reach + 1)
        self.offsets = spacing * k
        self.weights = np.exp(-0.5 * (k / parameters.sigma) ** 2)

    def swept(self, plain: Curve) -> Curve:
        finest = self.parameters.spacing
        return plain.blurred(self.parameters.sweep * finest, finest / 2)

    def neighbourhood(self, curve: Curve, parameter: float, sweep: Curve, smooth: bool = False):
        """The samples around a parameter, unbent, and which of them are on the curve."""
        middle = curve.arc_at(np.array([parameter]))[0]
        at = middle + self.offsets
        samples = curve.at_arc(at)
        if smooth:
            samples = np.array([self.between(curve, along) for along in at])
        inside = (at > -1e-9) & (at < curve.length + 1e-9)
        clipped = np.clip(at, 0, curve.length)
        along = sweep.arc_at(curve.parameters_at(clipped)) + (at - clipped)
        here = sweep.arc_at(np.array([parameter]))[0]
        return samples - self.bend(sweep, here, along - here), inside

    def between(self, curve: Curve, along: float) -> complex:
        """The point after so much arc length on Catmull and Rom's cubics, not at the ends."""
        points = curve.points
        k = int(np.searchsorted(curve.arc, along, "right")) - 1
        if not 1 <= k < len(points) - 2:
            return curve.at_arc(np.array([along]))[0]
        before, p, q, after = points[k - 1 : k + 3]
        u = (along - curve.arc[k]) / (curve.arc[k + 1] - curve.arc[k])
        basis = [
            -0.5 * u**3 + u**2 - 0.5 * u,
            1.5 * u**3 - 2.5 * u**2 + 1,
            -1.5 * u**3 + 2 * u**2 + 0.5 * u,
            0.5 * u**3 - 0.5 * u**2,
        ]
        return sum(b * one for b, one in zip(basis, (before, p, q, after), strict=True))

    def bend(self, sweep: Curve, here: float, off: np.ndarray) -> np.ndarray:
        start, back, on = sweep.at_arc(np.array([here, here - STEP, here + STEP]))
        way = (on - back) / abs(on - back)
        return sweep.at_arc(here + off) - start - way * off

    def compare(self, a, b, inside, hole):
        """S, the energies, the centres and the weights of one pair of neighbourhoods."""
        count = len(a)
        use = [k for k in range(count) if inside[k] and not (hole and k == count // 2)]
        total = sum(self.weights[k] for k in use)
        mean_a = sum(self.weights[k] * a[k] for k in use) / total
        mean_b = sum(self.weights[k] * b[k] for k in use) / total
        product, energy = 0j, 0.0
        for k in use:
            product += self.weights[k] * np.conj(a[k] - mean_a) * (b[k] - mean_b)
            energy += self.weights[k] * (abs(a[k] - mean_a) ** 2 + abs(b[k] - mean_b) ** 2)
        delta = self.parameters.tangents * self.spacing**2
        for k in range(count - 1):
            if k in use and k + 1 in use:
                weight = delta * (self.weights[k] + self.weights[k + 1]) / 2
                one, other = a[k + 1] - a[k], b[k + 1] - b[k]
                product += weight * np.conj(one / abs(one)) * other / abs(other)
                energy += 2 * weight
        return product, energy, mean_a, mean_b, total

    def place(self, candidate: float, b, b_inside, plain, plain_inside):
        """The place of the point as one candidate has it, and what that costs (equation 6)."""
        parameters = self.parameters
        styled, _ = self.neighbourhood(self.pair.styled, candidate, self.sweep)
        before, _ = self.neighbourhood(self.pair.plain, candidate, self.sweep)
        middle = len(styled) // 2
        product, energy, mean_a, mean_b, total = self.compare(styled, b, b_inside, hole=True)
        turning, _, mean_plain, mean_target, _ = self.compare(before, plain, plain_inside, False)
        turn = 1.0
        if self.rotation:
            both = product + parameters.alignment * turning
            turn = both / abs(both)
        cost = energy - 2 * (np.conj(turn) * product).real
        mass = self.weights[middle] / (total + self.weights[middle])
        rest = mean_b * (1 - mass)
        whole = mean_a * (1 - mass) + styled[middle] * mass
        wanted = mean_target + turn * (whole - mean_plain)
        pulls = [
            (1.0, mean_b + turn * (styled[middle] - mean_a)),
            (parameters.offset * mass**2, (wanted - rest) / mass),
        ]
        place = sum(weight * at for weight, at in pulls) / sum(weight for weight, _ in pulls)
        return place, cost + sum(weight * abs(place - at) ** 2 for weight, at in pulls)

    def run(self, plain: Curve, made: Curve, candidates, arcs):
        """The points of B' and the candidates they are taken from, after one pass."""
        points, sources = made.points.copy(), []
        sweep = self.swept(plain)
        stride = self.parameters.reach * self.spacing
        run = min(stride, self.pair.styled.length / 4)
        for i, parameter in enumerate(made.parameters):
            now = Curve(points.copy(), made.parameters, made.end)
            b, inside = self.neighbourhood(now, parameter, sweep, smooth=True)
            target, target_inside = self.neighbourhood(plain, parameter, sweep)
            best = None
            for j, candidate in enumerate(candidates):
                place, cost = self.place(candidate, b, inside, target, target_inside)
                if i > 0:
                    step = arcs[j] - arcs[sources[-1]]
                    if not 1e-7 < step < 1.5 * abs(place - points[i - 1]):
                        cost *= self.parameters.incoherent
                        ending = self.pair.styled.length - arcs[j] < run
                        if ending or -stride < step <= 0:
                            cost *= 100
                if best is None or cost < best[0]:
                    best = cost, place, j
            points[i] = best[1]
            sources.append(best[2])
        return points, sources
