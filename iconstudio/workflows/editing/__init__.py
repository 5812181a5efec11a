"""Editing (section 4.2): one part of an icon is changed, the rest stays."""
