"""The schemas on the least parameters of all controllers in all distros, and on all verdicts of the real runtimes."""

from __future__ import annotations

from test_schema import test_the_least_parameters_of_each_type_fit  # noqa: F401
from test_schema_truth import *  # noqa: F403
