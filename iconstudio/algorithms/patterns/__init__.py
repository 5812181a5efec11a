"""Example-Based Art Pattern Synthesis Using Level Sets (Wu, Wang and Yu)."""
