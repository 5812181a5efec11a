from iconstudio.gui.theme.elided import ElidedLabel


def test_a_long_text_ends_in_an_ellipsis_and_comes_back(qtbot):
    label = ElidedLabel("fluent-emoji-high-contrast:motorcycle")
    qtbot.addWidget(label)
    label.resize(90, 20)
    label.show()
    assert label.text().endswith("…")
    assert label.fontMetrics().horizontalAdvance(label.text()) <= 90
    label.resize(900, 20)
    assert label.text() == "fluent-emoji-high-contrast:motorcycle"


def test_a_link_keeps_its_address_and_is_escaped(qtbot):
    label = ElidedLabel("a<b", "https://example.org/?a=1&b='2'")
    qtbot.addWidget(label)
    label.resize(300, 20)
    label.show()
    assert "a&lt;b" in label.text()
    assert "https://example.org/?a=1&amp;b=&#x27;2&#x27;" in label.text()


def test_the_end_is_cut_last(qtbot):
    label = ElidedLabel("An author with a very long name", tail=" · CC-BY-SA-4.0")
    qtbot.addWidget(label)
    label.resize(150, 20)
    label.show()
    assert label.text().startswith("An") and label.text().endswith("… · CC-BY-SA-4.0")
    assert label.fontMetrics().horizontalAdvance(label.text()) <= 150
    label.resize(60, 20)
    assert label.fontMetrics().horizontalAdvance(label.text()) <= 60
    assert label.accessibleName() == "An author with a very long name · CC-BY-SA-4.0"
