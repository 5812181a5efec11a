"""The folder of a restyled set: files, manifest, contact sheet and credits."""

import json
from dataclasses import replace
from pathlib import PurePosixPath

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from PIL import Image

from iconstudio.inputs.styles import named
from iconstudio.model import Credit, IconstudioError, Pictogram, Transform
from iconstudio.model.icon_set import Member
from iconstudio.output import restyled_set
from iconstudio.output.credits import credits_page
from iconstudio.output.filenames import file_stems
from iconstudio.output.restyled_set import MANIFEST, RestyledSet
from iconstudio.output.svg import document
from iconstudio.svg.rasterise import rasterise
from iconstudio.svg.reading import own_svg
from iconstudio.workflows.line_style.sets import Manner, MemberRestyled, MemberSkipped
from tests.output.made import made, quarters

MANNER = Manner(named("Shaky"))
ANN = Credit("cat", "Ann", "MIT", "https://example.org/mit", "https://example.org/ann")
NAMES = ("cat", "dog", "nul", "Cat", "a/b")


def member(name):
    icon = Pictogram(f"set:{name}", f"<svg>{name}</svg>", ANN)
    return Member(icon.id, name, lambda: icon)


MEMBERS = [member(name) for name in NAMES]
SQUARE = made(quarters()).path


def restyled(one):
    icon = one.read()
    return MemberRestyled(one, icon, ((SQUARE, 0.0),), one.name, (icon,), ())


def written(folder, members=MEMBERS, manner=MANNER, save=True):
    result = RestyledSet(folder, "set", members, manner)
    for one in members:
        if not result.is_done(one, one.read()):
            result.add(restyled(one))
    if save:
        list(result.finish())
    return result


def done(folder, members=MEMBERS, manner=MANNER):
    result = RestyledSet(folder, "set", members, manner)
    return [one.name for one in members if result.is_done(one, one.read())]


def test_a_file_each_a_sheet_and_credits(tmp_path):
    written(tmp_path)
    icons = sorted(tmp_path.glob("*.svg"))
    assert len(icons) == len({one.name.casefold() for one in icons}) == len(NAMES)
    assert not {"nul.svg", "cat.svg"} & {one.name.casefold() for one in icons}
    icon = own_svg(icons[0].read_bytes(), "x.svg")
    assert [one.credit for one in icon.made_of] == [ANN]
    with Image.open(tmp_path / "sheet.png") as sheet:
        assert sheet.convert("L").crop((54, 110, 118, 174)).getextrema()[0] < 60  # ink
    assert "Ann" in (tmp_path / "CREDITS.md").read_text("utf-8")


def test_a_wide_page_is_shown_whole(tmp_path):
    written_set = RestyledSet(tmp_path, "set", MEMBERS[:1], MANNER)
    right = SQUARE.transformed(Transform(1, 0, 0, 1, 256, 0))
    written_set.add(replace(restyled(MEMBERS[0]), drawn=((right, 0.0),), page=(512.0, 256.0)))
    list(written_set.finish())
    (file,) = tmp_path.glob("*.svg")
    assert 'width="512" height="256" viewBox="0 0 512 256"' in file.read_text("utf-8")
    with Image.open(tmp_path / "sheet.png") as sheet:
        assert sheet.convert("L").crop((86, 110, 118, 174)).getextrema()[0] < 60  # ink


def test_what_is_there_is_taken_over_if_nothing_has_changed(tmp_path):
    written(tmp_path)
    assert done(tmp_path) == list(NAMES)
    for other in (
        replace(MANNER, seed=1),
        replace(MANNER, strength=1.5),
        replace(MANNER, size=2.0),
        replace(MANNER, strokes=True),
        replace(MANNER, style=replace(MANNER.style, rotation=not MANNER.style.rotation)),
    ):
        assert done(tmp_path, manner=other) == []
    (tmp_path / "dog.svg").write_text("changed")
    assert done(tmp_path) == [name for name in NAMES if name != "dog"]
    changed = replace(MEMBERS[4].read(), svg="<svg>other</svg>")
    assert not RestyledSet(tmp_path, "set", MEMBERS, MANNER).is_done(MEMBERS[4], changed)


def test_icons_of_another_set_or_in_another_style_are_not_replaced(tmp_path):
    written(tmp_path)
    before = {one: one.read_bytes() for one in tmp_path.iterdir()}
    for name, manner in (("other", MANNER), ("set", replace(MANNER, style=named("Torn")))):
        with pytest.raises(IconstudioError, match="holds icons of set in the style Shaky"):
            RestyledSet(tmp_path, name, MEMBERS, manner)
    assert {one: one.read_bytes() for one in tmp_path.iterdir()} == before


def test_icons_made_with_other_options_are_replaced_and_this_is_told(tmp_path):
    assert not written(tmp_path).remark
    other = replace(MANNER, strength=1.5, seed=7, strokes=True)
    remark = written(tmp_path, manner=other).remark
    assert "are replaced; they were made with strength 1, seed 0, without --strokes." in remark
    assert not RestyledSet(tmp_path, "set", MEMBERS, other).remark


def test_where_nothing_is_restyled_no_folder_is_made(tmp_path):
    result = RestyledSet(tmp_path / "new", "set", MEMBERS, MANNER)
    result.add(MemberSkipped(MEMBERS[0], "It is empty."))
    result.save()
    assert not (tmp_path / "new").exists()


def test_a_run_that_was_killed_loses_only_what_is_newer_than_the_manifest(tmp_path, monkeypatch):
    monkeypatch.setattr(restyled_set, "_EVERY", -1.0)  # at once
    result = RestyledSet(tmp_path, "set", MEMBERS, MANNER)
    result.add(restyled(MEMBERS[0]))
    monkeypatch.setattr(restyled_set, "_EVERY", 1e9)
    result.add(restyled(MEMBERS[1]))
    assert done(tmp_path) == ["cat"]
    assert len(written(tmp_path)) == len(NAMES)
    again = RestyledSet(tmp_path / "new", "set", MEMBERS, MANNER)
    for one in MEMBERS:
        again.add(restyled(one))
    list(again.finish())
    for file in (tmp_path / "new").iterdir():
        assert file.read_bytes() == (tmp_path / file.name).read_bytes()


@pytest.mark.parametrize("text", ["", "{", "[]", '{"files": 3}', "[" * 100_000, "\udcff"])
def test_a_broken_manifest_is_made_anew(tmp_path, text):
    written(tmp_path)
    (tmp_path / MANIFEST).write_bytes(text.encode(errors="surrogateescape"))
    assert done(tmp_path) == []
    assert len(written(tmp_path)) == len(NAMES)
    assert done(tmp_path) == list(NAMES)


def test_what_an_earlier_run_left_is_removed_and_nothing_else(tmp_path, monkeypatch):
    monkeypatch.setattr(restyled_set, "PER_SHEET", 2)
    written(tmp_path)
    assert len(list(tmp_path.glob("sheet*.png"))) == 3
    mine = tmp_path / "dog.svg"
    mine.write_text("mine now")
    (tmp_path / "other.svg").write_text("never theirs")
    written(tmp_path, MEMBERS[:1])
    left = {one.name for one in tmp_path.iterdir()}
    assert left == {"cat.svg", "dog.svg", "other.svg", "sheet.png", "CREDITS.md", MANIFEST}
    assert mine.read_text() == "mine now"


def test_a_manifest_cannot_name_files_elsewhere(tmp_path):
    folder = tmp_path / "out"
    written(folder)
    manifest = json.loads((folder / MANIFEST).read_text())
    victim = tmp_path / "victim.svg"
    victim.write_bytes((folder / "dog.svg").read_bytes())
    manifest["files"]["../victim.svg"] = manifest["files"]["dog.svg"]
    manifest["sheets"].append("../sheet.png")
    (tmp_path / "sheet.png").write_text("")
    (folder / MANIFEST).write_text(json.dumps(manifest))
    written(folder, MEMBERS[:1])
    assert victim.exists() and (tmp_path / "sheet.png").exists()


def test_skipped_icons_and_seeds_are_in_the_manifest(tmp_path):
    result = RestyledSet(tmp_path, "set", MEMBERS[:2], MANNER)
    result.add(MemberSkipped(MEMBERS[0], "It is empty."))
    result.add(replace(restyled(MEMBERS[1]), remarks=("Text was left out.",)))
    list(result.finish())
    manifest = json.loads((tmp_path / MANIFEST).read_text())
    assert manifest["skipped"] == {"set:cat": "It is empty."}
    assert manifest["files"]["dog.svg"]["seed"] == MANNER.seed_of("set:dog")
    assert result.remarks == {"set:dog": "Text was left out."}


WORDS = st.text(max_size=8) | st.sampled_from(["a", "A", "con", "COM1.x", "é", "e\u0301", "."])


@settings(max_examples=60, suppress_health_check=[HealthCheck.too_slow])
@given(st.dictionaries(WORDS, WORDS, max_size=12))
def test_file_names_are_safe_everywhere_and_differ(names):
    stems = file_stems(names)
    assert len({one.casefold() for one in stems.values()}) == len(names)
    for stem in stems.values():
        assert len(f"{stem}.svg".encode()) <= 255
        assert stem == PurePosixPath(stem).name == stem.strip(" .")
        assert not set('<>:"/\\|?*') & set(stem) and stem.isprintable()
        assert stem.partition(".")[0].casefold() not in ("con", "nul", "com1")


def test_credits_are_listed_by_author_and_show_as_they_are():
    bob = Credit("b", "Bob *x*\n# head", "<script>", "javascript:x", "https://b.org/)>")
    page = credits_page("my [set]", "Shaky", {"a.svg": [ANN, bob], "b.svg": [ANN]})
    lines = page.splitlines()
    assert "my \\[set\\]" in page
    assert lines[4].startswith("- ") and lines[4].endswith("all 2 icons")
    assert "[Ann](<https://example.org/ann>), [MIT](<https://example.org/mit>)" in lines[4]
    assert lines[5] == "- “b” by [Bob \\*x\\* \\# head](<https://b.org/)>), \\<script\\>: a.svg"
    assert len(lines) == 6


def test_a_path_of_a_stroke_and_one_that_is_filled_in_one_document():
    svg = document("t", (), [(SQUARE, 0.0), (SQUARE, 9.5)], (300, 256))
    assert 'viewBox="0 0 300 256"' in svg
    assert 'fill="none" stroke="currentColor" stroke-width="9.5"' in svg
    assert rasterise(svg)[1].any()
