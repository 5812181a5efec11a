"""The page of line styles: lines, the style that they take, and which lines are selected."""

from dataclasses import dataclass, field, replace

from iconstudio.inputs.line_style import check_style, with_widths
from iconstudio.model import Line, LineStyle, Pictogram, Restyling, StylePair
from iconstudio.workflows.line_style.restyling import LARGEST, SMALLEST, STRONGEST, WEAKEST
from iconstudio.workflows.pages import Document

OWN = "My style"
"""The name of a style that is being drawn."""
WIDTH = 14.0
"""Of strokes that are drawn freehand, in canvas units; at a pen's full pressure."""


@dataclass(frozen=True, slots=True)
class RestylePage:
    """What is restyled, and how."""

    work: Restyling = field(default_factory=Restyling)
    selected: frozenset[int] = frozenset()
    """The lines that a style is chosen for, by number; all if there are none."""

    @property
    def empty(self) -> bool:
        """Whether there are neither lines nor a style."""
        return self == RestylePage()

    @property
    def has_lines(self) -> bool:
        """Whether there is something to restyle."""
        return self.work.icon is not None or bool(self.work.strokes)

    @property
    def complete(self) -> bool:
        """Whether there are lines, and a style for all of them."""
        return self.has_lines and self.work.style is not None

    @property
    def style(self) -> LineStyle | None:
        """The style of the selected lines, or of most."""
        others = dict(self.work.others)
        return next((others[n] for n in sorted(self.selected) if n in others), self.work.style)

    @property
    def styles(self) -> tuple[LineStyle, ...]:
        """All styles in use."""
        some = (self.work.style, *(style for _, style in self.work.others))
        return tuple(dict.fromkeys(style for style in some if style is not None))

    @property
    def drawn(self) -> LineStyle | None:
        """The style that is being drawn, if it is."""
        style = self.style
        return style if style is not None and style.name == OWN else None

    def elsewhere(self, before: "RestylePage") -> bool:
        """Whether so much differs from ``before`` that the view should be fitted anew."""
        return self.work.icon != before.work.icon


RestyleDocument = Document[RestylePage]


def take_icon(document: RestyleDocument, icon: Pictogram) -> None:
    """Restyle the lines of another icon; strokes that were drawn stay."""
    work = replace(document.page.work, icon=icon, others=())
    document.change("choose icon", RestylePage(work))


def styled(page: RestylePage, style: LineStyle) -> Restyling:
    """Return the work with a style for the selected lines, or for all."""
    work = page.work
    if not page.selected or work.style is None:
        return replace(work, style=style, others=())
    others = dict(work.others) | dict.fromkeys(page.selected, style)
    some = tuple((n, others[n]) for n in sorted(others) if others[n] != work.style)
    return replace(work, others=some)


def set_style(document: RestyleDocument, style: LineStyle) -> None:
    """Choose a style for the selected lines, or for all."""
    _put(document, "choose style", styled(document.page, style))


def with_example(page: RestylePage, pair: StylePair) -> LineStyle:
    """Return the style that is being drawn with one more example.

    One of the other kind, with a plain stroke or without, begins another style. What a mouse draws
    beside what a pen does has the same width all along.

    Raises
    ------
    IconstudioError
        If nothing can be learned from it.
    """
    drawn = page.drawn
    kept = () if drawn is None or bool(drawn.pairs[0].plain) != bool(pair.plain) else drawn.pairs
    style = LineStyle(OWN, with_widths((*kept, pair)))
    check_style(style)
    return style


def add_example(document: RestyleDocument, pair: StylePair) -> None:
    """Draw an example of a style: see ``with_example``."""
    page = document.page
    _put(document, "draw example", styled(page, with_example(page, pair)))


def clear_example(document: RestyleDocument) -> None:
    """Draw the example anew."""
    page, work = document.page, document.page.work
    drawn = page.drawn
    if drawn is not None:
        style = None if work.style == drawn else work.style
        others = tuple((n, one) for n, one in work.others if style and one != drawn)
        _put(document, "clear example", replace(work, style=style, others=others))


def add_stroke(document: RestyleDocument, line: Line) -> None:
    """Draw a line freehand."""
    _change(document, "draw line", strokes=(*document.page.work.strokes, line))


def remove_strokes(document: RestyleDocument, first: int) -> None:
    """Remove those selected lines that were drawn; ``first`` is the number of the first of these.

    Lines of the icon stay.
    """
    page, work = document.page, document.page.work
    removed = {number for number in page.selected if number >= first}
    if not removed:
        return
    count = first + len(work.strokes)
    kept = [number for number in range(count) if number not in removed]
    numbers = {number: place for place, number in enumerate(kept)}
    strokes = tuple(work.strokes[number - first] for number in kept if number >= first)
    others = tuple((numbers[n], style) for n, style in work.others if n in numbers)
    work = replace(work, strokes=strokes, others=others)
    document.change("remove lines", RestylePage(work))


def clear_lines(document: RestyleDocument) -> None:
    """Remove all lines, and the icon."""
    work = replace(document.page.work, icon=None, strokes=(), others=())
    document.change("remove lines", RestylePage(work))


def select(document: RestyleDocument, lines: frozenset[int]) -> None:
    """Select lines; that is no edit."""
    document.show(replace(document.page, selected=lines))


def set_strength(document: RestyleDocument, strength: float, gesture: object = None) -> None:
    """Set how far lines go from the plain ones."""
    value = min(max(strength, WEAKEST), STRONGEST)
    _change(document, "change strength", gesture, strength=value)


def set_size(document: RestyleDocument, size: float, gesture: object = None) -> None:
    """Set how large the texture is."""
    _change(document, "change size", gesture, size=min(max(size, SMALLEST), LARGEST))


def set_seed(document: RestyleDocument, seed: int, gesture: object = None) -> None:
    """Set what random choices depend on."""
    _change(document, "change seed", gesture, seed=seed)


def take_over(document: RestyleDocument, strength: float, seed: int) -> None:
    """Set strength and seed, as those of a variation."""
    _change(document, "use variation", strength=strength, seed=seed)


def set_turning(document: RestyleDocument, turning: bool | None) -> None:
    """Let the style turn with the line, or not; None as it says itself."""
    _change(document, "turn with the line", turning=turning)


def _change(document: RestyleDocument, text: str, gesture: object = None, **fields: object) -> None:
    work = replace(document.page.work, **fields)  # type: ignore[arg-type]  # as their callers say
    _put(document, text, work, gesture)


def _put(document: RestyleDocument, text: str, work: Restyling, gesture: object = None) -> None:
    if work != document.page.work:
        document.change(text, replace(document.page, work=work), gesture)
