"""Data-Driven Iconification: each section of the paper is a module that cites it."""
