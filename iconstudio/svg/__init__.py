"""SVG from outside: decoded, understood, made plain and black, checked and drawn.

All of it may meet hostile input: it runs in worker processes with limits of time and memory.

``decode`` (bytes) -> ``parse`` (elements) -> ``plain`` (``animation``, ``styles``, ``references``,
``placing``) -> ``monochrome`` (``near``, ``fitting``, ``strokes``) -> ``reading`` (a pictogram).
``check`` guards ``resvg``, the renderer; ``rasterise`` brings a pictogram onto the canvas.
"""
