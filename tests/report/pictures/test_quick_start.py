"""What a program pays for matplotlib."""

from __future__ import annotations

import subprocess
import sys

LOADED = """
from sweetspot.report.pictures.quick_start import load_without_help
load_without_help()
from matplotlib import artist
from matplotlib.lines import Line2D
assert Line2D.set.__doc__.strip().endswith("properties are")
assert "linewidth" in artist.kwdoc(Line2D)
Line2D([0, 1], [0, 1]).set(linewidth=2.0)
"""


def test_only_help_texts_are_left_out() -> None:
    subprocess.run([sys.executable, "-c", LOADED], check=True)
