"""Messages of the validators of parameter values."""

from __future__ import annotations

import math

import pytest

from urdfctl.catalog.validators import problem
from urdfctl.source.opaque import UNKNOWN


@pytest.mark.parametrize(
    ("validators", "value", "said"),
    [
        ({"bounds": [0, 8]}, 9, "must be between 0 and 8"),
        ({"bounds": [0, 8]}, 8, None),
        ({"lt": 3}, 3, "must be < 3"),
        ({"gt": 0.0}, 0.0, "must be > 0.0"),
        ({"gt": 0.0}, math.nan, "must be > 0.0"),
        ({"lt_eq": 3}, 4, "must be ≤ 3"),
        ({"gt_eq": 0.1}, 0.05, "must be ≥ 0.1"),
        ({"gt_eq_or_nan": 0.0}, -1.0, "must be ≥ 0.0 (or .nan for no limit)"),
        ({"gt_eq_or_nan": 0.0}, math.nan, None),
        ({"lt_eq_or_nan": 0.0}, 1.0, "must be ≤ 0.0 (or .nan for no limit)"),
        ({"nonzero": True}, 0, "must not be 0"),
        ({"nonzero": True}, -1, None),
        ({"one_of": ["splines", "none"]}, "spline", "must be 'splines' or 'none'"),
        ({"one_of": ["none"]}, "none", None),
        ({"subset_of": ["position", "velocity"]}, ["position", "torque"], "can contain only 'position' or 'velocity'"),
        ({"unique": True}, ["a", "b", "a"], "must not contain duplicates"),
        ({"not_empty": True}, [], "must not be empty"),
        ({"not_empty": True}, "", "must not be empty"),
        ({"size_gt": 1}, ["a"], "must have more than 1 element"),
        ({"size_gt": 2}, ["a"], "must have more than 2 elements"),
        ({"size_lt": 3}, ["a", "b", "c"], "must have fewer than 3 elements"),
        ({"fixed_size": 6}, [0.0] * 5, "must have exactly 6 elements"),
        ({"element_bounds": [0.0, 1.0]}, [0.5, 2.0], "can contain only numbers between 0.0 and 1.0"),
        ({"lower_element_bounds": 0.0}, [-1.0], "can contain only numbers ≥ 0.0"),
        ({"upper_element_bounds": 0.0}, [1.0], "can contain only numbers ≤ 0.0"),
        ({"unique": True, "not_empty": True}, [], "must not be empty"),
        ({}, 7, None),
    ],
)
def test_the_first_validator_that_is_broken_is_told(
    validators: dict[str, object], value: object, said: str | None
) -> None:
    assert problem(value, validators) == said


@pytest.mark.parametrize("value", ["three", True, None, {"a": 1}])
def test_a_value_that_is_no_number_breaks_no_limit(value: object) -> None:
    assert problem(value, {"gt": 5, "bounds": [6, 7]}) is None


@pytest.mark.parametrize("value", ["$(var n)", f"a{UNKNOWN}", ["a", "a", "$(var n)"]])
def test_nothing_is_claimed_of_what_is_not_known(value: object) -> None:
    assert problem(value, {"one_of": ["b"], "unique": True, "fixed_size": 1}) is None


def test_there_is_no_validator_but_those() -> None:
    with pytest.raises(ValueError, match="lower"):
        problem(1, {"lower": 0})
