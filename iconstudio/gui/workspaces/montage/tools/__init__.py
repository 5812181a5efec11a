"""What the pointer does on the canvas of a montage."""
