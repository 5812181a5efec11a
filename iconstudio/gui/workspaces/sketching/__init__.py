"""Sketch-based modelling in the window (section 4.1)."""
