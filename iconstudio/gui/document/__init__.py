"""What lies on a canvas, and how it is undone and kept."""
