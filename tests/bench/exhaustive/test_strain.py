"""Very large files, more workers than files may be open, and processes killed at many more moments."""
# ruff: noqa: F401

from __future__ import annotations

from test_cli_fix import test_killed_at_any_moment_it_leaves_no_file_half_written
from test_hostile_files import test_a_hostile_file_gets_a_finding_in_bounded_time_and_harms_nobody
from test_hostile_places import test_killed_at_any_moment_a_generator_leaves_no_file_half_written
from test_worker import test_more_jobs_at_once_than_files_may_be_open_are_no_crash
