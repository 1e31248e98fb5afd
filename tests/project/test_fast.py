"""`pytest -m fast` leaves out what takes long, and nothing else."""

from __future__ import annotations

from pathlib import Path

import pytest
from slow_modules import ALWAYS_FAST, TESTS, main, slow_modules


def test_the_slow_modules_exist_and_most_modules_are_fast() -> None:
    modules = {path.relative_to(TESTS).as_posix() for path in TESTS.rglob("test_*.py")}
    assert slow_modules() <= modules
    assert modules >= ALWAYS_FAST
    assert 2 * len(slow_modules()) < len(modules)


def test_the_list_is_written_from_what_pytest_measured(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("slow_modules.LIST", tmp_path / "slow.txt")
    lines = ["1.00s call     tests/a/test_b.py::test_x[a-b]", "0.60s setup    tests/a/test_b.py::test_y", "slow"]
    lines += ["1.40s call     tests/test_c.py::test_x", "9.00s call     tests/rules/test_rule_examples.py::test_x"]
    (tmp_path / "durations.txt").write_text("\n".join(lines))
    main(str(tmp_path / "durations.txt"))
    assert slow_modules() == {"a/test_b.py"}
