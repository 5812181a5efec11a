"""Compiled functions: the adapter of numba.

Importing it takes a third of a second, and the first call of a function some seconds to compile,
once: the result is kept beside the source, or in the user's cache folder if that cannot be written
(``NUMBA_CACHE_DIR`` names another). So only processes that cut import this.
"""

import os
from contextlib import chdir

with chdir(os.path.dirname(__file__)):  # numba looks for settings in the current folder,
    from numba import njit, types
    from numba.core import config
    from numba.extending import intrinsic
config._config_fname = os.devnull  # and does so again each time that it compiles

part = njit(nogil=True)
"""A function that only compiled functions call. One that has no cache of its own."""
inner = njit(nogil=True, inline="always")
"""The same, written out where it is called: arguments that are arrays would cost time there."""


def entry(function):
    """Compile a function that Python calls; it runs without the interpreter lock."""
    try:
        return njit(nogil=True, cache=True)(function)
    except RuntimeError:  # nowhere to keep what is compiled
        return njit(nogil=True)(function)


@intrinsic
def ones(typing_context, word):
    """Count the ones of a uint64."""

    def code(context, builder, signature, arguments):
        return builder.ctpop(arguments[0])

    return types.uint64(types.uint64), code
