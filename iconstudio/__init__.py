"""Iconstudio: new icons out of parts of real ones.

An implementation of *Data-Driven Iconification* (Liu, Agarwala, Lu and
Rusinkiewicz). Data flows one way: ``library`` and ``algorithms`` stand on
``model``; ``workflows`` join the algorithms; ``session`` joins workflows and
library; ``cli`` and ``gui`` show what comes out.
"""

__version__ = "0.2.0"
