"""Finding messages in a log: behind any prefix, truncated or wrapped, repeated, and within limits."""

from __future__ import annotations

import io

import pytest
from hostile.logs import LONG_LOGS
from work import assert_linear

from urdfctl.logs.digest import Digest, KnownMessage, digest, plain
from urdfctl.logs.reading import LONGEST_LINE, Lines

NO_INTERFACE = "No valid hardware interface element found in joint 'elbow'."


def log(text: str | bytes) -> Digest:
    data = text.encode("utf-8") if isinstance(text, str) else text
    return digest(Lines(io.BytesIO(data)), pasted=False)


def pasted(text: str) -> Digest:
    return digest(text.splitlines(), pasted=True)


def only(found: Digest) -> KnownMessage:
    (known,) = found.known
    return known


@pytest.mark.parametrize(
    "before",
    [
        "",
        "[ERROR] [1623.45, 0.2]: ",
        "\x1b[31m[ERROR] [1623.456]: ",
        "[ERROR] [/gazebo]: ",
        "[controller_manager-1] [ERROR] [1699.9] [controller_manager]: ",
        "[gzserver   -3] [Err] [file.cc:12] ",
        "(2025-01-01 10:00:00.123) [error] [SystemLoader.cc:92] ",
        "2024-01-01T10:00:00.123Z ",
        "[ERROR] [WallTime: 1623.456] [12.3] ",
    ],
)
def test_a_message_is_known_behind_any_prefix_and_loses_it(before: str) -> None:
    line = f"{before}{NO_INTERFACE}\x1b[0m\n"
    known = only(log(line))
    assert (known.message.id, known.text, known.values) == (
        "no-hardware-interface-in-joint",
        NO_INTERFACE,
        ({"joint": "elbow"},),
    )
    assert plain(line.replace("\x1b[31m", "").replace("\x1b[0m", "")) == NO_INTERFACE


def test_a_message_is_reported_once_with_its_first_line_and_its_values() -> None:
    found = log(f"hello\n{NO_INTERFACE}\nhello\n{NO_INTERFACE.replace('elbow', 'wrist')}\n{NO_INTERFACE}\n")
    known = only(found)
    assert (found.lines, known.line, known.times) == (5, 2, 3)
    assert known.values == ({"joint": "elbow"}, {"joint": "wrist"})


def test_failures_come_before_their_consequences_and_harmless_lines_last() -> None:
    found = log(
        "[ERROR] [1.0]: No p gain specified for pid.  Namespace: /gazebo_ros_control/pid_gains/elbow\n"
        "[FATAL] [1.0]: Could not initialize robot simulation interface\n"
        "[WARN] [1.0]: link 'base' material 'rde' undefined.\n"
        '[ERROR] [1.0]: This robot has a joint named "elbow" which is not in the gazebo model.\n'
    )
    assert [(known.message.kind, known.line) for known in found.known] == [
        ("failure", 4),
        ("consequence", 2),
        ("warning", 3),
        ("harmless", 1),
    ]


def test_gains_that_gazebo_does_not_need_are_harmless_and_those_of_a_controller_are_not() -> None:
    harmless = only(log("No p gain specified for pid. Namespace: /arm/gazebo_ros_control/pid_gains/elbow"))
    assert (harmless.message.kind, harmless.values[0]["joint"]) == ("harmless", "elbow")
    assert only(log("No p gain specified for pid.  Namespace: /arm_controller/pid")).message.kind == "failure"


def test_in_a_line_that_wraps_another_message_the_inner_one_is_explained() -> None:
    known = only(
        log(
            "[ros2_control_node-1] Exception thrown during init stage with message: parameter 'wheel_radius' has "
            "invalid type: Wrong parameter type, parameter {wheel_radius} is of type {double}, setting it to "
            "{integer} is not allowed."
        )
    )
    assert known.message.id == "parameter-of-wrong-type"
    assert known.values == ({"parameter": "wheel_radius", "wanted": "double", "given": "integer"},)


def test_values_of_the_surrounding_message_are_known_too() -> None:
    known = only(log("Can't activate controller 'arm': Command interface with 'elbow/effort' does not exist"))
    assert known.message.id == "command-interface-not-available"
    assert {"controller": "arm", "interface": "elbow/effort"}.items() <= known.values[0].items()


def test_a_message_that_is_truncated_at_its_end_or_its_beginning_is_known() -> None:
    assert (
        only(pasted("No valid hardware interface element found in jo")).message.id == "no-hardware-interface-in-joint"
    )
    known = only(pasted("...is not available in component 'arm'."))
    assert (known.message.id, known.values[0]["hardware"]) == ("transmission-joint-not-available", "arm")
    known = only(pasted('This robot has a joint named "elbow" which is not in the ga'))
    assert known.values == ({"joint": "elbow"},)


@pytest.mark.parametrize(
    "lines",
    [
        "[ERROR] [1.0]: Could not load controller 'arm' because controller\n type 'x/Y' does not exist.\n",
        "[ERROR] [1.0]: Could not load controller 'arm' because contr\noller type 'x/Y' does not exist.\n",
        "[n-1] [ERROR] [1]:Could not load controller 'arm'\n[n-1] because controller type\n[n-1] 'x/Y' does not exist.",
    ],
)
def test_a_message_that_is_wrapped_is_known(lines: str) -> None:
    for found in (log(lines), pasted(lines)):
        known = only(found)
        assert (known.message.id, known.line) == ("controller-type-does-not-exist", 1)
        assert known.values == ({"controller": "arm", "type": "x/Y"},)


def test_the_quotes_of_web_pages_are_those_of_the_message() -> None:
    known = only(pasted("This robot has a joint named “elbow” which is not in the gazebo model."))
    assert known.values == ({"joint": "elbow"},)


def test_a_line_after_a_truncated_message_is_read_on_its_own() -> None:
    found = log(f"[ERROR] [1.0]: Could not load controller 'arm' because contr\n[ERROR] [1.0]: {NO_INTERFACE}\n")
    assert {known.line for known in found.known} >= {2}


def test_unknown_lines_are_reported_errors_first_and_lines_of_level_info_are_not() -> None:
    found = log("[INFO] [1.0]: all is well\n[WARN] [1.0]: it rains\n[ERROR] [1.0]: the flux capacitor is empty\n")
    assert [(unknown.line, unknown.level, unknown.text, unknown.nearest) for unknown in found.unknown] == [
        (3, "error", "the flux capacitor is empty", None),
        (2, "warning", "it rains", None),
    ]


def test_lines_without_a_level_are_listed_as_unknown_in_a_short_log_and_not_in_a_long_one() -> None:
    assert [unknown.text for unknown in log("the flux capacitor is empty\n").unknown] == ["the flux capacitor is empty"]
    assert log("the flux capacitor is empty\n" * 99).unknown == ()


def test_a_line_marked_as_harmless_is_not_an_error_whatever_it_says() -> None:
    assert log("[spawner-3] [DEBUG] [1.0] [rcl]: Couldn't parse arg 0. Error: lexeme not found\n").unknown == ()


def test_the_nearest_message_is_named_only_if_it_is_similar() -> None:
    (unknown,) = pasted("no valid hardware interface elements found for joint 'elbow'").unknown
    assert unknown.nearest is not None
    assert unknown.nearest.message.id == "no-hardware-interface-in-joint"
    (unknown,) = pasted("the joint of my robot is not moving").unknown
    assert unknown.nearest is None


def test_a_log_without_known_messages_gives_an_empty_digest() -> None:
    assert log("a\nb\n") == Digest(2, (), ())
    assert log("") == Digest(0, (), ())


def test_a_log_is_read_up_to_its_limit() -> None:
    lines = Lines(io.BytesIO(b"x" * 99 + b"\n" + NO_INTERFACE.encode()), most_bytes=100)
    assert (digest(lines, pasted=False).known, lines.complete) == ((), False)
    lines = Lines(io.BytesIO(b"x" * 99 + b"\n"), most_bytes=100)
    assert (len(list(lines)), lines.complete) == (1, True)


def test_a_log_that_is_interrupted_is_read_so_far() -> None:
    class Live(io.BytesIO):
        def read1(self, size: int | None = -1, /) -> bytes:
            if chunk := super().read1(10):
                return chunk
            raise KeyboardInterrupt

    lines = Lines(Live(NO_INTERFACE.encode()))
    assert (list(lines), lines.complete) == ([NO_INTERFACE], False)


def test_lines_are_complete_however_the_log_arrives() -> None:
    class Drops(io.BytesIO):
        def read1(self, size: int | None = -1, /) -> bytes:
            return super().read1(3)

    text = f"a\n\n{NO_INTERFACE}\r\nb"
    assert list(Lines(Drops(text.encode()))) == ["a", "", f"{NO_INTERFACE}\r", "b"]


@pytest.mark.parametrize("name", LONG_LOGS)
def test_hostile_logs_take_work_in_proportion_to_their_size_and_bounded_space(name: str) -> None:
    def read(size: int) -> None:
        digested = log(LONG_LOGS[name](size))
        assert len(digested.unknown) <= 100
        assert all(len(known.values) <= 100 and len(known.text) <= LONGEST_LINE for known in digested.known)

    assert_linear(read, 100)
