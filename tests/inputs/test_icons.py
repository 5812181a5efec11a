"""What no collection has is kept beside the file that refers to it."""

import pytest

from iconstudio.inputs.icons import reference_to
from iconstudio.model import Credit, IconstudioError, Pictogram
from iconstudio.svg.reading import own_svg
from iconstudio.workflows.editing.file import read_edit

CREDIT = Credit("Dog", "Ada", "MIT", "", "")


def test_an_icon_of_a_collection_is_named(tmp_path):
    assert reference_to(Pictogram("set:dog", "<svg/>", CREDIT), tmp_path / "a.json") == "set:dog"
    assert not list(tmp_path.iterdir())


@pytest.mark.parametrize("identifier", ["made:dog-12ab", "own:dog-12ab"])
def test_any_other_is_saved_under_the_names_of_both(tmp_path, identifier):
    icon = Pictogram(identifier, "<svg><metadata/>ä</svg>", CREDIT)
    reference = reference_to(icon, tmp_path / "edit.json")
    assert reference == str((tmp_path / "edit-dog-12ab.svg").resolve())
    assert (tmp_path / "edit-dog-12ab.svg").read_text("utf-8") == icon.svg


def test_a_name_cannot_lead_out_of_the_folder(tmp_path):
    icon = Pictogram("own:../../x", "<svg/>", CREDIT)
    reference_to(icon, tmp_path / "edit.json")
    assert [path.parent for path in tmp_path.rglob("*.svg")] == [tmp_path]


def test_a_folder_that_is_not_there_is_told(tmp_path):
    with pytest.raises(IconstudioError, match="cannot be written"):
        reference_to(Pictogram("own:x", "<svg/>", CREDIT), tmp_path / "gone" / "edit.json")


@pytest.mark.parametrize("title", ["my <drawing> & \u00e4", "a\x01b", ""])
def test_its_title_comes_back(tmp_path, title):
    svg = b'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 9 9"><path d="M2 2h5v5z"/></svg>'
    drawn = own_svg(svg, "drawing.svg")
    credit = Credit(title, *(getattr(drawn.credit, name) for name in Credit.__slots__[1:]))
    icon = Pictogram(drawn.id, drawn.svg, credit)
    for _ in range(2):  # also of what was read back
        path = reference_to(icon, tmp_path / "saved.json")
        with open(path, "rb") as file:
            icon = own_svg(file.read(), path)
        assert icon.credit.title == (title.replace("\x01", "") or icon.credit.title)
        assert icon.credit.author == drawn.credit.author


def test_an_address_stays_one(tmp_path):
    path = tmp_path / "edit.json"
    path.write_text('{"icon": "http://example.com/a.svg"}')
    assert read_edit(path).icon == "http://example.com/a.svg"
