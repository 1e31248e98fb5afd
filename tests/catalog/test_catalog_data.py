"""The data of the catalogue is sound, and what the program reads is what people edit."""

from __future__ import annotations

import pytest
from sampling import assert_each

from urdfctl.catalog.catalog import CATALOG
from urdfctl.catalog.compiled import files
from urdfctl.catalog.distros import ALL, ROS1, spanned
from urdfctl.catalog.store import plain
from urdfctl.catalog.validators import NAMES
from urdfctl.control.hardware.gazebo_ros1 import GAZEBO_INTERFACES
from urdfctl.rules.transmissions import facts


@pytest.mark.parametrize(("path", "text"), [pytest.param(*file, id=file[0].name) for file in files()])
def test_the_compiled_data_is_that_of_the_yaml(path: object, text: str) -> None:
    assert path.read_text(encoding="utf-8") == text, "run python -m urdfctl.catalog.compiled"  # type: ignore[attr-defined]


def test_all_that_a_controller_speaks_of_is_one_of_its_parameters() -> None:
    def check(case: tuple[str, str]) -> None:
        controller = CATALOG.controller(*case)
        assert controller is not None
        assert controller.undeclared == (), "the entry's claims or rules name what is not in its parameters"
        for parameter in controller.parameters.values():
            assert set(parameter.validators) | set(parameter.useful) <= NAMES

    assert_each(check, {f"{distro}-{name}": (name, distro) for distro in ALL for name in CATALOG.known_types(distro)})


@pytest.mark.parametrize("ros", [1, 2])
def test_what_replaces_a_type_is_known(ros: int) -> None:
    for kind in ("controllers", "hardware"):
        entries = plain(ros, kind)
        for entry in entries.values():
            if "replacement" in entry:
                assert entry["replacement"]["type"] in entries
            for key in ("distros", "deprecated", "removed"):
                if isinstance(entry.get(key), str):
                    assert spanned(entry[key], ros)


@pytest.mark.parametrize("distro", ROS1)
def test_the_rules_on_transmissions_know_what_the_catalogue_knows(distro: str) -> None:
    """Their tables stand in the code: reading the catalogue would cost each robot of ROS 1 two milliseconds."""
    for name, expected in facts.TYPES.items():
        found = CATALOG.transmission(name, distro)
        assert found is not None
        assert (found.joints, found.actuators, bool(found.joint_roles)) == expected
        if found.joint_roles:
            assert (found.joint_roles, found.actuator_roles) == (facts.JOINT_ROLES, facts.ACTUATOR_ROLES)
    interfaces = CATALOG.hardware_interfaces(distro).values()
    accepted = {found.name.removeprefix(facts.PREFIX) for found in interfaces if found.in_gazebo == "accepted"}
    assert accepted == set(GAZEBO_INTERFACES)
    known = {*GAZEBO_INTERFACES, *facts.HARDWARE_INTERFACES}
    of_joints = {found.name for found in interfaces if found.resource == "joint" or found.kind == "transmission_only"}
    assert {name.removeprefix(facts.PREFIX) for name in of_joints} <= known


def test_the_hardware_interfaces_are_those_of_ros_1() -> None:
    assert CATALOG.hardware_interfaces("noetic")["hardware_interface/JointStateInterface"].in_gazebo == "registered"
    assert "hardware_interface/JointModeInterface" not in CATALOG.hardware_interfaces("indigo")
    assert CATALOG.hardware_interfaces("jazzy") == {}
