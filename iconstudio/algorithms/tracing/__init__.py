"""From bitmaps and points to smooth curves."""
