"""What a contact does, in words and numbers."""

from __future__ import annotations

import numpy as np

OPEN, STICKS, SLIPS, UNKNOWN = range(4)  # unknown: it touches, and friction cannot be told
MODES = ("open", "sticks", "slips", "unknown")
WORDS = np.array(MODES, dtype=object)
