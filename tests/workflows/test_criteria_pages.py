"""What is left out and what is brought in is part of the page, as it is of files."""

from typing import Any

import pytest

from iconstudio.model import Axis, Sketch
from iconstudio.workflows.editing.page import EditPage
from iconstudio.workflows.editing.page_format import EditPages
from iconstudio.workflows.editing.spec import EDITING
from iconstudio.workflows.modelling.file import SketchFile
from iconstudio.workflows.modelling.page import SketchPage
from iconstudio.workflows.modelling.page_format import SketchPages
from iconstudio.workflows.modelling.spec import MODELLING

OUT, IN = frozenset({"a:out"}), frozenset({"a:in"})


@pytest.mark.parametrize(
    ("pages", "empty"), [(SketchPages(MODELLING), SketchPage()), (EditPages(EDITING), EditPage())]
)
def test_a_page_is_read_as_it_was_written(pages: Any, empty: Any):
    page = empty.with_criteria(keyword="dog", exclude=OUT, include=IN, symmetry=Axis.VERTICAL)
    steps = pages.read(pages.write(page, None), None)
    while True:
        try:
            next(steps)
        except StopIteration as end:
            assert end.value == page
            break


def test_a_file_names_what_was_brought_in():
    sketch = Sketch(keyword="dog", exclude=OUT, include=IN)
    file = SketchFile.of(sketch, str)
    assert (file.exclude, file.include) == (OUT, IN)
    assert file.sketch.include == IN
