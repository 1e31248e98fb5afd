"""Lines as people paste them: colour remains, quotes of web pages, prefixes, levels, joined and reworded lines."""

from __future__ import annotations

import pytest

from urdfctl.logs.digest import Digest, digest
from urdfctl.logs.line import LogLine, cleaned, plain, records

MESSAGE = "Could not load controller 'arm' because controller type 'x/Y' does not exist."


def pasted(text: str) -> Digest:
    return digest(text.splitlines(), pasted=True)


def log(text: str) -> Digest:
    return digest(text.splitlines(), pasted=False)


@pytest.mark.parametrize(
    "coloured",
    [
        "[31m{}[0m",
        "^[[31m{}^[[0m",
        "\\033[1;31m{}\\033[0m",
        "\\u001b[31m{}\\u001b[0m",
        "#033[31m{}#033[0m",
        "[1;31m{}[0m",
    ],
)
def test_what_is_left_of_colour_codes_is_removed(coloured: str) -> None:
    assert cleaned(coloured.format("[ERROR] [1.0]: bad")) == "[ERROR] [1.0]: bad"


def test_a_range_in_metres_is_not_a_colour_code() -> None:
    assert cleaned("distance [0m, 30m] and [30m]") == "distance [0m, 30m] and [30m]"


@pytest.mark.parametrize(
    "text",
    [
        MESSAGE.replace("'", "`"),
        MESSAGE.replace("'arm'", "‘arm’").replace("'x/Y'", "“x/Y”"),  # noqa: RUF001
        MESSAGE.replace("'arm'", "u'arm'").replace("'x/Y'", "u'x/Y'"),
        MESSAGE.replace("'", '"'),
        MESSAGE.replace("'", ""),
        MESSAGE.upper().replace("ARM", "arm").replace("X/Y", "x/Y"),
        "could not load the controller 'arm' because the controller type 'x/Y' doesn't exist",
    ],
)
def test_quotes_capitals_articles_and_contractions_may_differ(text: str) -> None:
    (known,) = pasted(text).known
    assert (known.message.id, known.values) == (
        "controller-type-does-not-exist",
        ({"controller": "arm", "type": "x/Y"},),
    )


def test_a_python_tuple_around_a_message_is_not_part_of_its_name() -> None:
    (known,) = pasted("XacroException(u'unknown macro name: xacro:wheel',)").known
    assert known.values[0]["macro"] == "wheel"


@pytest.mark.parametrize(
    ("line", "level", "process"),
    [
        ("[n-1] [INFO] [1.0] [x]: a b", "info", "n-1"),
        ("[ros2_control_node-12] [ERROR 1750160894.5] [a.b]: a b", "error", "ros2_control_node-12"),
        ("[ign gazebo-1] [Err] [SystemLoader.cc:125] a b", "error", "ign gazebo-1"),
        ("[ruby $(which gz) sim-4] [Wrn] [x.cc:1] a b", "warning", "ruby $(which gz) sim-4"),
        ("2: [node-2] a b", "", "node-2"),
        ("[/robot_state_pub] [ WARN] [149.9]: a b", "warning", ""),
        ("(2025-01-01 10:00:00.123) [critical] [x.cc:1] a b", "error", ""),
        ("ValueError: a b", "error", ""),
        ("a b", "", ""),
    ],
)
def test_the_level_and_the_process_of_a_line_are_read_from_its_prefixes(line: str, level: str, process: str) -> None:
    (record,) = records(line)
    assert (record.level, record.process) == (level, process)
    assert plain(record.text).endswith("a b")


def test_lines_that_were_joined_are_read_one_by_one() -> None:
    joined = "[n-1] [INFO] [1.0] [a]: all is well [n-1] [ERROR] [2.0] [a]: it is not [ WARN] [3.0]: or is it"
    assert records(joined) == [
        LogLine("[INFO] [1.0] [a]: all is well", "info", "n-1"),
        LogLine("[ERROR] [2.0] [a]: it is not", "error", "n-1"),
        LogLine("[ WARN] [3.0]: or is it", "warning", ""),
    ]


def test_a_message_may_go_on_in_lines_that_begin_with_the_name_of_their_process() -> None:
    lines = (
        "2: [node-2] [controller_manager 17.5]: Caught exception of type : E while loading hardware: According to the "
        "loaded plugin descriptions the class\n"
        "2: [node-2]    my_robot_hardware/ArmSystem\n"
        "2: [node-2]  with base class type hardware_interface::SystemInterface does not exist. Declared types are  "
        "my_robot_hardware/ArmSystem mock_components/GenericSystem\n"
    )
    for text in (lines, lines.replace("\n", " ")):
        first = (pasted(text) if text is not lines else log(text)).known[0]
        assert first.values[0]["plugin"] == "my_robot_hardware/ArmSystem"
        assert "spaces or a line break" in first.reading.causes[0].text


def test_a_line_of_level_info_is_no_failure_unless_the_runtime_prints_it_so() -> None:
    assert log("[INFO] [1.0] [x]: 'joints' parameter is empty.\n").known == ()
    (waits,) = log(
        "[s-1] [INFO] [1.0] [s]: waiting for service /controller_manager/list_controllers to become available..."
    ).known
    assert waits.kind == "consequence"


def test_a_text_that_nearly_has_the_words_of_a_message_is_taken_for_it_and_other_text_is_not() -> None:
    (known,) = pasted("Parameter 'update_rate' not set, using the default value").known
    assert known.message.id == "update-rate-default"
    assert pasted("the robot is not where the default value of its update was set").known == ()


def test_the_code_in_a_traceback_is_not_listed_as_unknown() -> None:
    text = 'Traceback (most recent call last):\n  File "/opt/x.py", line 3, in main\n    run_the_flux(capacitor, now)\n'
    assert log(text + "FluxError: the capacitor is empty\n").unknown[0].text == "FluxError: the capacitor is empty"
    assert len(log(text).unknown) == 0


def test_a_text_that_only_ends_in_the_first_words_of_a_message_is_not_taken_for_it() -> None:
    assert pasted("Could not contact controller manager").known == ()
