"""Icons as the packages of icon sets hold them, as data."""

import json

import pytest

from iconstudio.model import SpriteError
from iconstudio.svg.reading import own_svg
from tests.svg.pictures import OUTLINE, ROOF, assert_shows

SOLID = f'<path d="{ROOF}"/>'
LINES = f'<path fill="none" stroke="#000" stroke-width="2" stroke-linejoin="round" d="{ROOF}"/>'
NODE = ["path", {"d": ROOF, "key": "a"}]
CHILD = {"tag": "path", "attr": {"d": ROOF}, "child": []}
TREE = {"tag": "svg", "attr": {"viewBox": "0 0 24 24"}, "child": [CHILD]}
LINE = {"fill": "none", "stroke-width": 2}

AS_DATA = {
    "path data": (ROOF, SOLID),
    "a constant": (f'export const mdiHome = "{ROOF}";', SOLID),
    "a constant of CommonJS": (f"exports.mdiHome = '{ROOF}';", SOLID),
    "Iconify's icon": (json.dumps({"body": SOLID, "width": 24}), SOLID),
    "Iconify's icon in code": (
        f"const data = {{ width: 24, height: 24, body: '{SOLID}' }};\nexport default data;",
        SOLID,
    ),
    "Iconify's set of one": (
        json.dumps({"prefix": "a", "icons": {"b": {"body": SOLID}}, "width": 24, "height": 24}),
        SOLID,
    ),
    "Font Awesome": (
        "export const faHouse = { prefix: 'fas', iconName: 'house', "
        f'icon: [24, 24, [], "f015", "{ROOF}"] }};',
        SOLID,
    ),
    "Font Awesome of two tones": (
        json.dumps({"iconName": "a", "icon": [24, 24, [], "f015", ["M4 20h1v1h-1z", ROOF]]}),
        SOLID,
    ),
    "Lucide's nodes": (json.dumps([NODE]), LINES),
    "Lucide's code": (
        f'const __iconNode = [["path", {{ d: "{ROOF}", key: "a" }}]];\n'
        'const House = createLucideIcon("house", __iconNode);',
        LINES,
    ),
    "a root of nodes": (
        json.dumps(["svg", {"viewBox": "0 0 24 24", "stroke": "#000", **LINE}, [NODE]]),
        OUTLINE,
    ),
    "react-icons": (
        "export function AiHome (props) {\n  return GenIcon("
        f"{json.dumps(TREE)})(props);\n}}",
        SOLID,
    ),
    "Simple Icons": (json.dumps({"title": "Home", "slug": "home", "path": ROOF}), SOLID),
}  # fmt: skip


@pytest.mark.parametrize("kind", AS_DATA)
def test_icons_as_data_are_drawn(kind):
    data, expected = AS_DATA[kind]
    assert_shows(data, expected)


SEVERAL = {
    "constants": f'export const mdiA = "M1 1h9v9z";\nexport const mdiHome = "{ROOF}";',
    "a set": json.dumps(
        {"icons": {"mdiA": {"body": "<path d='M0 0'/>"}, "mdiHome": {"body": SOLID}}, "width": 24}
    ),
    "nodes": json.dumps({"mdiA": [NODE], "mdiHome": [NODE]}),
}


@pytest.mark.parametrize("kind", SEVERAL)
def test_several_icons_are_a_sprite_sheet(kind):
    data = SEVERAL[kind].encode()
    with pytest.raises(SpriteError) as caught:
        own_svg(data, "icons.js")
    assert caught.value.names == ("mdiA", "mdiHome")
    assert "<path" in own_svg(data, "icons.js", "mdiHome").svg
