"""What the lines of a text name."""

import os

import pytest

from iconstudio.inputs.items import Elsewhere, File, Reference, named_in


@pytest.mark.parametrize(
    ("text", "named"),
    [
        ("mdi:cat", [Reference("mdi:cat")]),
        (' "/a b/c.svg" \n\n~\n', [File("/a b/c.svg"), File(os.path.expanduser("~"))]),
        ("C:\\icons\\dog.svg", [File("C:\\icons\\dog.svg")]),
        ("FILE:///a/b%20c.svg#part", [File("/a/b c.svg")]),
        ("file://localhost/a.svg", [File("/a.svg")]),
        ("https://example.org/a.svg", [Elsewhere("https://example.org/a.svg")]),
        ("mdi:cat\nmdi:cat", [Reference("mdi:cat")]),
        ("mdi:cat\na dog", []),
        ("mdi:cat\n" * 200, [Reference("mdi:cat")]),
        ("mdi:cat\n" * 201, []),
        ("", []),
    ],
)
def test_each_line_names_something_or_nothing_is_named(text, named):
    assert list(named_in(text)) == named
