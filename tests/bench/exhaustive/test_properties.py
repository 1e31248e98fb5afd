"""Properties of generated texts, names and findings, with twenty times as many examples."""
# ruff: noqa: F401

from __future__ import annotations

from test_baseline import test_what_is_written_knows_just_what_was_found
from test_expressions import *  # noqa: F403
from test_generate_controllers import test_any_names_come_back_in_their_order
from test_generate_names import *  # noqa: F403
from test_gitignore import test_what_is_ignored_is_what_git_says
from test_hostile_readers import test_no_text_is_too_odd_to_be_read_or_refused
from test_report_hostile import *  # noqa: F403
