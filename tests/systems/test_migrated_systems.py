"""Systems of Gazebo Classic, in random idioms, start after their migration to gz what they started before."""

from __future__ import annotations

from itertools import islice

import pytest
from sampling import examples

from systems.draw import draw
from systems.migrated import is_migrated, migrated
from systems.possible import Idioms

SEEDS = list(islice(filter(is_migrated, range(1000)), 60))


@pytest.mark.parametrize("seed", SEEDS[: examples(8)])
def test_a_migrated_system_starts_what_it_started_before(seed: int) -> None:
    assert migrated(seed).wrong == ()


@pytest.mark.parametrize(
    "wanted",
    [
        {"parameters": "inline"},
        {"parameters": "inline", "namespacing": "group"},
        {"fleet": "shared", "depth": "nested", "loading": "attribute"},
    ],
    ids=["written in the launch file", "written there for each robot", "in a file that an argument chooses"],
)
def test_controllers_start_after_a_migration_wherever_they_are_written(wanted: Idioms) -> None:
    seed = next(
        seed for seed in range(5000) if draw(seed, is_faulty=False).generation == 1 and is_migrated(seed, wanted)
    )
    assert migrated(seed, wanted).wrong == ()
