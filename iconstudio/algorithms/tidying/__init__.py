"""Puts right what a seam between sources brought about, as a designer would."""
