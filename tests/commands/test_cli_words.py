"""The plain reading of a command line, without typer, agrees with typer's; both follow from one declaration."""

from __future__ import annotations

import subprocess
import sys
from collections.abc import Iterator
from typing import Any

import pytest

from urdfctl.commands import COMMANDS, app, command_named
from urdfctl.commands.declaring import OUTPUT, RULES, Command, Options, Reads, argument, option
from urdfctl.commands.reading import plain_options
from urdfctl.commands.words import codes, split_arguments


def by_typer(words: list[str], command: str, monkeypatch: pytest.MonkeyPatch) -> dict[str, Any]:
    """The options that typer makes of some words."""
    read: list[Options] = []

    def noted(_: Command, options: Options) -> int:
        read.append(options)
        return 0

    monkeypatch.setattr(app, "run_command", noted)
    app.typed_command(command).main(words, standalone_mode=False)
    return read[0].values()


def plainly(words: list[str], command: str) -> dict[str, Any] | None:
    """The options that the plain reader makes of some words; None if it leaves them to typer."""
    read = plain_options(command_named(command).options, words)
    return None if read is None else read.values()


def every_flag() -> Iterator[tuple[str, list[str]]]:
    """Each flag of each command, with values of its type, after what the command must have."""
    texts = {str: ("jazzy", "a=b, c"), int: ("7", "12"), float: ("1.5", "7")}
    for name in COMMANDS:
        declared = command_named(name).options.declared
        needed = ["robot.xacro" for one in declared.values() if one.is_required]
        for one in declared.values():
            for flag in (*one.flags, *one.negatives):
                first, second = texts.get(one.type, ("", ""))
                again = [f"{flag}={second}"] if flag.startswith("--") else [flag, second]
                given = [flag] if one.type is bool else [flag, first, *again]
                yield name, [*needed, *given]


@pytest.mark.parametrize(("command", "words"), list(every_flag()), ids=str)
def test_each_option_of_each_command_is_read_plainly_as_typer_reads_it(
    command: str, words: list[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    read = plainly(words, command)
    assert read is not None
    assert read == by_typer(words, command, monkeypatch)


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
def test_both_make_the_same_of_plain_words(words: list[str], monkeypatch: pytest.MonkeyPatch) -> None:
    assert plainly(words, "lint") == by_typer(words, "lint", monkeypatch)


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
def test_both_make_the_same_of_plain_words_of_a_smoke_test(words: list[str], monkeypatch: pytest.MonkeyPatch) -> None:
    assert plainly(words, "smoke") == by_typer(words, "smoke", monkeypatch)


@pytest.mark.parametrize(
    ("command", "words"),
    [
        ("smoke", ["--no-progress", "--progress", "a.urdf"]),
        ("expand", ["a.xacro", "x:=1", "-o", "a.urdf", "y:=2"]),
        ("init", []),
        ("init", ["robots", "--no-workflow"]),
        ("schema", ["urdf"]),
        ("explain", ["No", "p", "gain", "--in", "."]),
        ("gen-all", ["a.urdf", "-type", "effort", "--no-broadcaster", "-o", "made", "-rate", "100"]),
    ],
)
def test_both_make_the_same_of_other_commands(command: str, words: list[str], monkeypatch: pytest.MonkeyPatch) -> None:
    read = plainly(words, command)
    assert read is not None
    assert read == by_typer(words, command, monkeypatch)


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
    assert plainly(words, "lint") is None


@pytest.mark.parametrize(
    ("command", "words"),
    [
        ("smoke", ["--help"]),
        ("smoke", ["--fix"]),
        ("smoke", ["--engine"]),
        ("smoke", ["--duration", "long"]),
        ("expand", []),
        ("init", ["a", "b"]),
        ("gen-all", ["--rate", "0"]),
        ("gen-gazebo", ["--type", "effort"]),
        ("gen-controllers", ["-"]),
    ],
)
def test_what_is_not_plain_for_another_command_is_left_to_typer(command: str, words: list[str]) -> None:
    assert plainly(words, command) is None


def test_a_short_option_takes_a_value_after_an_equals_sign_too() -> None:
    assert plainly(["-o=report.txt"], "lint") == plainly(["-o", "report.txt"], "lint")


# -- declarations ----------------------------------------------------------------------------------------------------


class Pick(Options):
    """Pick apples."""

    where: str = argument("The tree.", is_required=True)
    sorts: tuple[str, ...] = option(RULES, "Only these sorts.", "-s", "--sort", reads=Reads.NOTHING)
    in_rain: bool | None = option(OUTPUT, "Even if it rains.")
    rows: int = option(OUTPUT, "How many rows.", default=3)


def test_flags_types_and_defaults_follow_from_the_attribute() -> None:
    declared = Pick.declared
    assert (declared["where"].flags, declared["sorts"].flags) == ((), ("-s", "--sort"))
    assert (declared["in_rain"].flags, declared["in_rain"].negatives) == (("--in-rain",), ("--no-in-rain",))
    assert declared["sorts"].help == "Only these sorts. Repeatable."
    read = plain_options(Pick, ["old", "-s", "red", "--sort=green", "--no-in-rain", "--rows", "4"])
    assert read is not None
    assert read.values() == {"where": "old", "sorts": ("red", "green"), "in_rain": False, "rows": 4}
    assert Pick(where="old").values() == {"where": "old", "sorts": (), "in_rain": None, "rows": 3}


def test_the_options_of_a_run_do_not_change_and_have_no_others() -> None:
    read = Pick(where="old")
    with pytest.raises(AttributeError, match=r"Pick\.rows cannot be changed"):
        read.rows = 5  # type: ignore[misc]
    with pytest.raises(TypeError, match="Pick has no option columns"):
        Pick(columns=1)  # type: ignore[call-arg]


def test_an_option_of_a_type_that_cannot_be_read_is_a_mistake_of_its_declaration() -> None:
    with pytest.raises(TypeError, match=r"the type of Bad\.sizes is 'set\[str\]'; known are "):

        class Bad(Options):
            sizes: set[str] = option(OUTPUT, "Sizes.")


def test_only_the_command_that_is_typed_is_imported() -> None:
    code = "import sys; from urdfctl.commands.running import run_words; run_words(['rules', '--select', 'UC401'])"
    told = "print(*(name for name in sys.modules if name.startswith('urdfctl.commands.') and name.count('.') == 3))"
    ran = subprocess.run([sys.executable, "-c", f"{code}; {told}"], capture_output=True, text=True, check=True)
    assert ran.stdout.splitlines()[-1] == "urdfctl.commands.understand.rules"


# -- words -----------------------------------------------------------------------------------------------------------


def test_arguments_are_told_from_paths_as_xacro_does() -> None:
    words = ["a.xacro", "x:=1", "name:=a:=b", " y := 2 ", "empty:=", ":=nothing", "C:/robot.xacro", "url:=http://x"]
    paths, arguments = split_arguments(words)
    assert paths == ["a.xacro", "C:/robot.xacro"]
    assert arguments == {"x": "1", "name": "a:=b", "y": "2", "url": "http://x"}


def test_codes_come_apart_at_commas_in_any_case() -> None:
    assert codes(["uc2, UC301 ,", "UC4"]) == ("UC2", "UC301", "UC4")
    assert codes(()) == ()


def test_changed_options_differ_only_in_what_is_given() -> None:
    options = plain_options(command_named("gen-all").options, ["arm.urdf", "--distro", "jazzy"])
    assert options is not None
    changed = options.changed(rate=500)
    assert {**changed.values(), "rate": None} == options.values()
    assert (changed.values()["rate"], type(changed)) == (500, type(options))
