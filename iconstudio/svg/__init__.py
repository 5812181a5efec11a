"""SVG from outside: decoded, understood, made plain, checked and drawn.

Everything here may meet hostile input: it runs in worker processes with limits of time and memory.
"""
