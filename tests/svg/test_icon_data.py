"""Icons as the packages of icon sets hold them, as data."""

import json

import pytest

from iconstudio.model import IconstudioError, SpriteError
from iconstudio.svg.reading import own_svg
from tests.svg.pictures import OUTLINE, ROOF, assert_shows, read

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


STROKED = f'("path", {{ fill: "none", stroke: "#000", strokeWidth: 2, d: "{ROOF}" }})'
PAGE = 'viewBox: "0 0 24 24"'
CREATED = {
    "React": f'return React.createElement("svg", Object.assign({{ {PAGE}, ref: r }}, p), t ? '
    f'React.createElement("title", null, t) : null, React.createElement{STROKED});',
    "React's runtime": f'const A = (p) => _jsxs("svg", {{ {PAGE}, ...p, children: '
    f'[t && _jsx("title", {{}}), _jsx{STROKED}] }});',
    "a runtime of CommonJS": "exports.default = (0, _create.default)( /*#__PURE__*/(0, _rt.jsx)"
    f'{STROKED}, "Home");',
    "a list of shapes": f'x(f, [(0, r.jsx){STROKED}, (0, r.jsx)("path", {{ d: "M2 2h0" }}, "1")]);',
    "a fragment": 'const a = new Map([["bold", e.createElement(e.Fragment, null, '
    f"e.createElement{STROKED})]]);",
    "Vue": f"const p = {{ {PAGE} }}, c = createElementVNode{STROKED};"
    'function render(_, k) { return (openBlock(), createElementBlock("svg", p, [c])); }',
    "Vue's cache": f'return createElementBlock("svg", {{ {PAGE} }}, [...(k[0] || (k[0] = '
    f"[createElementVNode{STROKED}]))]);",
    "a function of one letter": f'export default p => h("svg", {{ {PAGE} }}, h("g", null, '
    f"h{STROKED}))",
}  # fmt: skip


@pytest.mark.parametrize("kind", CREATED)
def test_elements_that_code_creates_are_drawn(kind):
    assert_shows(CREATED[kind], OUTLINE)


def test_a_shape_that_code_computes_is_not_left_out_in_silence():
    code = (
        'h("svg", { viewBox: "0 0 24 24" }, h("path", { d: "M4 4h9v9z" }), h("path", { d: f() }))'
    )
    with pytest.raises(IconstudioError, match="cannot be read"):
        read(f"export default p => {code}")


def test_icons_of_several_weights_are_told_apart():
    of_weight = (
        '["{}", e.createElement(e.Fragment, null, e.createElement("path", {{ d: "M4 4h9v9z" }}))]'
    )
    code = f"const a = new Map([{of_weight.format('bold')}, {of_weight.format('thin')}]);"
    with pytest.raises(SpriteError) as told:
        read(code)
    assert told.value.names == ("bold", "thin")


def test_a_document_in_code_may_hold_what_stands_beside_it():
    """As Simple Icons have it."""
    inner = '<svg viewBox="0 0 24 24"><path d="${this.path}"/></svg>'
    assert_shows(f"export const a = {{ get svg() {{ return `{inner}` }}, path: '{ROOF}' }};", SOLID)


def test_code_is_called_what_it_is():
    with pytest.raises(IconstudioError) as told:
        read("struct A: Shape { func path(in r: CGRect) -> Path { var p = Path(); return p } }")
    assert "React" not in str(told.value)


def test_a_function_in_php_repeats_nothing():
    drawing = f'<svg viewBox="0 0 24 24"><path d="<?= $d ?>"/>{SOLID}</svg>'
    remarks = read(f"<?php function icon(){{ ?>{drawing}<?php }} ?>").remarks
    assert len(remarks) == 1 and "$d" in remarks[0]


def test_bodies_without_a_root_are_drawn_as_their_set_is():
    """As Feather has them: lines where some of the set are but lines."""
    body = f'<path d="{ROOF}"></path>'
    assert_shows(json.dumps({"home": body}), SOLID)
    with pytest.raises(SpriteError) as told:
        read(json.dumps({"home": body, "minus": '<line x1="5" y1="12" x2="19" y2="12"></line>'}))
    assert told.value.names == ("home", "minus")
    lone = json.dumps({"minus": '<line x1="5" y1="12" x2="19" y2="12"></line>'})
    assert_shows(lone, '<path stroke="#000" stroke-width="2" stroke-linecap="round" d="M5 12h14"/>')


@pytest.mark.parametrize(
    "code",
    [
        'const Svg = styled.svg`stroke: #000;`; const A = () => <Svg viewBox="0 0 24 24">{}</Svg>',
        'const A = () => <svg className={{styles.a}} viewBox="0 0 24 24">{}</svg>',
        '<svg class="a" viewBox="0 0 24 24">{}</svg>',
    ],
)
def test_lines_whose_styles_lie_elsewhere_are_told(code):
    (remark,) = read(code.format('<path d="M4 12h16M12 4v16"/>')).remarks
    assert "elsewhere" in remark
