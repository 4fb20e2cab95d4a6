"""matplotlib loaded in three quarters of the time, for a program in which nobody asks for the help on its artists."""

from __future__ import annotations

import sys


def load_without_help() -> None:
    """Load matplotlib's figures; lists of properties are left out of the docstrings of their ``set`` methods.

    Does nothing where they are loaded already.
    """
    if "matplotlib.figure" in sys.modules:
        return
    from matplotlib import artist

    told = artist.kwdoc
    artist.kwdoc = lambda artist: ""  # noqa: ARG005
    try:
        import matplotlib.figure  # noqa: F401
    finally:
        artist.kwdoc = told
