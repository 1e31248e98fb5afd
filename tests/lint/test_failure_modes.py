"""The failure modes F1 to F70 of the reference, and the rules that report each of them."""

from __future__ import annotations

import re

import pytest
from corpus import SHARED

from urdfctl.rules import all_faults

RULES = {
    1: "transmission-joint-without-interface",
    2: "empty-hardware-interface transmission-joint-without-interface",
    3: "transmission-joint-without-interface",
    4: "transmission-joint-without-interface",
    5: "joint-with-two-interfaces-in-gazebo",
    6: "hardware-interface-without-prefix",
    7: "hardware-interface-unknown",
    8: "transmission-joint-unknown transmission-joint-cannot-be-driven moving-link-without-inertial",
    9: "transmission-type-unknown",
    10: "transmission-of-two-joints-in-gazebo",
    11: "transmission-without-type",
    12: "actuator-without-mechanical-reduction mechanical-reduction-unusable",
    13: "transmission-role-invalid",
    14: "transmission-joints-with-different-interfaces",
    15: "joint-without-limit limit-incomplete velocity-limit-zero",
    16: "transmission-name-twice joint-in-two-transmissions actuator-name-twice",
    17: "controller-type-unknown controller-type-not-in-distro controller-type-of-other-ros",
    18: "controller-type-missing controllers-of-other-namespace spawner-of-other-namespace",
    19: "joint-in-another-interface joint-without-transmission",
    20: "joint-in-another-interface joint-without-transmission",
    22: "gains-missing",
    23: "joint-for-joints parameter-missing parameter-of-wrong-type parameter-refused",
    24: "controller-joint-unknown",
    25: "parameter-missing",
    26: "parameter-missing parameters-not-fitting wheel-radius-not-in-robot",
    27: "description-of-other-namespace",
    28: "controllers-in-conflict",
    29: "controller-type-missing",
    30: "controller-type-unknown controller-type-not-in-distro controller-type-of-other-ros",
    31: "parameters-not-given-to-controller parameter-missing",
    32: "parameter-missing parameter-refused",
    33: "parameters-not-fitting",
    34: "parameters-not-fitting parameter-refused",
    35: "section-not-read manager-without-parameters",
    36: "ros-parameters-missing",
    37: "controllers-file-missing controllers-path-not-expanded",
    38: "comment-breaks-parameter",
    39: "update-rate-missing parameter-of-wrong-type",
    41: "controller-faster-than-manager",
    42: "interface-claimed-twice",
    43: "hardware-plugin-unknown",
    44: "blanks-around-name",
    45: "manager-beside-simulator",
    46: "component-joint-unknown",
    47: "component-joint-fixed",
    48: "mimic-joint-commanded mimic-as-parameter",
    49: "mimicked-joint-not-in-component",
    50: "hardware-without-plugin component-without-type component-type-unknown component-child-unknown",
    51: "simulator-without-component ros2-control-not-in-root",
    52: "command-interface-not-exported state-interface-not-exported",
    53: "part-without-interfaces command-without-state",
    54: "hardware-not-active",
    56: "initial-value-malformed interface-limit-malformed",
    57: "plugin-filename-misspelt plugin-of-other-ros plugin-class-unknown",
    58: "plugin-of-other-ros",
    59: "control-plugin-missing spawner-of-other-namespace",
    60: "description-not-published",
    61: "simulation-paused",
    62: "legacy-mode-not-given",
    63: "moving-link-without-inertial mass-not-positive",
    64: "root-link-with-inertial",
    65: "moveit-controller-incomplete moveit-controller-unknown moveit-joints-differ",
    66: "spawned-controller-unknown controller-not-spawned joint-states-not-published",
    67: "spawner-program-gone spawner-option-unknown",
    68: "undefined-name unknown-macro xml-not-well-formed package-not-found",
    69: "control-plugin-twice",
    70: "velocity-limit-zero",
}
NOT_IN_THE_FILES = {
    21: "harmless: the simulation sets positions itself; 'explain' says so",
    40: "the simulation step is set in the world file, which no robot names",
    55: "only gazebo_ros2_control's own variant position_pid, which no robot of the corpus uses",
}


def test_each_failure_mode_has_a_rule_or_a_reason_why_not() -> None:
    assert sorted([*RULES, *NOT_IN_THE_FILES]) == list(range(1, 71))


def test_the_rules_of_a_failure_mode_exist() -> None:
    assert {name for names in RULES.values() for name in names.split()} <= {rule.name for rule in all_faults()}


def test_the_reference_has_the_same_failure_modes() -> None:
    reference = SHARED / "reference" / "failure_modes.md"
    if not reference.exists():
        pytest.skip("the reference is not beside the checkout")
    text = reference.read_text(encoding="utf-8")
    assert [int(number) for number in re.findall(r"(?m)^(\d+)\. ", text)] == list(range(1, 71))
