"""Fits the weights by which plausible results are told from others (see ``features``)."""
