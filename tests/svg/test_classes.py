"""Classes without rules in the file are told where they would show, and only there."""

import pytest

from iconstudio.svg import colours, tailwind
from iconstudio.svg.reading import own_svg
from tests.svg.pictures import BODY, WINDOW, ink, overlap, read, svg

HOUSE, PANE = f'<path{{}} d="{BODY}"/>', f'<path{{}} d="{WINDOW}"/>'
LINES = 'fill="none" stroke="currentColor" stroke-width="2"'
READ = {
    "fill-none stroke-current stroke-2": 'fill="none" stroke="#000" stroke-width="2"',
    "fill-transparent stroke-black stroke-[1.5px]": 'fill="none" stroke="#000" stroke-width="1.5"',
    "stroke-[#00f] stroke-[3] fill-none": 'fill="none" stroke="#00f" stroke-width="3"',
    "stroke-none fill-current": "",
}
MISSED = {
    "stroke-brand-500": ' class="stroke-brand-500"',
    "stroke-primary": ' class="fill-none stroke-primary stroke-2"',
    "cls-1": ' class="cls-1"',
    "st0": ' class="st0"',
}


@pytest.mark.parametrize("names", READ)
def test_plain_classes_are_read(names):
    right = ink(svg(HOUSE.format(""), f'viewBox="0 0 24 24" {READ[names]}'))
    for document in (
        svg(HOUSE.format(f' class="h-6 {names}"')),
        svg(HOUSE.format(""), f'viewBox="0 0 24 24" class="{names}"'),
    ):
        assert read(document).remarks == ()
        assert overlap(ink(document), right) > 0.99


@pytest.mark.thorough
def test_a_white_pane_is_paper():
    body = HOUSE.format(' class="{}"') + PANE.format(' class="fill-white"')
    for house in ("fill-current", "fill-black"):
        document = svg(body.format(house))
        assert read(document).remarks == ()
        assert not ink(document)[154, 128]


@pytest.mark.parametrize(
    "stronger",
    ['<style>path{fill:#000}</style><path{} class="fill-none" d="BODY"/>',
     '<path fill="#000" class="fill-none" d="BODY"/>',
     '<path style="fill:#000" class="fill-none" d="BODY"/>'],
)  # fmt: skip
def test_what_the_document_says_itself_is_stronger(stronger):
    document = svg(stronger.replace("BODY", BODY).replace("{}", ""))
    assert overlap(ink(document), ink(svg(HOUSE.format("")))) > 0.99


PALETTE = {
    "red-500": "#ef4444", "amber-400": "#fbbf24", "slate-800": "#1e293b", "blue-600": "#2563eb",
    "emerald-300": "#6ee7b7", "gray-200": "#e5e7eb", "stone-950": "#0c0a09", "pink-100": "#fce7f3",
    "yellow-500": "#eab308", "zinc-500": "#71717a", "violet-900": "#4c1d95", "sky-50": "#f0f9ff",
}  # fmt: skip
FAR = 30
"""Levels of sRGB."""


@pytest.mark.parametrize("name", PALETTE)
def test_the_colours_of_the_palette_are_nearly_right(name):
    near = colours.colour(tailwind.colour(name))
    near, right = (bytes.fromhex(one[1:7]) for one in (near, PALETTE[name]))
    assert max(abs(a - b) for a, b in zip(near, right, strict=True)) <= FAR


@pytest.mark.thorough
def test_what_is_of_the_palette_is_drawn_though_all_else_is_not():
    body = HOUSE.format(' class="fill-amber-400"') + PANE.format(' class="fill-slate-800"')
    document = svg(body, 'viewBox="0 0 24 24" fill="none"')
    painted = HOUSE.format(' fill="#fbbf24"') + PANE.format(' fill="#1e293b"')
    assert read(document).remarks == read(svg(painted)).remarks
    assert overlap(ink(document), ink(svg(painted))) > 0.99


def test_a_line_of_a_colour_that_is_not_known_is_drawn():
    document = svg(HOUSE.format(MISSED["stroke-primary"]))
    right = svg(HOUSE.format(' fill="none" stroke="#000" stroke-width="2"'))
    assert overlap(ink(document), ink(right)) > 0.99


@pytest.mark.parametrize("name", MISSED)
def test_a_class_that_nothing_else_stands_for_is_told(name):
    for document in (
        svg(HOUSE.format(MISSED[name])),
        svg(HOUSE.format(""), f'viewBox="0 0 24 24" {MISSED[name]}'),
    ):
        (remark,) = (one for one in read(document).remarks if "no rules" in one)
        assert f"“{name}”" in remark


@pytest.mark.parametrize(
    ("one", "other"),
    [("fill-brand-500", "fill-[#00f]"), ("fill-primary", ""), ("fill-current", "fill-brand-50")],
)
def test_fills_that_differ_are_told(one, other):
    body = HOUSE.format(f' class="{one}"') + PANE.format(f' class="{other}"')
    assert "no rules" in read(svg(body)).remarks[0]


@pytest.mark.thorough
def test_the_faint_ring_of_a_spinner_is_read():
    spinner = (
        f'<circle {{}} cx="12" cy="12" r="10" {LINES}/>'
        '<path fill="currentColor" d="M4 12a8 8 0 018-8V0C5.4 0 0 5.4 0 12z"/>'
    )
    one, other = (svg(spinner.format(f)) for f in ('class="opacity-25"', 'opacity=".25"'))
    assert read(one).svg == read(other).svg
    assert read(one).remarks == read(other).remarks


def test_classes_of_code_are_told():
    code = (
        f'export default () => <svg className="fill-none stroke-primary">{HOUSE.format("")}</svg>'
    )
    assert "no rules" in own_svg(code.encode(), "house.jsx").remarks[0]


ORDINARY = {
    "lucide": f'class="lucide lucide-house" {LINES}',
    "feather": f'class="feather feather-home" {LINES}',
    "bootstrap": 'class="bi bi-house-fill" fill="currentColor"',
    "font awesome": 'class="svg-inline--fa fa-house fa-w-16" aria-hidden="true"',
    "tabler": f'class="icon icon-tabler icon-tabler-home stroke-2" {LINES}',
    "heroicons": f'class="size-6 stroke-current fill-none" {LINES}',
    "zondicons": 'class="fill-current text-teal-500 inline-block h-12 w-12"',
    "one colour": 'class="h-5 fill-indigo-600"',
    "dark": 'class="fill-black dark:fill-white hover:stroke-2"',
    "material": 'class="MuiSvgIcon-root MuiSvgIcon-fontSizeMedium css-vubbuv" focusable="false"',
    "octicons": 'class="octicon octicon-home" fill="currentColor"',
    "phosphor": 'class="ph ph-house-fill" fill="#000000"',
    "remix": 'class="remixicon h-6 w-6 ri-home-fill" fill="currentColor"',
    "iconfont": 'class="icon" p-id="2351" fill="#d81e06"',
    "carbon": 'class="bx--btn__icon" fill="currentColor"',
    "ruled": 'class="st0 cls-1 fill-none"',
    "same as attributes": 'class="cls-1 fill-red-500 opacity-50" opacity="1" fill="#f00"',
}
RULES = "<style>.st0,.cls-1{fill:#111}.fill-none{stroke:none}</style>"


@pytest.mark.parametrize("kind", ORDINARY)
def test_ordinary_classes_are_not_told(kind):
    document = svg(RULES + HOUSE.format(' class="a"'), f'viewBox="0 0 24 24" {ORDINARY[kind]}')
    if kind != "ruled":
        document = document.replace(RULES, "")
    assert read(document).remarks == ()


def test_rules_with_escaped_names_are_found():
    rules = r"<style>.fill-\[\#f00\]{fill:#f00}.stroke-1\.5{stroke-width:1.5}</style>"
    body = HOUSE.format(' class="fill-[#f00]"') + PANE.format(' class="stroke-1.5" stroke="#f00"')
    assert not any("no rules" in one for one in read(svg(rules + body)).remarks)
