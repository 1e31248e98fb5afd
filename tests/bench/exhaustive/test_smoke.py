"""The smoke test on all robots, engines and faults, and on all verdicts of real controller managers."""

from __future__ import annotations

from test_smoke_corpus import *  # noqa: F403
from test_smoke_faults import *  # noqa: F403
from test_smoke_truth import *  # noqa: F403
