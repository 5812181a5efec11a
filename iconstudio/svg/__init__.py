"""SVG from outside: decoded, understood, made plain and black, checked and drawn.

All of it may meet hostile input: it runs in worker processes with limits of time and memory.

``decode`` (bytes) -> ``markup`` (``components``, ``android``; ``signatures``: what is no SVG) ->
``parse`` (elements; ``lenient``, ``names``) -> ``plain`` (``animation``, ``styles``, ``embedding``,
``sprites``, ``references``, ``shadows``, ``placing``, ``repeats``, ``unscaled``, ``clipping``) ->
``monochrome`` (``near``, ``fitting``, ``strokes``) -> ``reading`` (a pictogram).
``lines`` are those of a pictogram's own shapes (``shapes``, ``ink``), or traced.
``check`` guards ``resvg``, the renderer; ``rasterise`` brings a pictogram onto the canvas.
"""
