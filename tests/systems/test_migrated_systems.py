"""Systems of Gazebo Classic, in random idioms, start after their migration to gz what they started before."""

from __future__ import annotations

from itertools import islice

import pytest
from sampling import examples

from systems.migrated import is_migrated, migrated

SEEDS = list(islice(filter(is_migrated, range(1000)), 60))


@pytest.mark.parametrize("seed", SEEDS[: examples(8)])
def test_a_migrated_system_starts_what_it_started_before(seed: int) -> None:
    assert migrated(seed).wrong == ()


@pytest.mark.parametrize("seed", [13, 97, 1089])
def test_controllers_that_launch_files_write_or_choose_start_after_a_migration(seed: int) -> None:
    """The first two write controllers in launch files; in the last one an argument chooses the file of each robot."""
    assert migrated(seed).wrong == ()
