"""Montage (section 4.4): the scribbled parts of icons are joined."""
