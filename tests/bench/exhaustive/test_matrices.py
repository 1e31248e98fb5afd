"""All types of controllers in all distros and simulators, all rules, and all combinations of names and forms."""
# ruff: noqa: F401

from __future__ import annotations

from test_catalogue_rules import (
    test_a_value_of_the_wrong_type_is_reported_for_each_parameter,
    test_a_value_that_a_validator_rejects_is_reported,
    test_each_missing_required_parameter_is_reported,
    test_minimal_parameters_have_no_findings,
)
from test_cli_fix import test_git_makes_of_the_diff_what_fix_would_write
from test_cli_rules import test_every_rule_can_be_explained_and_its_example_shows_it
from test_generate_controllers import (
    test_every_type_of_controller_is_written_so_that_lint_finds_nothing_and_twice_the_same,
)
from test_generate_good import test_the_same_types_claim_the_same
from test_generate_matrix import test_every_combination_lints_and_smokes_clean_or_is_refused
from test_generate_mjcf import test_public_robots_are_the_same_mechanisms
from test_generate_robot import test_a_package_of_every_kind_of_controller_lints_clean, test_a_package_smokes_clean
from test_migrate_examples import test_a_step_changes_nothing_in_what_it_made
from test_shards import (
    test_it_changes_nothing_how_many_robots_are_looked_at_at_once,
    test_the_shares_together_find_what_one_run_finds,
)
