"""Drawings in code, and in markup that is not well-formed: the right picture, or the reason."""

import json

import pytest

from iconstudio.model import IconstudioError
from tests.svg.pictures import BODY, HOUSE, OUTLINE, PATH, ROOF, WINDOW, assert_shows, read, svg

pytestmark = pytest.mark.thorough(but=1)

BOX = 'viewBox="0 0 24 24"'
LINE = f'<path d="{ROOF}"/>'
STROKED = f'{BOX} fill="none" stroke="#000"'

AS_THE_OUTLINE = {
    "JSX": (
        "import * as React from 'react';\n"
        "export default function Icon({ title, ...props }: Props) {\n  return (\n"
        f'<svg {BOX} className="icon" fill="none" stroke="currentColor" strokeWidth={{2}}'
        ' strokeLinejoin="miter" aria-hidden {...props} onClick={() => { if (a > b) go("}"); }}>\n'
        "{/* don't draw <path/> */}{title ? <title>{title}</title> : null}"
        f"<path d={{`{ROOF}`}} key={{1}} />\n</svg>\n  );\n}}\n"
    ),
    "JSX with a style": (
        f'<svg {BOX}><path style={{{{ fill: "none", strokeWidth: 2, stroke: "#000" }}}}'
        f' d="{ROOF}" /></svg>'
    ),
    "JSX with values by default": (
        'const Icon = ({ size = 24, color = "#000", strokeWidth = 2 }) => (\n'
        f'<svg width={{size}} height={{size}} {BOX} stroke={{color}} fill={{"none"}}'
        f" strokeWidth={{strokeWidth}}>{LINE}</svg>);"
    ),
    "JSX with an alternative": f'<svg {BOX} fill="none" stroke={{p.color || "#000"}}'
    f" strokeWidth={{p.width ?? 2}}>{LINE}</svg>",
    "well-formed copy": f'<svg {STROKED} strokeWidth="2" className="a">{LINE}</svg>',
    "style in a string": f"<svg {BOX}><style>{{`.a{{fill:none;stroke:#000;stroke-width:2}}`}}"
    f'</style><path className="a" d="{ROOF}"/></svg>',
    "Vue": (
        f'<!-- An icon --><template>\n  <svg {STROKED} :class="{{ big: a > 1 }}"'
        f' @click="$emit(\'x\')" v-if="shown" v-bind="$attrs" :stroke-width="2">'
        f"<title>{{{{ title }}}}</title>"
        f'<path d="{ROOF}" v-bind:key="1"/><slot/></svg>\n</template>\n<script setup>\n'
        "defineProps({ title: String })\n</script>"
    ),
    "Svelte": (
        "<script>\n  export let width = 2;\n</script>\n"
        f'<svg {STROKED} class="{{$$props.class}}" stroke-width={{width}} {{...$$restProps}}'
        f" on:click>{{#if title}}<title>{{title}}</title>{{/if}}{LINE}</svg>"
    ),
    "Angular": f'<svg {STROKED} [attr.stroke-width]="2" [ngClass]="a" (click)="go()" *ngIf="a">'
    f"{LINE}</svg>",
    "React Native": (
        'import Svg, { Path } from "react-native-svg";\n'
        f'export const Icon = () => <Svg {BOX} fill="none"><Path stroke="#000" strokeWidth={{2}}'
        f' d="{ROOF}"/></Svg>;'
    ),
    "Android": (
        '<?xml version="1.0" encoding="utf-8"?>\n'
        '<vector xmlns:android="http://schemas.android.com/apk/res/android"'
        ' android:width="24dp" android:height="24dp" android:viewportWidth="24"'
        ' android:viewportHeight="24"><group android:pivotX="12" android:scaleX="-1"'
        ' android:rotation="0"><group android:scaleX="-1" android:translateX="24">'
        f'<path android:pathData="{ROOF}" android:strokeWidth="2"'
        ' android:strokeColor="#FF000000"/></group></group></vector>'
    ),
}


@pytest.mark.parametrize("kind", AS_THE_OUTLINE)
def test_code_is_read(kind):
    assert_shows(AS_THE_OUTLINE[kind], OUTLINE)
    assert "stroke" in read(AS_THE_OUTLINE[kind]).svg


EVENODD = f'fill-rule="evenodd" d="{HOUSE}"'
AS_THE_HOUSE = {
    "attribute twice": f'<svg {BOX} class="a" class="b"><path {EVENODD} d="M0 0h9"/></svg>',
    "no quotes": f'<svg viewBox="0 0 24 24" fill=red><path fill-rule=evenodd d="{HOUSE}"/></svg>',
    "no quotes at the end": svg(f"{PATH}<path fill=none d=M0,0h24v24/><path d=M9,9h1/>"),
    "no value": f"<svg {BOX} hidden focusable><path {EVENODD} download/></svg>",
    "less than": f'<svg {BOX} aria-label="a<b"><title>a < b & c</title>{PATH}</svg>',
    "not closed": f"<svg {BOX}><g><path {EVENODD}></svg>",
    "a shape not closed": f'<svg {BOX}><path fill-rule="evenodd" d="{BODY}{WINDOW}">'
    '<path d="M17 2h4v3h-4z"></svg>',
    "closed twice": f"<svg {BOX}><g>{PATH}</g></g></path></svg>",
    "text at the end": f"{svg(PATH)}\n// saved by hand",
    "an element at the end": f"{svg(PATH)}<br><p>a</p>",
    "two roots, of which one is closed": f"{svg(PATH)}</svg>",
    "two XML declarations": f'<?xml version="1.0"?><?xml version="1.0"?>{svg(PATH)}',
    "undefined entity": svg(f"<title>&nothing;</title>{PATH}"),
    "HTML's case": f'<SVG viewbox="0 0 24 24" a><CLIPPATH id="c"><RECT width="24" height="24"/>'
    f'</CLIPPATH><PATH clip-path="url(#c)" {EVENODD}/></SVG>',
    "style sheet with signs": f"<svg {BOX} a><style>g > path{{fill-rule:evenodd}}</style>"
    f'<g><path d="{HOUSE}"/></g></svg>',
    "Android with a clip": (
        '<vector xmlns:android="http://schemas.android.com/apk/res/android"'
        ' android:viewportWidth="24" android:viewportHeight="24">'
        '<clip-path android:pathData="M0 0h24v24H0z"/>'
        f'<path android:fillType="evenOdd" android:fillColor="#f00" android:pathData="{HOUSE}"/>'
        '<path android:fillColor="#00ffffff" android:pathData="M0 0h24v24H0z"/></vector>'
    ),
}


def styled(before, after="", attributes='class="ico"'):
    return (
        f"<!DOCTYPE html><html><head>{before}</head><body><p>Hi &nbsp;<br><svg {attributes} {BOX}>"
        f'<path d="{BODY}"/><path class=d d="{WINDOW}" /></svg>{after}</body></html>'
    )


IN_PAGES = {
    "in its head": styled("<style>.ico{fill:#ff6b6b}.ico .d{fill:#fff}</style>"),
    "in its body": styled("", "<style media=screen>p{color:red} svg .d{fill:#fff}</style>"),
    "marked as a comment": styled("<style><!-- .d{fill:#fff} --></style>"),
    "within a rule for a width": styled("<style>@media(min-width:9px){.d{fill:#fff}}</style>"),
    "by variables": styled("<style>:root{--c:#fff}</style>").replace("class=d", "fill='var(--c)'"),
    "of a component": f'<template><svg {BOX}><path d="{BODY}"/><path class="d" d="{WINDOW}"/></svg>'
    "</template><style scoped>.d{fill:white}</style>",
}


@pytest.mark.parametrize("kind", IN_PAGES)
def test_style_sheets_of_a_page_paint_its_drawing(kind):
    assert_shows(IN_PAGES[kind], PATH)


@pytest.mark.parametrize(
    "sheet",
    [
        "<!-- <style>.d{fill:#fff}</style> -->",
        "<style media=print>.d{fill:#fff}</style>",
        "<style>.nav ::-webkit-thing{x}.e{fill:#fff} @nonsense{</style>",
    ],
)
def test_style_sheets_that_say_nothing_of_a_drawing_are_left_alone(sheet):
    assert_shows(styled(sheet), f'<path d="{BODY}"/>')


@pytest.mark.parametrize("kind", AS_THE_HOUSE)
def test_what_browsers_forgive_is_read(kind):
    assert_shows(AS_THE_HOUSE[kind], PATH)


def painted(path: str, paint: str) -> str:
    """A drawing of Android whose one path is painted as an element within says."""
    return (
        '<vector xmlns:android="http://schemas.android.com/apk/res/android"'
        ' xmlns:aapt="http://schemas.android.com/aapt"'
        ' android:viewportWidth="24" android:viewportHeight="24">'
        f'<path android:fillType="evenOdd" android:pathData="{path}">'
        f'<aapt:attr name="android:fillColor">{paint}</aapt:attr></path></vector>'
    )


HALF = "".join(
    f'<item android:offset="{offset}" android:color="{colour}"/>'
    for offset, colour in (("0", "#f09"), ("0.5", "#F09"), ("0.5", "#00ff0099"))
)
PAINTED = {
    "colours that flow": (
        HOUSE,
        '<gradient android:endX="24" android:startColor="#ff3366" android:endColor="#933"/>',
        PATH,
    ),
    "linear": (
        "M0 0h24v24H0z",
        f'<gradient android:startX="4" android:endX="20">{HALF}</gradient>',
        '<path d="M0 0h12v24H0z"/>',
    ),
    "radial": (
        "M0 0h24v24H0z",
        '<gradient android:type="radial" android:centerX="8" android:centerY="12"'
        f' android:gradientRadius="12">{HALF}</gradient>',
        '<circle cx="8" cy="12" r="6"/>',
    ),
    "mirrored": (
        "M0 0h24v24H0z",
        f'<gradient android:endX="12" android:tileMode="mirror">{HALF}</gradient>',
        '<path d="M0 0h6v24H0zM18 0h6v24h-6z"/>',
    ),
}


@pytest.mark.parametrize("kind", PAINTED)
def test_gradients_of_android_are_gradients(kind):
    path, gradient, expected = PAINTED[kind]
    assert_shows(painted(path, gradient), expected)


def vector(body: str, attributes: str = "") -> str:
    """A drawing of Android."""
    return (
        '<vector xmlns:android="http://schemas.android.com/apk/res/android"'
        f' android:viewportWidth="24" android:viewportHeight="24" {attributes}>{body}</vector>'
    )


TWO_COLOURS = vector(
    f'<path android:fillType="evenOdd" android:pathData="{BODY}{WINDOW}"'
    ' android:fillColor="#fff"/>'
    '<path android:pathData="M17 2h4v3h-4z" android:fillColor="#f00"/>'
    '<path android:pathData="M0 0h24v24H0z" android:fillColor="#0f00"/>'
)


@pytest.mark.parametrize("tint", ["#123", "#ff112233", "?attr/colorControlNormal"])
@pytest.mark.parametrize("mode", ["", "src_in", "src_atop", "multiply"])
def test_a_tint_of_android_is_the_colour_of_all(tint, mode):
    said = f'android:tint="{tint}"' + (f' android:tintMode="{mode}"' if mode else "")
    document = TWO_COLOURS.replace(">", f" {said}>", 1)
    if mode == "multiply":
        document = document.replace("#f00", "#fff")
    assert_shows(document, svg(PATH))
    assert "<path" in read(document).svg and 'fill="#000000"' in read(document).svg


SAID = {
    "Android's tints": (
        TWO_COLOURS.replace(">", ' android:tint="#000" android:tintMode="screen">', 1).replace(
            "#fff", "#f00"
        ),
        "(screen) was left out",
    ),
    "Android's values elsewhere": (
        vector(
            '<group android:rotation="@integer/turn"><path android:fillType="evenOdd"'
            f' android:fillColor="#000" android:pathData="{HOUSE}"/></group>'
        ),
        "“rotation: @integer/turn” lies elsewhere",
    ),
    "cut short after a shape": (svg(PATH).removesuffix("</svg>"), "cut short"),
    "cut short within a shape": (
        svg(PATH + '<path d="M1 1h2v9').removesuffix("</svg>"),
        "cut short",
    ),
    "two drawings": (svg(PATH) + svg('<path d="M0 0h9v9z"/>'), "several drawings"),
    "path from code": (f"<svg {BOX}>{PATH}<path d={{props.d}} /></svg>", "“d: props.d”"),
    "colour from code": (
        f'<svg {BOX}><path fill={{on ? "a" : "b"}} {EVENODD}/></svg>',
        "Colours that its code chooses",
    ),
    "shape from code": (
        f"<svg {BOX}>{PATH}{{open && <circle r={{9}} />}}</svg>",
        "What its code draws",
    ),
    "shapes from code": (
        f'<svg {BOX}><g v-for="a in b">{PATH}</g></svg>',
        "drawn once",
    ),
    "Android's colours": (
        '<vector xmlns:android="http://schemas.android.com/apk/res/android"'
        ' android:viewportWidth="24" android:viewportHeight="24">'
        '<path android:fillType="evenOdd" android:fillColor="?attr/colorControlNormal"'
        f' android:pathData="{HOUSE}"/></vector>',
        "looks up elsewhere",
    ),
    "Android's sweeps": (
        painted(HOUSE, '<gradient android:type="sweep" android:startColor="#ff3366"/>'),
        "in their first colour",
    ),
    "Android's lists of colours": (
        painted(HOUSE, "<selector><item android:color='#f00'/></selector>"),
        "looks up elsewhere",
    ),
    "sheet in another file": (
        f'<?xml-stylesheet href="a.css" type="text/css"?>{svg(PATH)}',
        "style sheet outside of the file",
    ),
    "linked sheet": (
        svg(f'<link xmlns="http://www.w3.org/1999/xhtml" rel="stylesheet" href="a.css"/>{PATH}'),
        "style sheet outside of the file",
    ),
    "linked sheet without a namespace": (
        svg(f'<defs><link rel="stylesheet" href="a.css"/></defs>{PATH}'),
        "style sheet outside of the file",
    ),
}


@pytest.mark.parametrize("kind", SAID)
def test_what_is_left_out_is_told(kind):
    document, words = SAID[kind]
    assert_shows(document, PATH, remarks=(words,))


REFUSED = {
    "text": ("Dear all,\nthe icon is at a < b.\n", "a text, not a drawing"),
    "table": ("name,width\nhouse,24\n", "a text, not a drawing"),
    "Markdown": ("# Icons\n\nSee <b>there</b>, or [a](b.svg).\n", "a text, not a drawing"),
    "Git LFS": ("version https://git-lfs.github.com/spec/v1\noid sha256:a\nsize 9", "git lfs pull"),
    "web page": (
        "<!DOCTYPE html><html><head><title>404\n Not Found</title></head><p>a<br></html>",
        "a web page (“404 Not Found”)",
    ),
    "web page without a title": ("<html><body>no</body></html>", "a web page, not"),
    "PDF": (b"%PDF-1.5\n%\xe2\xe3\xcf\xd3\n1 0 obj", "a PDF"),
    "PostScript": (b"%!PS-Adobe-3.0 EPSF-3.0\n", "PostScript"),
    "PostScript with a preview": (b"\xc5\xd0\xd3\xc6\x1e\0\0\0", "PostScript"),
    "PNG": (b"\x89PNG\r\n\x1a\n\0\0\0\rIHDR", "made of pixels"),
    "JPEG": (b"\xff\xd8\xff\xe0\0\x10JFIF", "made of pixels"),
    "WebP": (b"RIFF\x24\0\0\0WEBPVP8 ", "made of pixels"),
    "Lottie": (json.dumps({"v": "5", "fr": 30, "layers": []}), "Lottie"),
    "Excalidraw": (json.dumps({"type": "excalidraw"}), "Excalidraw"),
    "JSON": ('{"a": 1', "holds data (JSON)"),
    "ZIP": (b"PK\x03\x04\x14\0\0\0icons/a.svg", "archive (ZIP)"),
    "Sketch": (b"PK\x03\x04\x14\0\0\0document.json..pages/1.json", "file of Sketch"),
    "Figma": (b"fig-kiwi\x0f\0\0\0", "file of Figma"),
    "draw.io": ('<mxfile host="a"><diagram>x</diagram></mxfile>', "draw.io"),
    "font": (b"wOF2\0\1\0\0", "is a font"),
    "components": (
        "import SvgIcon from './SvgIcon';\nexport default createIcon(<path d='M0 0h9v9z'/>, 'A');",
        "code of a program",
    ),
    "compiled code": ('"use strict";var a=jsx("svg",{children:b})', "code of a program"),
    "Android's animation": (
        '<animated-vector xmlns:android="http://schemas.android.com/apk/res/android"'
        ' android:drawable="@drawable/a"><target android:name="b"/></animated-vector>',
        "in another file",
    ),
    "cut short at once": ('<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0', "well-formed"),
    "cut short before a shape": (
        '<svg xmlns="http://www.w3.org/2000/svg"><path d="M1',
        "cut short",
    ),
}


@pytest.mark.parametrize("kind", REFUSED)
def test_what_is_no_drawing_is_called_by_its_name(kind):
    document, words = REFUSED[kind]
    with pytest.raises(IconstudioError) as caught:
        read(document, "a.svg")
    assert words in str(caught.value)
    assert str(caught.value).startswith("“a.svg” cannot be used. ")
    assert str(caught.value).endswith(".")
