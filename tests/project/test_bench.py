"""The race's arithmetic, and what it tells of tools that are not there; never how fast anything is."""

from __future__ import annotations

import json
import os
import shutil
import sys
from collections.abc import Callable
from pathlib import Path

import pytest
from bench import main
from race.process import NotComparable, Step, environment, program, python_with
from race.table import Row, exponent, growth, text

pytestmark = pytest.mark.skipif(os.name == "nt", reason="the race is run by sh")

Tool = Callable[..., None]


@pytest.fixture
def tool(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Tool:
    """Makes a program of a name, with a script of sh; there are no others."""
    folder = tmp_path / "bin"
    folder.mkdir()
    (folder / "sh").symlink_to(str(shutil.which("sh")))
    monkeypatch.setenv("PATH", str(folder))
    monkeypatch.setattr(sys, "executable", str(folder / "python"))

    def make(name: str, script: str = "exit 0") -> None:
        file = folder / name
        file.write_text(f"#!{shutil.which('sh')}\n{script}\n")
        file.chmod(0o755)

    make("urdfctl")
    return make


def test_the_ratio_is_of_the_medians_and_its_extremes_of_neighbouring_runs() -> None:
    row = Row("PR2", "s", [1.0, 2.0, 9.0], [4.0, 4.0, 3.0], "lint | pair").summary()
    assert (row["a_median"], row["b_median"], row["ratio"]) == (2.0, 4.0, 0.5)
    assert (row["ratio_min"], row["ratio_max"]) == (0.25, 3.0)
    assert (row["target"], row["target_of"]) == (0.65, "ratio")


def test_the_target_of_memory_is_for_urdfctl_alone() -> None:
    row = Row("PR2 memory", "MB", [40.0], [20.0], "lint | pair").summary()
    assert (row["target"], row["target_of"]) == (60.0, "a_median")
    assert "<= 60 MB (A)" in text([row])


def test_where_there_is_no_rival_there_is_no_ratio() -> None:
    row = Row("smoke PR2", "s", [1.0, 3.0], [], "smoke --engine none").summary()
    assert (row["a_median"], row["b_median"], row["ratio"], row["ratio_min"]) == (2.0, None, None, None)
    assert text([row]).splitlines()[1].split() == "smoke PR2 2.000 s - - - 2 smoke --engine none".split()


def test_a_line_of_the_table_tells_medians_ratio_extremes_target_and_runs() -> None:
    row = Row("UR5e", "s", [0.1, 0.1], [0.2, 0.25], "lint | pair", note="of two").summary()
    _, line, _, note = text([row]).splitlines()
    assert line.split() == "UR5e 0.100 s 0.225 s 0.44 0.40..0.50 <= 0.85 2 lint | pair".split()
    assert note == "UR5e: of two"


@pytest.mark.parametrize("power", [0.0, 1.0, 2.0])
def test_the_exponent_is_the_power_of_the_growth(power: float) -> None:
    assert exponent([(n, 3 * n**power) for n in (100, 300, 5000)]) == pytest.approx(power)


def test_one_size_has_no_exponent() -> None:
    assert exponent([(100, 1.0)]) is None
    assert exponent([(100, 1.0), (100, 2.0)]) is None


def test_start_up_counts_no_longer_between_the_largest_two() -> None:
    rows = [
        Row(f"growth {n} links", "s", [a], b, "lint | pair", links=n).summary()
        for n, a, b in ((10, 5.0, [1.0]), (1000, 10.0, [100.0]), (10000, 100.0, []))
    ]
    found = growth([*rows, Row("PR2", "s", [7.0], [7.0], "lint | pair").summary()])
    assert found["a"]["largest_two"] == pytest.approx(1.0)
    assert found["a"]["all"] < 0.5
    assert found["b"] == {"all": pytest.approx(1.0), "largest_two": pytest.approx(1.0)}
    assert text(rows).endswith("growth of B: time ~ links^1.00; between the largest two 1.00")


def test_programs_and_modules_that_are_not_installed_are_told_with_what_installs_them(tool: Tool) -> None:
    with pytest.raises(NotComparable, match=r"^catkin_lint is not installed: pip install catkin-lint$"):
        program("catkin_lint", "pip install catkin-lint")
    with pytest.raises(NotComparable, match=r"^no_such_module is not installed: pip install it$"):
        python_with("no_such_module", "pip install it")


def test_a_rival_that_refuses_is_told_in_its_last_words(tmp_path: Path) -> None:
    step = Step(("sh", "-c", "echo first >&2; echo last >&2; exit 3"), tmp_path, environment(), rival=True)
    with pytest.raises(NotComparable, match=r"^exit status 3: last$"):
        step.run()


def test_a_tool_that_is_not_installed_is_no_error(tool: Tool, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["--only", "1200 links", "--runs", "1"]) == 0
    said = capsys.readouterr()
    assert "not measured: 1200 links: check_urdf is not installed: apt install liburdfdom-tools\n" in said.out
    assert said.err == ""


def test_that_urdfctl_does_not_run_is_an_error(tool: Tool, capsys: pytest.CaptureFixture[str]) -> None:
    tool("xacro"), tool("check_urdf")
    tool("urdfctl", "echo 'a fault of ours' >&2; exit 3")
    assert main(["--only", "1200 links", "--runs", "1"]) == 1
    assert "lint --no-cache made.xacro: exit status 3: a fault of ours" in capsys.readouterr().err


def test_without_urdfctl_nothing_is_measured(tool: Tool, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    (tmp_path / "bin" / "urdfctl").unlink()
    assert main([]) == 1
    assert capsys.readouterr().err == "bench: urdfctl is not installed: pip install urdfctl\n"


def test_that_the_corpus_is_not_there_is_told_by_its_option(tool: Tool, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["--only", "PR2", "--corpus", "nowhere"]) == 1
    assert "index.yaml not found: name the corpus of public robots with --corpus" in capsys.readouterr().err


def test_where_the_pair_cannot_urdfctl_is_measured_alone(
    tool: Tool, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    tool("xacro"), tool("check_urdf", "exit 139")
    file = tmp_path / "bench.json"
    assert main(["--only", "growth", "--runs", "2", "--json", str(file)]) == 0
    assert "growth 5000 links: xacro && check_urdf not measured: exit status 139\n" in capsys.readouterr().out
    report = json.loads(file.read_text())
    assert [(row["links"], len(row["a"]), row["b"]) for row in report["rows"]] == [
        (links, 2, []) for links in (100, 300, 1000, 2000, 5000)
    ]
    assert set(report["growth"]) == {"a"}


@pytest.mark.parametrize(("seconds", "runs"), [("100", 4), ("0", 1)])
def test_slow_turns_are_fewer(tool: Tool, tmp_path: Path, seconds: str, runs: int) -> None:
    tool("xacro"), tool("check_urdf")
    file = tmp_path / "bench.json"
    assert main(["--only", "1200 links", "--runs", "4", "--seconds", seconds, "--json", str(file)]) == 0
    [row] = json.loads(file.read_text())["rows"]
    assert (len(row["a"]), len(row["b"])) == (runs, runs)
