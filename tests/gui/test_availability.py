"""Where no window can open, that is said, whatever Qt is told by the environment."""

import pytest

from iconstudio.gui.window import availability


@pytest.fixture(autouse=True)
def nothing_is_told(monkeypatch):
    for name in ("QT_QPA_PLATFORM", "DISPLAY", "WAYLAND_DISPLAY", "XDG_RUNTIME_DIR"):
        monkeypatch.delenv(name, raising=False)


@pytest.mark.parametrize(
    ("told", "said"),
    [
        ({}, "There is no screen"),
        ({"QT_QPA_PLATFORM": ""}, "There is no screen"),
        ({"QT_QPA_PLATFORM": "  "}, "Unset it"),
        ({"QT_QPA_PLATFORM": "nonsense"}, "QT_QPA_PLATFORM=nonsense. Unset it"),
        ({"QT_QPA_PLATFORM": "wayland"}, "QT_QPA_PLATFORM=wayland. Unset it"),
        ({"QT_QPA_PLATFORM": "xcb"}, "There is no screen (DISPLAY is not set)"),
        ({"DISPLAY": ":7654"}, "screen “:7654” (DISPLAY) does not answer"),
        ({"WAYLAND_DISPLAY": "nowhere"}, "screen “nowhere” (WAYLAND_DISPLAY) does not answer"),
    ],
)
def test_what_stands_in_the_way_is_said(monkeypatch, told, said):
    monkeypatch.setattr(availability, "missing_library", lambda: None)
    for name, value in told.items():
        monkeypatch.setenv(name, value)
    assert said in availability.obstacle()


@pytest.mark.parametrize("platform", ["offscreen", "minimal", "minimal:enable_fonts"])
def test_a_window_that_nobody_sees_opens_anywhere(monkeypatch, platform):
    monkeypatch.setenv("QT_QPA_PLATFORM", platform)
    assert availability.obstacle() is None
