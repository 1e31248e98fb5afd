"""The examples of a rule notice a row that is missing from a table; bench/exhaustive/rule_mutants.py drops each."""

from __future__ import annotations

import subprocess
import sys

import pytest
from folder import CHECKOUT, environment

pytestmark = pytest.mark.skipif(sys.platform == "win32", reason="each row is dropped in a fork")


def test_examples_notice_a_row_that_is_missing_from_a_table() -> None:
    done = dropped("--sample", "32", "--seed", "1")
    assert done.returncode == 0, f"give these rows an example each, or a reason in REASONS:\n{done.stdout}{done.stderr}"


def test_a_row_that_no_example_needs_is_told_with_the_reason() -> None:
    done = dropped("controllers.controller_type_not_in_distro")
    assert done.returncode == 0, done.stderr
    *rows, last = done.stdout.splitlines()
    assert len(rows) == 2
    assert "_MAINTAINED without 'noetic' of the distro is needed, or own types" in rows[1]
    assert last == "0 of 2 mutants killed"


def dropped(*arguments: str) -> subprocess.CompletedProcess[str]:
    """Drop rows of tables of the rules, one at a time; the output tells which ones no example notices."""
    words = [sys.executable, str(CHECKOUT / "tests/bench/exhaustive/rule_mutants.py"), "tables", *arguments]
    return subprocess.run(words, env=environment({}), capture_output=True, text=True, check=False)
