"""Here the tests run on all cases, not on a sample; see ../README.md."""

from __future__ import annotations

import sampling
from hypothesis import settings

sampling.WHOLE.append(True)
settings.load_profile("whole")
