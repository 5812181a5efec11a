"""A small world to build collections from: IconifyJSON sets, a WordNet and licences."""

import json
from pathlib import Path

ANIMAL, ARTIFACT, FOOD, ACT, BODY, PERSON, EVENT = 5, 6, 13, 4, 8, 18, 11

SYNSETS = (
    # key, lexicographer file, words, keys of the parents
    (1, ANIMAL, ("canine",), ()),
    (2, ANIMAL, ("dog", "domestic_dog"), (1,)),
    (3, ANIMAL, ("puppy",), (2,)),
    (4, ANIMAL, ("poodle",), (2,)),
    (5, FOOD, ("hot_dog",), ()),
    (6, ARTIFACT, ("bowl",), ()),
    (7, ARTIFACT, ("motorcycle", "bike"), ()),
    (8, ARTIFACT, ("motorbike",), (7,)),
    (9, ARTIFACT, ("lamp",), ()),
    (10, ARTIFACT, ("table_lamp",), (9,)),
    (11, ARTIFACT, ("table",), ()),
    (12, ANIMAL, ("mouse",), ()),
    (13, ARTIFACT, ("teapot",), ()),
    (14, ARTIFACT, ("scissors",), ()),
    (15, ANIMAL, ("horse",), ()),
    (16, ANIMAL, ("charger",), (15,)),
    (17, FOOD, ("apple",), ()),
    (18, ACT, ("walking",), ()),
    (19, ARTIFACT, ("house",), ()),
    (20, ACT, ("police",), ()),
    (21, PERSON, ("chump", "gull", "mug"), ()),
    (22, ANIMAL, ("gull",), ()),
    (23, ARTIFACT, ("mug",), (31,)),
    (24, BODY, ("nail",), ()),
    (25, ARTIFACT, ("nail",), ()),
    (26, BODY, ("fingernail",), (24,)),
    (27, ARTIFACT, ("thumbtack",), (25,)),
    (28, ANIMAL, ("lion",), ()),
    (29, ANIMAL, ("eared_seal",), ()),
    (30, ANIMAL, ("sea_lion",), (29,)),
    (31, ARTIFACT, ("vessel",), ()),
    (32, ARTIFACT, ("jug",), (31,)),
    (33, ARTIFACT, ("ewer",), (31,)),
    (34, BODY, ("organ",), ()),
    (35, BODY, ("eye",), (34,)),
    (36, BODY, ("anus",), (34,)),
    (37, ANIMAL, ("ass",), ()),
    (38, ARTIFACT, ("bar_code",), ()),
    (39, ARTIFACT, ("carousel", "merry-go-round"), ()),
    (40, ANIMAL, ("fur_seal",), (29,)),
    (41, EVENT, ("wedding",), ()),
    (42, ANIMAL, ("fish",), ()),
    (43, ANIMAL, ("harbor_seal",), (29,)),
    (44, ARTIFACT, ("carafe",), (31,)),
)
VERBS = ("run", "fish", "wed", "walk")
UNCOUNTED = ("chump", "gull", "mug")
"""Words that do not occur in the texts that were counted."""


def write_wordnet(folder: Path) -> Path:
    """Write nouns and verbs in WordNet's format; keys stand for offsets."""
    folder.mkdir(parents=True)
    (folder.parent / "LICENSE").write_text("WordNet licence\n")
    data = ["  1 This line is part of the licence.\n"]
    senses: dict[str, list[int]] = {}
    for key, kind, words, parents in SYNSETS:
        spelt = " ".join(f"{word} 0" for word in words)
        pointers = " ".join(f"@ {parent:08d} n 0000" for parent in parents)
        data.append(
            f"{key:08d} {kind:02d} n {len(words):02x} {spelt} {len(parents):03d} {pointers} | x\n"
        )
        for word in words:
            senses.setdefault(word, []).append(key)
    (folder / "data.noun").write_text("".join(data))
    (folder / "index.noun").write_text(
        "".join(
            f"{word} n {len(keys)} 1 @ {len(keys)} 1 {' '.join(f'{key:08d}' for key in keys)}  \n"
            for word, keys in sorted(senses.items())
        )
    )
    (folder / "index.verb").write_text(
        "  1 This line is part of the licence.\n"
        + "".join(f"{verb} v 1 1 @ 1 0 00000001  \n" for verb in VERBS)
    )
    (folder / "index.adj").write_text("neural a 1 0 1 0 00000001  \n")
    (folder / "index.sense").write_text(
        "".join(
            f"{word}%1:{kind:02d}:00:: {key:08d} 1 {int(word not in UNCOUNTED)}\n"
            for key, kind, words, _ in SYNSETS
            for word in words
        )
    )
    return folder


def shape(seed: int) -> str:
    """Return a body that looks like no other seed's: five bars of different lengths."""
    bars = [(seed * (3 + 2 * i) + i * i * 7) % 19 + 3 for i in range(5)]
    path = "".join(f"M1 {1 + 4.6 * i}h{length}v3H1z" for i, length in enumerate(bars))
    return f'<path fill="currentColor" d="{path}"/>'


def icon_set(prefix: str, icons: dict[str, str], **changes: object) -> dict[str, object]:
    """Return an IconifyJSON set of 24 pixel icons; ``changes`` replace parts of its info."""
    info = {
        "name": prefix.title(),
        "version": "1.2.3",
        "author": {"name": f"Author of {prefix}", "url": f"https://example.org/{prefix}"},
        "license": {"title": "MIT", "spdx": "MIT", "url": f"https://example.org/{prefix}/licence"},
        "palette": False,
        "category": "UI 24px",
    }
    return {
        "prefix": prefix,
        "info": info | changes,
        "icons": {name: {"body": body} for name, body in icons.items()},
        "width": 24,
        "height": 24,
    }


def write_sets(folder: Path, *sets: dict[str, object]) -> Path:
    """Write sets as an unpacked ``@iconify/json``."""
    (folder / "json").mkdir(parents=True)
    (folder / "package.json").write_text('{"version": "9.9.9"}')
    for one in sets:
        (folder / "json" / f"{one['prefix']}.json").write_text(json.dumps(one))
    return folder
