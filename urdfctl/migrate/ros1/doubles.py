"""Parameters of nodes that are doubles: ROS 1 takes an integer for one, a node of ROS 2 ends with an exception."""

from __future__ import annotations

import re

from urdfctl.migrate.launch.actions import PartOfText, Text, is_literal, plain

_FILTER = (
    r"frequency|sensor_timeout|transform_timeout|transform_time_offset|history_length|control_timeout"
    r"|gravitational_acceleration|\w+_threshold|\w+_queue_timeout"
)
_LISTS_OF_FILTER = r"process_noise_covariance|initial_estimate_covariance|initial_state|\w+_limits|\w+_gains"
_DOUBLES = {
    "robot_state_publisher": r"publish_frequency",
    "state_publisher": r"publish_frequency",
    **dict.fromkeys(("ekf_localization_node", "ekf_node"), _FILTER),
    **dict.fromkeys(("ukf_localization_node", "ukf_node"), rf"{_FILTER}|alpha|kappa|beta"),
    "navsat_transform_node": r"magnetic_declination_radians|yaw_offset|frequency|delay|transform_timeout",
    "twist_mux": r"timeout",
    "joy_node": r"deadzone|autorepeat_rate",
}
"""For each program: the names of its doubles, by rclcpp's declare_parameter() in robot_state_publisher.cpp,
robot_localization's ros_filter.cpp and navsat_transform.cpp, twist_mux's params_helpers.hpp and joy.cpp."""
_INTEGER = re.compile(r"[+-]?\d+")
_LIST = re.compile(r"(?m)^([ \t]*([\w-]+)[ \t]*:[ \t]*)\[([^\[\]{}]*)\]")
_NUMBER = re.compile(r"(?<![\w.+-])[+-]?(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?(?![\w.])")


def is_double(program: str, name: str) -> bool:
    """Return whether a node of ROS 2 reads a parameter as a double, by the node's program in ROS 1 or ROS 2."""
    pattern = _DOUBLES.get(program, "")
    return bool(pattern) and re.fullmatch(pattern, name.rpartition(".")[2]) is not None


def as_double(program: str, name: str, value: Text) -> Text:
    """Return the value of a parameter: as a double, if the node reads it as one."""
    if not value or not is_double(program, name):
        return value
    if not is_literal(value):
        return (PartOfText("double", ""), *value)
    text = plain(value).strip()
    return (PartOfText("text", f"{text}.0"),) if _INTEGER.fullmatch(text) else value


def with_doubles(program: str, text: str) -> str:
    """Return the text of a file of parameters, in block style, with its doubles written as such.

    A list of integers and doubles is one of doubles: rcl reads no other (rcl_yaml_param_parser parse.c: 'Sequence
    should be of same type').
    """
    pattern = _DOUBLES.get(program)
    if pattern:
        text = re.sub(rf"(?m)^([ \t]*(?:{pattern})[ \t]*:[ \t]*)([+-]?\d+)(?=[ \t]*(?:#|\r?$))", r"\1\2.0", text)
    lists = _LISTS_OF_FILTER if "localization" in program else r"(?!)"

    def converted(found: re.Match[str]) -> str:
        plain_text = re.sub("#.*", "", found[3])
        items = [item.strip() for item in plain_text.split(",") if item.strip()]
        are_numbers = bool(items) and all(_NUMBER.fullmatch(item) for item in items)
        integers = [item for item in items if _INTEGER.fullmatch(item)]
        is_meant = re.fullmatch(lists, found[2]) is not None or len(integers) < len(items)
        if not (are_numbers and integers and is_meant):
            return found[0]
        lines = [_line_of_doubles(line) for line in found[3].split("\n")]
        return f"{found[1]}[{chr(10).join(lines)}]"

    return _LIST.sub(converted, text)


def _line_of_doubles(line: str) -> str:
    values, mark, comment = line.partition("#")
    return _NUMBER.sub(lambda one: f"{one[0]}.0" if _INTEGER.fullmatch(one[0]) else one[0], values) + mark + comment
