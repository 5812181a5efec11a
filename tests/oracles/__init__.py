"""Slow and obvious ways of doing what the program does, to compare it with."""
