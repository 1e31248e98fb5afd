"""The catalogue's data on controllers and their parameters, for one distro."""

from __future__ import annotations

from collections.abc import Mapping
from functools import lru_cache
from types import MappingProxyType

from urdfctl.startup.records import NamedTuple

NOTHING: Mapping[str, object] = MappingProxyType({})


class ParameterEntry(NamedTuple):
    """A parameter of a controller or of the controller manager.

    name: dotted name, in which `<joints>` is a placeholder for each element of the parameter `joints`.
    type: a type of ros2_control (`double`, `string_array`), or several separated by bars; `none` is a subtree of any
        form.
    required: the controller refuses to load without it.
    default: default value; None if there is none.
    validators: checks that the controller makes; it refuses values that fail one.
    useful: checks that the controller does not make; values that fail one have no effect.
    floats_only: integers are refused.
    lenient: a value of another type is ignored with a message; elsewhere ROS 2 refuses it.
    if_absent: what a controller does that runs without the parameter: `crash` or `idle`.
    deprecated: the distro still reads it, but upstream wants it gone.
    replacement: the parameter to use instead.
    note: further advice for the message of a finding.
    since: first release of the distro that reads it; None for all releases.
    ignored: documented upstream, but never read.
    """

    name: str
    type: str
    required: bool = False
    default: object = None
    validators: Mapping[str, object] = NOTHING
    useful: Mapping[str, object] = NOTHING
    floats_only: bool = False
    if_absent: str | None = None
    deprecated: bool = False
    replacement: str | None = None
    note: str | None = None
    since: str | None = None
    ignored: bool = False
    lenient: bool = False

    @property
    def types(self) -> tuple[str, ...]:
        """The allowed types of a value."""
        return _types(self.type)

    @property
    def needed(self) -> bool:
        """Whether the controller refuses to load without it: it is required, or its default fails its validators."""
        if self.required or self.default is None or not self.validators:
            return self.required
        from urdfctl.catalog.validators import problem

        return problem(self.default, self.validators) is not None

    @property
    def is_map(self) -> bool:
        """Whether the name has a placeholder for each element of another parameter."""
        return "<" in self.name


@lru_cache(256)
def _types(text: str) -> tuple[str, ...]:
    return tuple(part.strip() for part in text.split("|"))


class FormerParameter(NamedTuple):
    """A parameter that a controller does not read in this distro, but in other distros or in earlier releases.

    distros: the other distros that read it.
    last_version: the last release of this distro that read it; None if none did.
    replacement: the parameter to use instead.
    note: further advice for the message of a finding.
    """

    name: str
    distros: tuple[str, ...] = ()
    last_version: str | None = None
    replacement: str | None = None
    note: str | None = None


class ParameterCondition(NamedTuple):
    """A condition on one parameter.

    param: name of the parameter.
    is_set: True or False: the condition holds if the parameter is set or not set; None: `value` decides.
    value: the condition holds if the parameter has this value.
    """

    param: str
    is_set: bool | None = None
    value: object = None


class ClaimRule(NamedTuple):
    """A rule that yields names of interfaces; data/README.md documents the fields."""

    for_each: str | None = None
    or_else: str | None = None
    components: tuple[str, ...] = ()
    movable_joints: bool = False
    all: bool = False
    names: tuple[str, ...] = ()
    names_from: str | None = None
    interfaces: tuple[str, ...] = ()
    interfaces_from: str | None = None
    interfaces_in: str | None = None
    prefix: str = ""
    best_effort: bool = False
    all_if_none: bool = False
    when: tuple[ParameterCondition, ...] = ()
    when_any: tuple[ParameterCondition, ...] = ()


class ClaimRules(NamedTuple):
    """The interfaces that a controller claims.

    command: command interfaces; in ROS 1, claimed exclusively.
    state: state interfaces, which it shares with other controllers.
    """

    command: tuple[ClaimRule, ...] = ()
    state: tuple[ClaimRule, ...] = ()


class ExportRules(NamedTuple):
    """The interfaces that a chainable controller exports to preceding controllers."""

    reference: tuple[ClaimRule, ...] = ()
    state: tuple[ClaimRule, ...] = ()


class ParameterRule(NamedTuple):
    """A constraint between several parameters.

    kind: the kind of constraint; data/README.md documents the kinds.
    params: the parameters that it concerns.
    severity: severity of a finding.
    when: conditions that must all hold for the constraint to apply.
    when_any: conditions of which at least one must hold, if there are any.
    details: further fields, which depend on the kind.
    """

    id: str
    kind: str
    params: tuple[str, ...]
    severity: str = "error"
    when: tuple[ParameterCondition, ...] = ()
    when_any: tuple[ParameterCondition, ...] = ()
    details: Mapping[str, object] = NOTHING


class Replacement(NamedTuple):
    """The replacement for a type.

    type: the type to use instead.
    parameters: parameters to set with it.
    note: further advice for the message of a finding.
    """

    type: str
    parameters: Mapping[str, object] = NOTHING
    note: str | None = None


class ControllerType(NamedTuple):
    """A controller type in one distro.

    parameters: the parameters by name, in the order of the upstream source.
    former: parameters that only other distros or earlier releases read.
    claims: None if unknown.
    exports: the interfaces that it exports as a chainable controller.
    rules: constraints between its parameters.
    external: the package is not part of ros_control or ros2_control, so the list of distros may be incomplete.
    since: first release of the distro that has the type; None for all releases.
    hardware_interfaces: ROS 1: the hardware interfaces that it uses.
    joint_parameters: the parameters that name joints.
    ignored: parameters that look valid but have no effect.
    needs_robot_description: it reads the robot description.
    joints_must_be_in_urdf: it refuses joints that the robot description does not have.
    publishes_joint_states: it publishes /joint_states.
    open: it may read other parameters too.
    needs_interface: the stage at which it is refused if it has no interface to claim; None if it is not.
    """

    type: str
    distro: str
    package: str
    parameters: Mapping[str, ParameterEntry]
    former: Mapping[str, FormerParameter]
    claims: ClaimRules | None
    exports: ExportRules = ExportRules()
    rules: tuple[ParameterRule, ...] = ()
    chainable: bool = False
    broadcaster: bool = False
    deprecated: bool = False
    replacement: Replacement | None = None
    external: bool = False
    since: str | None = None
    hardware_interfaces: tuple[str, ...] = ()
    joint_parameters: tuple[str, ...] = ()
    ignored: tuple[str, ...] = ()
    needs_robot_description: bool = False
    joints_must_be_in_urdf: bool = False
    publishes_joint_states: bool = False
    open: bool = False
    needs_interface: str | None = None

    @property
    def undeclared(self) -> tuple[str, ...]:
        """Parameters that the claims and rules use, but that are not declared for any distro."""
        known = {*self.parameters, *self.former}
        claims = [rule for group in (*(self.claims or ()), *self.exports) for rule in group]
        conditions = [condition for rule in (*claims, *self.rules) for condition in (*rule.when, *rule.when_any)]
        used = [
            *(name for rule in claims for name in (rule.for_each, rule.or_else, rule.names_from, rule.interfaces_from)),
            *(name for rule in self.rules for name in rule.params),
            *(condition.param for condition in conditions),
        ]
        unknown = dict.fromkeys(name for name in used if name and "{" not in name and name not in known)
        return tuple(name for name in unknown if not any(other.startswith(f"{name}.") for other in known))
