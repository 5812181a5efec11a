"""The files and pictures that a run leaves behind."""
