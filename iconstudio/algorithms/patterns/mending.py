"""Torn elements made whole (beyond the paper).

The exemplar's own whole elements are laid where the synthesised layer is most like them, the best
first, unless they would touch one that lies there already. What ink is then left is torn, and taken
out. Those that lie closer than need be move apart; where a gap remains that has room for an
element, the most likely one is laid there.
"""

from collections.abc import Callable, Sequence
from statistics import median

import numpy as np
from numpy.typing import NDArray
from scipy import ndimage

from iconstudio.algorithms.patterns.distance import signed_distance
from iconstudio.algorithms.patterns.elements import Element, Elements
from iconstudio.algorithms.patterns.exemplar import Places
from iconstudio.algorithms.patterns.fourier import Field, forward
from iconstudio.algorithms.patterns.laying import Candidate, Mended, Other, Sheet

Bitmap = NDArray[np.bool_]

_LIKELY = 0.75
"""Of what an element differs from emptiness, it may differ so much from what it replaces."""
_AS_LIKELY = 0.02
"""Elements are as likely in a place if their unlikeness differs by less."""
_BALANCE = 0.3
"""What an element that is laid twice as often as in the exemplar is less likely by."""
_RARELY, _TRIES = 0.25, 4
"""So much less often than in the exemplar an element is laid, at least, before it takes the places
of others, and in how many places it is tried."""
_FULL = 0.97
"""Of the exemplar's share of ink, how much a pattern has before narrow gaps are left empty."""
_LIKELY_FULL = 1.03
"""How much of it elements make before less likely ones are left out."""
_FULLEST = 1.08
"""How much of it a pattern has at most; up to that, wide gaps are filled."""


def mended(
    distance: Field,
    source: Places,
    elements: Elements,
    tile: bool,
    random: np.random.Generator,
    ask: Callable[[], None] = lambda: None,
    guidance: Field | None = None,
    others: Sequence[Other] = (),
    evenly: bool = False,
) -> Mended:
    """Return a layer (H, W) in which no element is torn.

    Parameters
    ----------
    distance, source
        Signed distances, and where in the exemplar each pixel comes from.
    elements
        Of the exemplar's layer. If none is whole, the layer stays as it is.
    guidance
        (H, W), how much of each pixel lies where ink may be, from 0 to 1: elements lie there
        wholly, what else there is ends at its contour.
    others
        Layers that are mended already.
    evenly
        Whether elements move apart where the pattern has emptier places than the exemplar.
    """
    allowed = None
    if guidance is not None:
        allowed = guidance > 0.5
        distance = np.maximum(distance, signed_distance(guidance - np.float32(0.5), tile))
    if not elements.whole:
        return Mended.nothing(distance, source)
    sheet = Sheet(distance, source, elements, tile, allowed, others)
    unlikeness: list[Field] = []
    candidates: list[Candidate] = []
    for element in elements.whole:
        ask()
        values = sheet.unlikeness(element)
        places = np.argwhere(_least(values, tile) & (values < _LIKELY))
        candidates += [Candidate(float(values[y, x]), element, y, x) for y, x in places]
        unlikeness.append(values)
    usual = elements.share * sheet.area / sum(int(one.ink.sum()) for one in elements.whole)
    for one in sorted(candidates, key=lambda candidate: candidate.unlikeness):
        ask()
        best = _balanced(one, sheet, elements.whole, unlikeness, usual)
        if best is not None and sheet.share_with(best) <= _LIKELY_FULL * elements.share:
            sheet.lay(best)
    _bring_in(sheet, elements.whole, unlikeness, usual, ask)
    evenly = evenly and elements.independent and sheet.is_uneven()
    if evenly:
        sheet.spread(ask)
    common = median(int(element.ink.sum()) for element in elements.whole)
    for blocked, most, least in (
        (sheet.sparsely, _FULLEST, common),
        (sheet.sparsely, _FULL, 0),
        (sheet.densely, _FULL, 0),
    ):
        while sheet.share < most * elements.share:
            found = _fitting(sheet, blocked, elements.whole, unlikeness, random, ask, least)
            if found is None or sheet.share_with(found) > _FULLEST * elements.share:
                break
            sheet.lay(found)
    if evenly:
        sheet.spread(ask)
    return sheet.result(ask)


def _balanced(
    one: Candidate, sheet: Sheet, whole: Sequence[Element], unlikeness: list[Field], usual: float
) -> Candidate | None:
    """Return what to lay in one's place: what is likely there, and not laid too often already.

    ``usual`` is how often each lies in as large a part of the exemplar. Of those as likely, such as
    elements of one shape in several colours, it is the rarest. None if it has no room itself.
    """
    if not sheet.has_room(one):
        return None
    costs: list[tuple[float, int, bool, Candidate]] = []
    for other, values, count in zip(whole, unlikeness, sheet.counts(whole), strict=True):
        there = _in_place_of(one, other, values)
        if there.unlikeness < _LIKELY:
            more = max(there.unlikeness - one.unlikeness, _AS_LIKELY)
            too_often = max(count - usual, 0) / usual
            is_other = other is not one.element
            costs.append((more + _BALANCE * too_often, count, is_other, there))
    in_order = sorted(costs, key=lambda cost: cost[:3])
    return next((there for *_, there in in_order if sheet.has_room(there)), None)


def _in_place_of(one: Candidate, other: Element, unlikeness: Field) -> Candidate:
    """Return another element with its middle where one's is."""
    rows, columns = unlikeness.shape
    (height, width), (own_height, own_width) = one.element.ink.shape, other.ink.shape
    top = round(one.top + (height - own_height) / 2) % rows
    left = round(one.left + (width - own_width) / 2) % columns
    return Candidate(float(unlikeness[top, left]), other, top, left)


def _bring_in(
    sheet: Sheet,
    whole: Sequence[Element],
    unlikeness: list[Field],
    usual: float,
    ask: Callable[[], None],
) -> None:
    """Put elements that are hardly laid in the places of those that are laid too often."""
    if usual < 1:
        return  # there is not room for all of them
    counts = sheet.counts(whole)
    numbers = {id(element): number for number, element in enumerate(whole)}
    for k in sorted(range(len(whole)), key=counts.__getitem__):
        while counts[k] < _RARELY * usual:
            often = [one for one in sheet.laid if counts[numbers[id(one.element)]] > usual]
            pairs = [(one, _in_place_of(one, whole[k], unlikeness[k])) for one in often]
            pairs = [pair for pair in pairs if np.isfinite(pair[1].unlikeness)]
            pairs.sort(key=lambda pair: pair[1].unlikeness)
            for one, other in pairs[:_TRIES]:
                ask()
                if sheet.exchange(one, other):
                    counts[numbers[id(one.element)]] -= 1
                    counts[k] += 1
                    break
            else:
                break


def _least(values: Field, tile: bool) -> Bitmap:
    mode = "wrap" if tile else "nearest"
    lowest: Bitmap = values == ndimage.minimum_filter(values, 5, mode=mode)
    return lowest


def _fitting(
    sheet: Sheet,
    blocked: Bitmap,
    whole: Sequence[Element],
    unlikeness: list[Field],
    random: np.random.Generator,
    ask: Callable[[], None],
    least: float,
) -> Candidate | None:
    """Return the rarest element, large enough, that fits into a gap, where it is least unlike."""
    spectrum = forward(blocked.astype(np.float32), blocked.shape)
    counts = sheet.counts(whole)
    for k in sorted(random.permutation(len(whole)), key=counts.__getitem__):
        ask()
        if whole[k].ink.sum() < least:
            continue
        room = sheet.correlated(spectrum, whole[k].ink.astype(np.float32)) < 0.5
        room &= np.isfinite(unlikeness[k]) & sheet.clear_of_others(whole[k])
        if room.any():
            y, x = np.unravel_index(np.argmin(np.where(room, unlikeness[k], np.inf)), room.shape)
            return Candidate(float(unlikeness[k][y, x]), whole[k], int(y), int(x))
    return None
