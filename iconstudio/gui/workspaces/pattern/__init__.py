"""Patterns by example in the window (*Art Pattern Synthesis Using Level Sets*)."""
