"""What the catalogue tells of controllers and their parameters, for one distro."""

from __future__ import annotations

from collections.abc import Mapping
from functools import lru_cache
from types import MappingProxyType

from urdfctl.record import NamedTuple

NOTHING: Mapping[str, object] = MappingProxyType({})


class Parameter(NamedTuple):
    """A parameter. In its dotted `name`, `<joints>` stands for each element of the parameter `joints`.

    `type` is one of ros2_control's (`double`, `string_array`), or several between bars; `none` is a subtree of free
    form. A `default` of None is no default. Values that break the `validators` are refused, those that break what is
    `useful` are taken and do nothing. `floats_only`: integers among its numbers are refused. `if_absent`: a controller
    that runs without it will `crash`, or `idle`. `since` is the first release of the distro that reads it. One that is
    `ignored` is documented, and read by nobody.
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

    @property
    def types(self) -> tuple[str, ...]:
        """The types that a value may have."""
        return _types(self.type)

    @property
    def needed(self) -> bool:
        """Whether leaving it out is refused: there is no default, or one that its own validators refuse."""
        if self.required or self.default is None or not self.validators:
            return self.required
        from urdfctl.catalog.validators import problem

        return problem(self.default, self.validators) is not None

    @property
    def is_map(self) -> bool:
        """Whether it stands for one parameter for each element of another."""
        return "<" in self.name


@lru_cache(256)
def _types(text: str) -> tuple[str, ...]:
    return tuple(part.strip() for part in text.split("|"))


class FormerParameter(NamedTuple):
    """A parameter that a controller does not read in a distro, but in others or in earlier releases of it."""

    name: str
    distros: tuple[str, ...] = ()
    last_version: str | None = None
    replacement: str | None = None
    note: str | None = None


class Condition(NamedTuple):
    """Holds where a parameter is set or not (`is_set`), or else where it has the value `value`."""

    param: str
    is_set: bool | None = None
    value: object = None


class ClaimRule(NamedTuple):
    """Yields names of interfaces; the grammar is told in data/README.md."""

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
    when: tuple[Condition, ...] = ()
    when_any: tuple[Condition, ...] = ()


class ClaimRules(NamedTuple):
    """What a controller claims: commands (in ROS 1: exclusively), and states that it shares."""

    command: tuple[ClaimRule, ...] = ()
    state: tuple[ClaimRule, ...] = ()


class ExportRules(NamedTuple):
    """What a chainable controller offers to those before it."""

    reference: tuple[ClaimRule, ...] = ()
    state: tuple[ClaimRule, ...] = ()


class ParameterRule(NamedTuple):
    """A rule that joins several parameters; `details` are those of its `kind`, told in data/README.md."""

    id: str
    kind: str
    params: tuple[str, ...]
    severity: str = "error"
    when: tuple[Condition, ...] = ()
    when_any: tuple[Condition, ...] = ()
    details: Mapping[str, object] = NOTHING


class Replacement(NamedTuple):
    """What takes the place of a type, with the parameters to set."""

    type: str
    parameters: Mapping[str, object] = NOTHING
    note: str | None = None


class ControllerType(NamedTuple):
    """A type of controller as one distro has it.

    `claims` is None where the catalogue does not know them. `parameters` are by name, in the order of their source;
    `former` are those that only other distros or releases read. Of an `external` one, of another package than
    ros_control's and ros2_control's own, the distros are not sure. `ignored` parameters look right and do nothing.
    """

    type: str
    distro: str
    package: str
    parameters: Mapping[str, Parameter]
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

    @property
    def undeclared(self) -> tuple[str, ...]:
        """Parameters that its claims and rules speak of, and no distro's has."""
        known = {*self.parameters, *self.former}
        claims = [rule for part in (*(self.claims or ()), *self.exports) for rule in part]
        conditions = [condition for rule in (*claims, *self.rules) for condition in (*rule.when, *rule.when_any)]
        spoken = [
            *(name for rule in claims for name in (rule.for_each, rule.or_else, rule.names_from, rule.interfaces_from)),
            *(name for rule in self.rules for name in rule.params),
            *(condition.param for condition in conditions),
        ]
        named = dict.fromkeys(name for name in spoken if name and "{" not in name and name not in known)
        return tuple(name for name in named if not any(one.startswith(f"{name}.") for one in known))
