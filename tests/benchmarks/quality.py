"""How well results are drawn, in numbers: `python -m tests.benchmarks.quality FOLDER...`.

Each folder holds the results of one version of the program, in a folder for each sketch, as
`python -m tests.benchmarks.quality --make FOLDER` writes them: of the sketches that were judged by
eye, and of the gallery's. Their columns come out side by side. All is told of what is recommended,
but the overlap, of which the best result of a sketch counts.
"""

import argparse
import json
import subprocess
import sys
from collections.abc import Iterator
from itertools import pairwise
from pathlib import Path

import numpy as np
import scipy
from skimage import measure, morphology

from iconstudio.model import CANVAS, Frame, Placement
from iconstudio.model.path import Path as Outline
from iconstudio.resources import resource
from iconstudio.session import Session
from iconstudio.svg.outline import outline_of
from iconstudio.svg.placed import render_placed

WINDOW, UNLIKE = 40, 0.35
"""Canvas units of the stretches of contour that are compared, and how far a stretch is from all of
the sources', root mean square after turning and moving, if it is foreign."""
SLIVER = 0.005 * CANVAS
LEAN = 0.2, 3.0
"""Degrees off the vertical or horizontal between which a straight line leans."""
LONG = 12.0
"""Canvas units of the shortest line that is seen to lean."""
_FINE = 4


def stretches(ink: np.ndarray, step: int = 1) -> np.ndarray:
    """Return windows of the contours of ink (n, n) as complex rows about their means."""
    soft = scipy.ndimage.gaussian_filter(np.pad(ink, 4).astype(float), 1.2)
    rows = [np.zeros((0, WINDOW + 1), complex)]
    for contour in measure.find_contours(soft, 0.5):
        z = contour[:, 1] + 1j * contour[:, 0]
        along = np.r_[0, np.cumsum(abs(np.diff(z)))]
        if along[-1] < 16:
            continue
        at = np.arange(int(along[-1]))
        even = np.interp(at, along, z.real) + 1j * np.interp(at, along, z.imag)
        windows = even[(at[::step, None] + np.arange(WINDOW + 1) - WINDOW // 2) % len(at)]
        rows.append(windows - windows.mean(axis=1, keepdims=True))
    return np.concatenate(rows).astype(np.complex64)


def foreign(ink: np.ndarray, sources: np.ndarray) -> float:
    """Return the part of a contour that is unlike every stretch of the sources' (K, n, n)."""
    own = stretches(ink)
    others = np.concatenate([stretches(source, 2) for source in sources])
    power = (abs(own) ** 2).sum(axis=1)
    least = np.full(len(own), np.inf, np.float32)
    for part in np.array_split(others, max(1, len(others) // 8000)):
        along = abs(own @ part.conj().T)
        apart = power[:, None] + (abs(part) ** 2).sum(axis=1) - 2 * along
        least = np.minimum(least, apart.min(axis=1))
    return float((np.sqrt(np.maximum(least, 0) / (WINDOW + 1)) > UNLIKE).mean())


def spread(ink: np.ndarray) -> float:
    """Return how many times as wide as thin strokes thick ones are, by deciles on the skeleton."""
    widths = scipy.ndimage.distance_transform_edt(ink)[morphology.skeletonize(ink)]
    low, high = np.quantile(widths, (0.1, 0.9)) if widths.size else (1, 1)
    return float(high / low)


def has_sliver(fine: np.ndarray) -> bool:
    """Whether ink or paper, finely drawn, is thinner than a sliver over twice its width or more."""
    radius = SLIVER / 2 * len(fine) / CANVAS
    for tone in (fine, ~fine):
        padded = np.pad(tone, 8, mode="edge")
        core = scipy.ndimage.distance_transform_edt(padded) > radius
        thin = padded & ~(scipy.ndimage.distance_transform_edt(~core) <= radius + 1)
        pieces, _ = scipy.ndimage.label(thin, np.ones((3, 3)))
        if (np.bincount(pieces.ravel())[1:] > (2 * radius) ** 2).any():
            return True
    return False


def leaning(path: Outline) -> int:
    """Return how many straight lines are a little off the horizontal or the vertical."""
    count = 0
    for contour in path.contours:
        points = [contour.start, *(segment[-1] for segment in contour.segments)]
        straight = [len(segment) == 1 for segment in contour.segments]
        for (start, end), line in zip(pairwise(points), straight, strict=True):
            dx, dy = abs(end[0] - start[0]), abs(end[1] - start[1])
            off = np.degrees(np.arctan2(min(dx, dy), max(dx, dy)))
            count += line and np.hypot(dx, dy) > LONG and LEAN[0] < off < LEAN[1]
    return count


def nodes(path: Outline) -> Iterator[tuple[float, float]]:
    """Yield the nodes of a path."""
    for contour in path.contours:
        for segment in contour.segments:
            yield segment[-1]


def nodes_used(session: Session, result: dict, labels: np.ndarray) -> int:
    """Return how many nodes of the sources lie in what they own of the labels (m, m)."""
    count, m = 0, len(labels)
    for source in result["sources"]:
        exemplar = session.exemplar(session.icon(source["icon"]))
        outline = outline_of(exemplar.pictogram.svg, exemplar.frame)
        where = Placement(source["scale"], source["flip"], source["dx"], source["dy"]).transform
        for x, y in nodes(outline.transformed(where)):
            column, row = (min(max(int(v * m / CANVAS), 0), m - 1) for v in (x, y))
            count += labels[row, column] == source["label"]
    return count


def measured(folder: Path, session: Session) -> tuple[float, list[dict[str, float]]]:
    """Return the best overlap of a sketch's results, and the measures of those recommended."""
    results = json.loads((folder / "results.json").read_text("utf-8"))["results"]
    recommended = []
    for result in results:
        if not result["recommended"] or result["frame"]["size"] != CANVAS:
            continue
        with np.load(folder / f"{result['style']}.npz") as dump:
            sources = dump["ink"]
            at = int(np.argmin(abs(dump["lambda_s"] - result["lambda_s"])))
            labels = dump["labels"][at]
        svg = (folder / result["svg"]).read_text("utf-8")
        frame = Frame(0, 0, CANVAS)
        fine = render_placed(svg, frame, Placement(), _FINE * CANVAS) > 127
        ink = fine.reshape(CANVAS, _FINE, CANVAS, _FINE).mean(axis=(1, 3)) > 0.5
        owned = [sources[k] & (labels == k) for k in np.unique(labels)]
        shares = [one.sum() for one in owned]
        used = [spread(sources[k]) for k in np.unique(labels)]
        path = outline_of(svg, frame)
        recommended.append(
            {
                "foreign": foreign(ink, sources),
                "widths": spread(ink) / max(np.average(used, weights=shares), 1e-9),
                "nodes": len(list(nodes(path))) / max(nodes_used(session, result, labels), 1),
                "sliver": float(has_sliver(fine)),
                "leaning": float(leaning(path)),
                "light": float(result["style"] in ("lightest", "light")),
                "iou": float(result["iou"]),
            }
        )
    return max(result["iou"] for result in results), recommended


def table(folders: list[Path], session: Session) -> str:
    """Return the columns of several versions, as a table."""
    columns: list[list[str]] = []
    for folder in folders:
        found = [measured(one.parent, session) for one in sorted(folder.glob("*/results.json"))]
        rows = [row for _, some in found for row in some]
        get = {name: np.array([row[name] for row in rows]) for name in rows[0]}
        lines = get["light"] > 0
        columns.append(
            [
                f"{len(found)}, {len(rows)}",
                f"{np.median(get['foreign']):.3f}, {get['foreign'].mean():.3f}",
                f"{np.median(get['widths'][lines]):.2f}, {(get['widths'][lines] < 1.2).mean():.0%}",
                f"{np.median(get['nodes']):.2f}, {(get['nodes'] < 1.3).mean():.0%}",
                f"{get['sliver'].mean():.0%}",
                f"{get['leaning'].mean():.2f}",
                f"{np.mean([best for best, _ in found]):.3f}",
                f"{get['iou'].mean():.3f}",
            ]
        )
    heads = (
        "Sketches, recommended results",
        "Foreign contour, median and mean",
        "Spread of widths by the sources', line icons: median, below 1.2",
        "Nodes by the sources' used parts: median, below 1.3",
        "With a sliver under 0.5% of the side",
        "Lines that lean, for each result",
        "Overlap with the sketch, best results",
        "Overlap with the sketch, recommended results",
    )
    return "\n".join(f"| {' | '.join(row)} |" for row in zip(heads, *columns, strict=True))


def make(out: Path, program: str) -> None:
    """Remix all sketches with a program, ``iconstudio`` by default."""
    gallery = sorted(resource("examples/gallery").glob("*.json"))
    sketches = {one.stem: json.loads(one.read_text("utf-8")) for one in gallery}
    judged = json.loads(resource("judged/sketches.json").read_text("utf-8"))["sketches"]
    for one in judged:
        sketches.setdefault(one["name"], one)
    out.mkdir(parents=True, exist_ok=True)
    for name, one in sketches.items():
        if (out / name / "results.json").exists():
            continue
        asked = {"keyword": one["keyword"], "polygon": one["polygon"]}
        asked |= {"symmetry": one["symmetry"]} if one.get("symmetry") else {}
        file = out / f"{name}.json"
        file.write_text(json.dumps(asked), encoding="utf-8")
        command = [program, "model", str(file), "--out", str(out / name), "--dump"]
        subprocess.run(command, check=True, stdout=subprocess.DEVNULL)


def main() -> None:
    """Make results, or measure those that are there."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("folders", nargs="+", type=Path)
    parser.add_argument("--make", action="store_true")
    parser.add_argument("--program", default=str(Path(sys.executable).parent / "iconstudio"))
    asked = parser.parse_args()
    if asked.make:
        for folder in asked.folders:
            make(folder, asked.program)
        return
    with Session() as session:
        print(table(asked.folders, session))


if __name__ == "__main__":
    main()
