"""The plain reading of the words of `lint` and `smoke`, without typer, agrees with typer's."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest
import typer.main

from urdfctl.cli.app import app
from urdfctl.cli.fast_path import COMMANDS, options_of, plain_options, table_of, table_text
from urdfctl.cli.options import LintOptions, SmokeOptions
from urdfctl.cli.words import codes, split_arguments

TYPED = typer.main.get_command(app).commands  # type: ignore[attr-defined]


@pytest.mark.parametrize("command", COMMANDS)
def test_the_table_is_generated_from_the_options_that_typer_reads(command: str) -> None:
    assert Path(str(table_of(command).__file__)).read_text(encoding="utf-8") == table_text(command)


def test_both_paths_give_an_object_with_the_same_attributes() -> None:
    options = options_of("lint", ["robot.xacro", "--distro", "noetic", "--select", "UC2", "--fix"])
    expected = LintOptions(paths=["robot.xacro"], distro="noetic", select=["UC2"], fix=True)
    assert vars(options) == vars(expected)
    options = options_of("smoke", ["robot.xacro", "--engine=none", "--controllers", "c.yaml", "--gui"])
    assert vars(options) == vars(SmokeOptions(paths=["robot.xacro"], engine="none", controllers=["c.yaml"], gui=True))


def by_typer(words: list[str], command: str = "lint") -> dict[str, Any]:
    """What typer makes of some words, without what it fills in by itself."""
    context = TYPED[command].make_context(command, list(words))
    given = {
        name: value
        for name, value in context.params.items()
        if str(context.get_parameter_source(name)).endswith("COMMANDLINE")
    }
    return {"paths": [], **{name: list(v) if isinstance(v, tuple) else v for name, v in given.items()}}


@pytest.mark.parametrize(
    "words",
    [
        [],
        ["robot.xacro"],
        ["robot.xacro", "prefix:=left_", "b.urdf"],
        ["a.xacro", "--distro", "noetic", "b.xacro", "--trust"],
        ["--distro=noetic", "--simulator", "gz", "--start", "a,b", "--workspace", "."],
        ["--distro", "noetic", "--distro", "jazzy"],
        ["--package-path", "a", "--package-path=b", "--env", "HOME", "--env", "USER"],
        ["--timeout", "3", "--memory", "512", "--jobs", "4"],
        ["--timeout=1e1", "--memory=0", "--jobs=-1"],
        ["--select", "UC2,UC3", "--ignore", "UC201", "--extend-select", "UC4"],
        ["--format", "text", "--format", "json=a=b.json"],
        ["--fail-on", "warning", "--exit-zero", "--exit-zero"],
        ["--distro="],
        ["--select", "", "x"],
        [""],
        ["größe.xacro", "mein Ordner/腕.urdf"],
    ],
)
def test_both_make_the_same_of_plain_words(words: list[str]) -> None:
    assert plain_options(words, table_of("lint")) == by_typer(words)


@pytest.mark.parametrize(
    "words",
    [
        ["robot.xacro", "prefix:=left_", "--controllers", "a.yaml", "--controllers=b.yaml"],
        ["--engine", "none", "--duration", "1.5", "--timeout=3", "--only", "a,b", "--tasks", "t.yaml"],
        ["--format", "text", "--format", "json=a.json", "-o", "report.txt", "--report", "page.html"],
        ["-q", "--statistics", "--exit-zero", "--allow-empty", "--progress", "--gui"],
        ["--select", "UC9", "--ignore", "UC910", "--fail-on", "warning", "--baseline", "b.json", "--jobs", "2"],
    ],
)
def test_both_make_the_same_of_plain_words_of_a_smoke_test(words: list[str]) -> None:
    assert plain_options(words, table_of("smoke")) == by_typer(words, "smoke")


@pytest.mark.parametrize(
    "words",
    [
        ["--help"],
        ["-h"],
        ["--unheard-of"],
        ["--distr", "noetic"],
        ["--distro"],
        ["--distro", "--trust"],
        ["--timeout", "soon"],
        ["--memory", "1.5"],
        ["--trust=yes"],
        ["--", "-odd.xacro"],
        ["-x"],
        ["-"],
        ["a.xacro", "--jobs", "-1"],
    ],
)
def test_what_is_not_plain_is_left_to_typer(words: list[str]) -> None:
    assert plain_options(words, table_of("lint")) is None


@pytest.mark.parametrize("words", [["--help"], ["--no-progress"], ["--fix"], ["--engine"], ["--duration", "long"]])
def test_what_is_not_plain_in_a_smoke_test_is_left_to_typer(words: list[str]) -> None:
    assert plain_options(words, table_of("smoke")) is None


def test_arguments_are_told_from_paths_as_xacro_does() -> None:
    words = ["a.xacro", "x:=1", "name:=a:=b", " y := 2 ", "empty:=", ":=nothing", "C:/robot.xacro", "url:=http://x"]
    paths, arguments = split_arguments(words)
    assert paths == ["a.xacro", "C:/robot.xacro"]
    assert arguments == {"x": "1", "name": "a:=b", "y": "2", "url": "http://x"}


def test_codes_come_apart_at_commas_in_any_case() -> None:
    assert codes(["uc2, UC301 ,", "UC4"]) == ("UC2", "UC301", "UC4")
    assert codes(None) == ()
