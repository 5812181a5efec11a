"""Collections of icons: built, opened, searched and rasterised."""
