"""Pictogram editing in the window (section 4.2)."""
