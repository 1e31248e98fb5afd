"""The whole corpus of public robots: finding, pairing, expanding, fixing, generating, reading expressions."""
# ruff: noqa: F401

from __future__ import annotations

from test_corpus_pairs import test_the_robots_of_the_index_and_what_belongs_to_them_are_found
from test_expand_corpus import (
    test_a_problem_is_told_where_it_stands,
    test_what_does_not_expand_has_a_problem_in_a_real_line,
    test_what_expands_is_byte_for_byte_what_xacro_writes,
)
from test_fix_corpus import test_only_what_the_fixes_say_changes_and_what_they_are_for_is_gone
from test_generate_corpus import (
    test_a_package_for_a_robot_without_control_adds_nothing_to_what_lint_says_of_it,
)
from test_hostile_files import test_no_expression_of_a_public_robot_is_refused
from test_migrate_corpus import test_a_migration_does_not_depend_on_its_path_and_is_not_repeated
from test_shards import test_each_file_of_the_corpus_is_in_one_share_and_the_shares_are_alike
