"""Exact minimum cuts of grids."""
