"""Every type of controller in every distro has a least set of parameters, and cannot do with less."""

from __future__ import annotations

from sampling import assert_each

from urdfctl.catalog.catalog import CATALOG
from urdfctl.catalog.distros import ALL
from urdfctl.catalog.entries import ControllerType
from urdfctl.catalog.map_parameters import expected
from urdfctl.catalog.validators import problem
from urdfctl.catalog.value_types import type_problem
from urdfctl.control.claims import claims, exports
from urdfctl.control.parameters.gains import missing_gains
from urdfctl.control.parameters.minimal import minimal_parameters
from urdfctl.control.parameters.rules import breaches
from urdfctl.control.parameters.values import Values


def controllers() -> dict[str, ControllerType]:
    """Return each type of controller in each distro, by both names."""
    found = [CATALOG.controller(name, distro) for distro in ALL for name in CATALOG.known_types(distro)]
    return {f"{controller.distro}-{controller.type}": controller for controller in found if controller is not None}


def faults(controller: ControllerType, values: dict[str, object]) -> list[str]:
    """What the catalogue finds wrong with some parameters."""
    named = expected(controller.parameters, Values(controller, values))
    given = {name: parameter for name, parameter in named.items() if name in values}
    wrong = [f"{name} {type_problem(values[name], p, controller.distro)}" for name, p in given.items()]
    wrong += [f"{name} {problem(values[name], p.validators)}" for name, p in given.items()]
    missing = [f"{name} is missing" for name, p in named.items() if (p.needed or p.if_absent) and name not in values]
    broken = [f"{b.parameter} {b.message}" for b in breaches(controller, values) if b.rule.severity == "error"]
    gains = [f"{gain.name} is missing" for gain in missing_gains(controller, values)]
    return [fault for fault in wrong if not fault.endswith(" None")] + missing + broken + gains


def test_the_least_parameters_are_right_and_cannot_be_less() -> None:
    def check(controller: ControllerType) -> None:
        values = minimal_parameters(controller)
        assert faults(controller, values) == []
        for name in values:
            assert faults(controller, {other: value for other, value in values.items() if other != name}), name

    assert_each(check, controllers())


def test_what_is_claimed_with_them_is_known_and_no_command_is_claimed_twice() -> None:
    def check(controller: ControllerType) -> None:
        values = minimal_parameters(controller)
        claimed = claims(controller, "it", values)
        if claimed is not None:
            assert claimed.complete
            names = [claim.name for claim in claimed.command]
            assert len(names) == len(set(names))
            assert all(claim.component and claim.interface for claim in (*claimed.command, *claimed.state))
        exported = exports(controller, "it", values)
        assert exported.complete
        assert all(claim.name.startswith("it/") for claim in (*exported.reference, *exported.state))
        assert bool(exported.reference or exported.state) <= controller.chainable

    assert_each(check, controllers())


def test_a_default_has_the_type_of_its_parameter() -> None:
    def check(controller: ControllerType) -> None:
        for parameter in controller.parameters.values():
            if parameter.default is not None:
                assert type_problem(parameter.default, parameter, controller.distro) is None, parameter.name

    assert_each(check, controllers())


def test_a_trajectory_controller_needs_joints_and_interfaces() -> None:
    controller = CATALOG.controller("joint_trajectory_controller/JointTrajectoryController", "jazzy")
    assert controller is not None
    assert minimal_parameters(controller) == {
        "joints": ["joint1"],
        "command_interfaces": ["position"],
        "state_interfaces": ["position"],
    }


def test_a_ros_1_effort_trajectory_controller_needs_gains_for_each_joint() -> None:
    controller = CATALOG.controller("effort_controllers/JointTrajectoryController", "noetic")
    assert controller is not None
    assert minimal_parameters(controller) == {"joints": ["joint1"], "gains.joint1.p": 1.0}
