"""Iconstudio: new icons out of parts of real ones.

An implementation of *Data-Driven Iconification* (Liu, Agarwala, Lu and
Rusinkiewicz). Data flows one way: ``library`` and ``algorithms`` stand on
``model``; ``workflows`` join the algorithms; ``session`` joins workflows and
library; ``cli`` and ``gui`` show what comes out.
"""

import os

# Before NumPy is imported: threads of its own that wait for each other while the worker processes
# need the cores make matrix products ten times slower.
os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")

__version__ = "0.4.0"
