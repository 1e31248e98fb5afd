"""What lint says of the golden cases is as it was read and approved."""

from __future__ import annotations

import pytest
from cases import CASES, NAMES, said


@pytest.mark.parametrize("name", NAMES)
def test_what_lint_says_of_a_case_is_as_it_was_read_and_approved(name: str) -> None:
    expected = (CASES / name / "expected.txt").read_bytes().decode()
    assert said(CASES / name) == expected, "python tests/helpers/cases.py --update, then read the difference"
