"""Pictogram montage in the window (section 4.4)."""
