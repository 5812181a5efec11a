"""Sketch-based modelling (section 4.1): from a rough polygon to remixed icons."""
