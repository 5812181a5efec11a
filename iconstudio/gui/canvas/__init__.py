"""The canvas: where the object is traced."""
