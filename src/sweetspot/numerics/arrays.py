"""The kinds of arrays that all functions speak of."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
"""Numbers, of any shape; docstrings say which."""
IntArray = NDArray[np.int64]
"""Counts, indices and outcomes."""
