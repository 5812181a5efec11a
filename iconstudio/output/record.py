"""What ``results.json`` says, for all workflows in the same words."""

from collections.abc import Mapping
from dataclasses import asdict
from typing import Any

from iconstudio import __version__
from iconstudio.model import CANVAS, Axis, Composite, Frame, Pictogram, Placement, Remix, Source

_STAGES = ("search", "prepare", "match", "remix", "vectorize", "total")


def head(timings: Mapping[str, float], **more: Any) -> dict[str, Any]:
    """Return what every report begins with; ``timings`` are seconds by stage."""
    rounded = {stage: round(seconds, 4) for stage, seconds in timings.items()}
    return {"version": __version__, "canvas": CANVAS, **more, "timings": rounded}


def remix_head(symmetry: Axis | None, timings: Mapping[str, float]) -> dict[str, Any]:
    """Return what reports of remixes begin with; stages without ``timings`` took no time."""
    return head({stage: timings.get(stage, 0.0) for stage in _STAGES}, symmetry=symmetry)


def of_remix(name: str, icon: Remix) -> dict[str, Any]:
    """Describe an icon whose files are called ``name``."""
    composite = icon.composite
    return {
        "style": composite.style,
        "m": len(composite.labels),
        "lambda_s": float(composite.lambda_s),
        "energy": float(composite.energy),
        "data_cost": float(composite.data_cost),
        "smoothness_cost": float(composite.smoothness_cost),
        "symmetry": composite.symmetry,
        "without": list(composite.without),
        "iou": None if composite.iou is None else float(composite.iou),
        "frame": _of_frame(icon.drawing.frame),
        "rank_score": float(icon.score.total),
        "rank_terms": {
            term: float(value) for term, value in asdict(icon.score).items() if value is not None
        },
        "svg": f"{name}.svg",
        "png": f"{name}.png",
        "sources_png": f"{name}-sources.png",
        "sources": [_of_share(label, composite) for label in composite.owners()],
    }


def _of_frame(frame: Frame) -> dict[str, float]:
    """Describe the square of the canvas that is drawn, in its units."""
    return {"x": frame.x, "y": frame.y, "size": frame.size}


def of_source(source: Source) -> dict[str, Any]:
    """Describe a source at its placement."""
    return of_placed(source.exemplar.id, source.placement)


def of_placed(icon: str, placement: Placement) -> dict[str, Any]:
    """Describe where an icon lies."""
    return {
        "icon": icon,
        "scale": float(placement.scale),
        "flip": bool(placement.flip),
        "dx": int(placement.dx),
        "dy": int(placement.dy),
    }


def _of_share(label: int, composite: Composite) -> dict[str, Any]:
    """Describe a source; ``label`` is its number in the dump's ``ink`` and ``labels``."""
    source = composite.sources[label]
    pictogram = source.exemplar.pictogram
    share = {"share": composite.shares[label], "label": label}
    described = of_source(source) | thanks(pictogram) | share
    if pictogram.made_of:
        described["made_of"] = [{"icon": one.id} | thanks(one) for one in pictogram.made_of]
    return described


def thanks(pictogram: Pictogram) -> dict[str, str]:
    """Describe whom to thank for a pictogram."""
    credit = pictogram.credit
    return {"author": credit.author, "license": credit.license, "url": credit.url}
