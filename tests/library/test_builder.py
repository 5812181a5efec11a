"""The builder: which icons get into a collection, and what stands beside them."""

import json
from concurrent.futures import Future

import pytest
from small_world import icon_set, shape, write_sets

from iconstudio.building import drawings
from iconstudio.building.builder import Inputs, build
from iconstudio.library.archive import Archive
from iconstudio.library.iconify import RawIcon
from iconstudio.model import IconstudioError
from iconstudio.workers import ProcessDied


def names(folder):
    index = json.loads(Archive.at(folder).read("index.json.xz"))
    prefixes = [one["prefix"] for one in index["sets"]]
    return [
        f"{prefixes[number]}:{name}"
        for number, name in zip(index["set_of"], index["names"], strict=True)
    ]


def test_same_input_gives_the_same_bytes(make):
    sets = [
        icon_set("a", {f"dog-{i}": shape(i) for i in range(12)}),
        icon_set("b", {"horse": shape(50)}),
    ]
    one, two = make(*sets), make(*reversed(sets))
    files = sorted(path.name for path in one.iterdir())
    assert files == ["CREDITS", "bodies.txt.xz", "index.json.xz", "manifest.json", "shapes.bin.xz"]
    for name in files:
        assert (one / name).read_bytes() == (two / name).read_bytes()


def test_only_licences_that_allow_derivatives(make):
    kept = icon_set("free", {"dog": shape(1)})
    dropped = [
        icon_set(f"set{number}", {"dog": shape(number + 2)}, license={"title": spdx, "spdx": spdx})
        for number, spdx in enumerate(
            ("CC-BY-SA-4.0", "CC-BY-NC-4.0", "GPL-3.0-only", "OFL-1.1", "")
        )
    ]
    assert names(make(kept, *dropped)) == ["free:dog"]


def test_no_colour_logo_pixel_animation_or_hidden(make):
    good = icon_set("good", {"dog": shape(1)})
    good["icons"] |= {
        "secret": {"body": shape(2), "hidden": True},
        "moving": {"body": f"<g>{shape(3)}<animate attributeName='x'/></g>"},
        "red": {"body": shape(4).replace("currentColor", "#f00")},
        "acme-logo": {"body": shape(5)},
        "pixel-dog": {"body": shape(30)},
        "brand-acme": {"body": shape(6)},
        "zorbly": {"body": shape(7)},
        "bowl-off": {"body": shape(8)},
        "nothing": {"body": "<g/>"},
        "broken": {"body": "<path d='M0 0h9v9z'"},
        "knight": {"body": shape(9)},
        "stamp": {"body": shape(10)},
    }
    good["categories"] = {"Brands": ["stamp"]}
    others = [
        icon_set("paint", {"dog": shape(20)}, palette=True),
        icon_set("logos", {"zorbly": shape(21)}, category="Logos"),
        icon_set("pixelart", {"dog": shape(22)}),
        icon_set("spin", {"dog": shape(23)}, tags=["Contains Animations"]),
        icon_set("old", {"dog": shape(24)}, hidden=True),
    ]
    assert names(make(good, *others)) == ["good:dog", "good:knight"]


def test_a_logo_with_a_common_name_is_known_by_its_looks(make):
    logos = icon_set("logos", {"apple": shape(1)}, category="Logos")
    tech = icon_set("tech", {"apple": shape(1).replace("<path", "<path stroke-width='0'")})
    fruit = icon_set("fruit", {"apple": shape(2)})
    assert names(make(logos, tech, fruit)) == ["fruit:apple"]


@pytest.mark.parametrize(
    ("drawn", "as_logo", "kept"), [(4, 1, True), (3, 1, False), (4, 2, False), (6, 2, True)]
)
def test_what_many_draw_is_no_logo_though_a_logo_is_called_so(make, drawn, as_logo, kept):
    things = [
        icon_set(f"a{n}", {"zorbly": shape(n), "bowl": shape(9)}, name="Things")
        for n in range(drawn)
    ]
    things += [icon_set("again", {"zorbly": shape(8)}, author={"name": "Author of a0"})]
    logos = [
        icon_set(f"logos{n}", {"zorbly": shape(20 + n)}, category="Logos") for n in range(as_logo)
    ]
    found = [name for name in names(make(*things, *logos)) if "zorbly" in name]
    wanted = [f"a{n}:zorbly" for n in range(drawn)] + ["again:zorbly"]
    assert found == (wanted if kept else [])


def test_a_common_thing_stays_though_it_looks_like_a_logo_of_its_name(make):
    things = [icon_set(f"a{n}", {"apple": shape(n)}) for n in range(4)]
    logos = icon_set("logos", {"apple": shape(1)}, category="Logos")
    assert "a1:apple" in names(make(*things, logos))


def test_no_alias_is_the_name_of_a_company(opened):
    birds = icon_set("zoo", {"dog": shape(1), "horse": shape(2)})
    birds["aliases"] = {"twitter-dog": {"parent": "dog"}, "barker": {"parent": "dog"}}
    collection = opened(birds)
    assert [found.id for found in collection.search("barker")] == ["zoo:dog"]
    with pytest.raises(IconstudioError, match="logos of brands are left out"):
        collection.search("twitter")


def test_one_size_of_a_drawing_and_no_copies(make):
    one = icon_set(
        "one",
        {
            "dog-16-filled": shape(1),
            "dog-24-filled": shape(2),
            "dog-48-filled": shape(3),
            "dog-24-regular": shape(4),
        },
    )
    two = icon_set("two", {"horse": shape(2), "bowl": shape(5)})
    expected = ["one:dog-24-filled", "one:dog-24-regular", "two:bowl"]
    assert names(make(one, two)) == expected


def test_what_looks_the_same_under_one_name_is_kept_once(make):
    longer, longest = (shape(1).replace("M1 1.0h", f"M1.{zeros} 1.0h") for zeros in ("0", "00"))
    sets = [icon_set("a", {"dog": longer, "bowl": longest}), icon_set("b", {"dog": shape(1)})]
    assert names(make(*sets)) == ["a:bowl", "b:dog"]


@pytest.mark.parametrize(("makers", "kept"), [(3, 0), (4, 4), (12, 10)])
def test_where_there_is_no_room_a_few_drawings_of_what_many_draw_are_kept(
    makers, kept, packages, workers, tmp_path
):
    dot = '<path d="M20 20h3v3h-3z"/>'
    things = icon_set("things", {f"dog-{n}": shape(n) + dot for n in range(16)})
    marks = [icon_set(f"a{n}", {"recycle": shape(n)}) for n in range(makers)]
    iconify = write_sets(tmp_path / "iconify", things, *marks)
    inputs = Inputs(iconify, packages / "wordnet", packages / "spdx")
    for _ in build(inputs, tmp_path / "out", workers, most=12):
        pass
    found = names(tmp_path / "out")
    assert len(found) == 12
    assert sum("recycle" in name for name in found) == kept


def test_aliases_are_names_not_icons(opened):
    animals = icon_set("zoo", {"dog": shape(1), "horse": shape(2)})
    animals["aliases"] = {
        "hound": {"parent": "dog"},
        "barker": {"parent": "hound"},
        "dog-left": {"parent": "dog", "hFlip": True},
        "zebra": {"parent": "dog-left"},
        "circle-one": {"parent": "circle-two"},
        "circle-two": {"parent": "circle-one"},
    }
    collection = opened(animals)
    assert len(collection) == 2
    assert [p.id for p in collection.search("barker")] == ["zoo:dog"]
    with pytest.raises(IconstudioError, match="zebra"):
        collection.search("zebra")


def test_pictogram_is_whole_and_credited(opened):
    birds = icon_set("set", {"dog-side-fill": f'<g id="a"/><use xlink:href="#a"/>{shape(1)}'})
    birds["icons"]["dog-side-fill"] |= {"left": -1, "top": 2, "width": 30, "height": 20}
    (pictogram,) = opened(birds).search("dog")
    assert pictogram.svg.startswith('<svg xmlns="http://www.w3.org/2000/svg" xmlns:xlink=')
    assert 'viewBox="-1 2 30 20"' in pictogram.svg
    credit = pictogram.credit
    assert (credit.title, credit.author) == ("dog side fill", "Author of set")
    assert (credit.license, credit.license_url) == ("MIT", "https://example.org/set/licence")
    assert credit.url == "https://example.org/set"


def test_credits_name_every_set_and_hold_every_licence(make):
    by = {"title": "CC BY", "spdx": "CC-BY-4.0", "url": "https://example.org/by"}
    folder = make(icon_set("a", {"dog": shape(1)}), icon_set("b", {"dog": shape(2)}, license=by))
    text = (folder / "CREDITS").read_text()
    for part in (
        "A 1.2.3 (a, 1 icon)",
        "Author of b",
        "CC-BY-4.0, https://example.org/by",
        "9.9.9",
    ):
        assert part in text
    for part in ("Full text of MIT", "Full text of CC-BY-4.0", "WordNet licence"):
        assert text.count(part) == 1


class MortalWorkers:
    """Works in this process, and dies of what it is given a body named *poison* to draw."""

    def submit(self, function, icons, timeout, memory):
        future = Future()
        if any(icon.name == "poison" for icon in icons):
            future.set_exception(ProcessDied(-11))
        else:
            future.set_result(function(icons))
        return future


def test_a_drawing_that_kills_its_worker_costs_no_other():
    icons = [
        RawIcon("a", name, shape(number), "0 0 24 24")
        for number, name in enumerate(["one", "poison", "two"])
    ]
    *_, shapes = drawings.fingerprints(icons, MortalWorkers())
    assert [drawn is not None for drawn in shapes] == [True, False, True]


def test_a_duotone_whose_pale_parts_are_of_its_shape_is_left_out(make):
    frame = '<path fill="none" stroke="currentColor" stroke-width="2" d="M3 3h18v18H3z"/>'
    handle = '<path fill="none" stroke="currentColor" opacity=".5" d="M9 6V2h6v4"/>'
    inside = '<path fill="currentColor" opacity=".3" d="M3 3h18v18H3z"/>'
    icons = {
        "dog": inside + frame,
        "cat": '<path fill="currentColor" opacity=".4" d="M3 9h18v12H3z"/><path d="M1 4h22v4H1z"/>',
        "horse": frame.replace("3h18v18", "6h18v15") + handle,
    }
    assert names(make(icon_set("a", icons))) == ["a:dog"]


def test_hostile_bodies_are_left_out(make):
    icons = {
        "dog": shape(1),
        "deep": "<g>" * 600 + shape(2) + "</g>" * 600,
        "entity": "<!DOCTYPE x [<!ENTITY e 'e'>]>" + shape(3),
        "circular": '<g id="a"><use href="#a"/></g>' + shape(4),
    }
    assert names(make(icon_set("a", icons))) == ["a:dog"]


@pytest.mark.parametrize("missing", ["iconify", "wordnet", "licences"])
def test_a_missing_input_is_named(missing, packages, workers, tmp_path):
    iconify = write_sets(tmp_path / "iconify", icon_set("a", {"dog": shape(1)}))
    folders = {"iconify": iconify, "wordnet": packages / "wordnet", "licences": packages / "spdx"}
    folders[missing] = tmp_path / "nowhere"
    with pytest.raises(IconstudioError, match="nowhere"):
        list(build(Inputs(**folders), tmp_path / "out", workers))
    assert not (tmp_path / "out").exists()


def test_a_broken_set_is_named(packages, workers, tmp_path):
    iconify = write_sets(tmp_path / "iconify", icon_set("a", {"dog": shape(1)}))
    (iconify / "json" / "b.json").write_text(json.dumps({"prefix": "b"}))
    inputs = Inputs(iconify, packages / "wordnet", packages / "spdx")
    with pytest.raises(IconstudioError, match=r"b\.json is not an IconifyJSON file"):
        list(build(inputs, tmp_path / "out", workers))
