"""Pictogram hybrids in the window (section 4.3)."""
