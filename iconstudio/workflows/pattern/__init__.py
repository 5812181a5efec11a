"""Patterns by example: *Art Pattern Synthesis Using Level Sets*."""
