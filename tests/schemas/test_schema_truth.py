"""The schemas accept and reject what the real runtimes do, wherever the fault is one of form."""

from __future__ import annotations

from pathlib import Path
from typing import Any, NamedTuple

import pytest
import yaml
from corpus import SHARED
from sampling import sample

pytest.importorskip("lxml", reason="lxml is not installed")
pytest.importorskip("jsonschema", reason="jsonschema is not installed")

from jsonschema import Draft202012Validator

from urdfctl.schemas.checking import SchemaFault, faults_in_controllers, faults_in_robot
from urdfctl.schemas.controllers import controllers_schema
from urdfctl.schemas.robot import ros2_control_schema
from urdfctl.source.span import SourceText

TRUTH = SHARED / "truth"
EVERY = 7
"""The default tests read each seventh case."""
AGREEMENT = 0.95
DISTRO = "jazzy"

OF_OTHER_FILES = {
    "interface_not_exported": "the robot's hardware decides",
    "unknown_joint": "the robot decides",
    "chained": "the interfaces of the other controllers decide",
    "claim_conflict": "which controllers are active at a time decides",
}
OF_OTHER_SECTIONS = {
    "section_missing": "the section can be in another file",
    "section_name": "a schema does not compare names; a section can be another node's",
    "parameters_under_manager": "the section can be in another file",
    "namespace": "a schema does not compare namespaces",
    "duplicate_interface": "a schema does not compare the values of lists",
    "duplicate_joint": "a schema does not compare the values of two parameters",
}
"""Classes of cases that are no fault of form, and why."""
NOT_OF_FORM = {
    # fallbacks and states of hardware: names of other controllers and components
    *("cm__fallback_self", "cm__fallback_unknown", "cm__hw_both_lists", "cm__hw_inactive", "cm__hw_unconfigured"),
    # types of packages that are not installed: a schema cannot know the user's own packages
    *("ctype__fwd_plural", "ctype__gripper_wrong_pkg", "ctype__hardware_plugin", "ctype__jsb_plural"),
    *("ctype__quoted_inner", "ctype__typo_double_l"),
    # a controller that is started, but not declared
    *("dd__type_missing", "fwd__type_missing", "y_type_missing", "multi__spawn_undeclared", "y_yaml_empty"),
    *("shape__comment_only", "shape__empty", "multi__declared_without_section"),
    # two parameters together
    *("filter__sizes", "pid__ref_dof_names_len", "pid__uclamp_order", "filter__shared_chain_two_inputs"),
    # names that the robot does not have, or a namespace
    *("y_cm_ns_mismatch", "y_dd_same_wheel_both", "y_fwd_iface_unknown", "y_jsb_joints_missing", "y_yaml_dup_key"),
    *("y_jtc_cmd_vel_unavailable", "y_jtc_joint_missing", "y_vel_group_on_pos", "shape__joints_brace"),
    *("shape__joints_duplicate_key_last_bad", "shape__joints_list_null", "shape__joints_number_quoted"),
    *("shape__joints_xacro", "sib__short_name"),
}
NOT_OF_FORM_IN_A_ROBOT = {
    # which plugins are installed, and what a plugin does with its parameters
    *("t_plugin_colons", "t_plugin_lower", "t_plugin_mock_actuator", "t_plugin_typo", "u_plugin_colons"),
    *("t_two_blocks_mixed_plugin_bad", "t_type_sensor", "u_mock_offset_text", "t_jointitf_int32"),
    *("t_hwparam_disable_on", "t_hwparam_dyn_empty", "t_hwparam_dyn_yes", "t_hwparam_value_attr"),
    *("t_initial_comma", "t_initial_deg", "t_initial_expr", "t_initial_inf", "t_initial_nan", "t_initial_text"),
    *("t_initial_true", "t_initial_unit", "u_initial_text"),
    # what a joint of <ros2_control> asks of the joint of the URDF, or of its block
    *("t_mimic_cmd_true", "t_mimic_no_urdf_mimic_true", "t_mimic_other_block", "t_mimic_target_not_in_block"),
    *("u_mimic_cmd", "u_mimic_true_not_in_urdf", "t_trans_joint_other_block"),
    # the tree that the joints make; xacro that was not expanded
    *("u_two_roots", "t_xacro_file_raw"),
}

pytestmark = pytest.mark.skipif(
    not TRUTH.is_dir(), reason="the verdicts of the real runtimes are not beside the checkout"
)


class Case(NamedTuple):
    name: str
    of_class: str
    refused: bool
    is_silent: bool
    file: Path


def cases(suite: str) -> list[Case]:
    """The cases with a verdict for the distro."""
    found = []
    loader = getattr(yaml, "CSafeLoader", yaml.SafeLoader)
    for file in sample(sorted(TRUTH.glob(f"{suite}/*/verdict.yaml")), EVERY):
        case: dict[str, Any] = yaml.load(file.read_text(encoding="utf-8"), loader)  # noqa: S506 (a safe loader)
        verdict = case["distros"].get(DISTRO)
        if verdict and "skip" not in verdict and "undecidable" not in case:
            silent = case.get("silent") or verdict.get("silent")
            is_silent = DISTRO in silent if isinstance(silent, list) else bool(silent)
            refused = verdict["verdict"] == "error"
            found.append(Case(file.parent.name, case.get("class", ""), refused, is_silent, file.parent))
    return found


def source(file: Path) -> SourceText:
    return SourceText(str(file), file.read_bytes())


def test_the_schema_of_controllers_agrees_with_the_controller_manager_on_form() -> None:
    others = {*OF_OTHER_FILES, *OF_OTHER_SECTIONS}
    asked = [
        case
        for case in cases("ros2_controllers")
        if not (case.refused and (case.of_class in others or case.name in NOT_OF_FORM))
    ]
    wrong = [
        case.name
        for case in asked
        if case.refused != bool(faults_in_controllers(source(case.file / "controllers.yaml"), DISTRO))
    ]
    assert len(asked) > 50
    assert len(wrong) <= (1 - AGREEMENT) * len(asked), wrong


def test_what_another_validator_cannot_tell_is_only_how_a_number_is_written() -> None:
    """JSON Schema and yaml-language-server take 1 for 1.0. All else that a schema says, they say too."""
    others = {*OF_OTHER_FILES, *OF_OTHER_SECTIONS}
    asked = [
        case
        for case in cases("ros2_controllers")
        if not (case.refused and (case.of_class in others or case.name in NOT_OF_FORM))
        and not _only_numbers(faults_in_controllers(source(case.file / "controllers.yaml"), DISTRO))
    ]
    plain = Draft202012Validator(controllers_schema(DISTRO))
    wrong = [case.name for case in asked if case.refused == _accepts(plain, case.file / "controllers.yaml")]
    assert len(asked) > 50
    assert len(wrong) <= (1 - AGREEMENT) * len(asked), wrong


def _only_numbers(faults: list[SchemaFault]) -> bool:
    return bool(faults) and all(fault.message.endswith("ROS 2 tells 1 from 1.0") for fault in faults)


def _accepts(validator: Any, file: Path) -> bool:
    try:
        return all(validator.is_valid(document) for document in yaml.safe_load_all(file.read_text(encoding="utf-8")))
    except yaml.YAMLError:
        return False


def test_the_schema_of_ros2_control_agrees_with_the_parser_on_form() -> None:
    schema = ros2_control_schema(DISTRO)
    asked = [case for case in cases("ros2_urdf") if case.name not in NOT_OF_FORM_IN_A_ROBOT and not case.is_silent]
    wrong = [
        case.name for case in asked if case.refused != bool(faults_in_robot(source(case.file / "robot.urdf"), schema))
    ]
    assert len(asked) > 20
    assert len(wrong) <= (1 - AGREEMENT) * len(asked), wrong


def test_what_reaches_active_in_a_real_controller_manager_fits() -> None:
    for case in cases("ros2_good"):
        assert faults_in_controllers(source(case.file / "controllers.yaml"), DISTRO) == [], case.name
        assert faults_in_robot(source(case.file / "robot.urdf"), ros2_control_schema(DISTRO)) == [], case.name
