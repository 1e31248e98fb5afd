"""Build the graph of a project from what its controllers claim, as lint and smoke compute it."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence

from urdfctl.control.chains import chained_claims
from urdfctl.control.claims import Claim
from urdfctl.control.groups import Groups
from urdfctl.control.hardware.interfaces import Absence, ClaimKind
from urdfctl.control.session import Configured, Session, session_of
from urdfctl.diagnostic import Diagnostic, Severity, located
from urdfctl.graph.parts import Edge, Graph, GraphNode
from urdfctl.graph.topics import topics_of
from urdfctl.model.project import Project
from urdfctl.report.common import shown
from urdfctl.rules.claims.common import home, place_of
from urdfctl.source.opaque import UNKNOWN
from urdfctl.source.span import Place
from urdfctl.startup.records import NamedTuple

_UNKNOWN = "unknown"
"""The name of hardware that the description does not show."""


def graph_of(project: Project, findings: Sequence[Diagnostic]) -> Graph:
    """Return the graph of a project.

    findings: what lint found in it.
    """
    session = session_of(project, project.distro or project.distros[-1])
    builder = _GraphBuilder(project, session, _Errors(findings))
    builder.build()
    robot = project.robot.name if project.robot and project.robot.name else ""
    return Graph(
        robot=_shown(robot),
        file=project.path,
        distro=session.distro,
        complete=all(each.claims.complete for each in session.controllers),
        nodes=tuple(builder.nodes.values()),
        edges=tuple(builder.edges.values()),
    )


def is_broadcaster(each: Configured) -> bool:
    """Return whether a controller only reads."""
    if each.claims.command:
        return False
    return each.type.broadcaster if each.type is not None else bool(each.claims.state)


class _Errors:
    """Lint's errors by place."""

    def __init__(self, findings: Sequence[Diagnostic]) -> None:
        self._at: dict[tuple[str, int], list[Diagnostic]] = {}
        self._shown: set[int] = set()
        for finding in findings:
            if finding.severity is Severity.ERROR:
                self._at.setdefault((finding.at.file, finding.at.start), []).append(finding)

    def left(self) -> list[Diagnostic]:
        """Return the errors whose codes were not asked for so far."""
        return [error for errors in self._at.values() for error in errors if id(error) not in self._shown]

    def _codes(self, errors: Iterable[Diagnostic]) -> Iterator[str]:
        for error in errors:
            self._shown.add(id(error))
            yield error.code

    def within(self, place: Place) -> Iterator[str]:
        """Yield the codes of the errors in an element."""
        for errors in self._at.values():
            yield from self._codes(error for error in errors if is_within(error, place))

    def at(self, place: Place | None, words: Sequence[str] = ()) -> Iterator[str]:
        """Yield the codes of the errors at a place; if words are given, of those that name one of them."""
        at = located(place.span) if place is not None else None
        for error in self._at.get((at.file, at.start), ()) if at is not None else ():
            if not words or any(f"'{word}'" in error.message for word in words):
                yield from self._codes([error])


def is_within(error: Diagnostic, place: Place) -> bool:
    """Return whether an error is in an element."""
    return error.at.file == place.span.file and place.span.start <= error.at.start <= (place.closing or place.span.end)


class _Hardware(NamedTuple):
    """What is between a command interface and its joint."""

    name: str
    detail: str
    at: tuple[Place, ...]


class _GraphBuilder:
    def __init__(self, project: Project, session: Session, errors: _Errors) -> None:
        self.project, self.session, self.errors = project, session, errors
        self.nodes: dict[str, GraphNode] = {}
        self.edges: dict[tuple[str, str], Edge] = {}
        self._keys: dict[int, str] = {}

    def build(self) -> None:
        """Make all nodes and edges."""
        for each in self.session.controllers:
            self._keys[id(each)] = self._controller(each)
        for each in self.session.controllers:
            self._claims(each)
            self._topics(each)
        for kind in ClaimKind:
            for offers in self.session.hardware.offers(kind).values():
                for offer in offers:
                    self._behind(kind, Claim(offer.component, offer.interface), active=False)
        self._groups()
        for error in self.errors.left():
            kind_of, name, detail = self._about(error)
            self._node(kind_of, name, detail, rules=[error.code])

    def _about(self, error: Diagnostic) -> tuple[str, str, str]:
        """The part that an error is about, which nothing may be wired to: its kind, name and detail."""
        robot = self.project.robot
        for control in robot.ros2_controls if robot else ():
            if is_within(error, control.at):
                return "hardware", control.name or "?", control.plugin or ""
        for transmission in robot.transmissions if robot else ():
            if is_within(error, transmission.at):
                return "hardware", transmission.name or "?", transmission.type.value if transmission.type else ""
        for node in self.nodes.values():
            if node.kind in ("controller", "broadcaster", "hardware") and _names(error, node.name):
                return node.kind, node.name, node.detail
        for joint in robot.joints if robot else ():
            if joint.name and (is_within(error, joint.at) or _names(error, joint.name)):
                return "joint", joint.name, joint.type or ""
        for link in robot.links if robot else ():
            if link.name and (is_within(error, link.at) or _names(error, link.name)):
                return "link", link.name, ""
        return "file", shown(error.at.file), ""

    def _node(self, kind: str, name: str, detail: str = "", *, active: bool = True, rules: Sequence[str] = ()) -> str:
        """Make a node, or add to it, and return its id."""
        key = f"{kind}:{_shown(name)}"
        known = self.nodes.get(key, GraphNode(key, kind, _shown(name), active=False))
        rules = tuple(dict.fromkeys((*known.rules, *rules)))
        self.nodes[key] = known._replace(
            detail=_shown(detail) or known.detail, active=active or known.active, rules=rules
        )
        return key

    def _edge(self, source: str, target: str, kind: str, *, active: bool, rules: Sequence[str] = ()) -> None:
        known = self.edges.get((source, target), Edge(source, target, kind, active=False))
        rules = tuple(dict.fromkeys((*known.rules, *rules)))
        self.edges[source, target] = known._replace(active=active or known.active, rules=rules)

    # -- controllers -------------------------------------------------------------------------------------------------

    def _is_active(self, each: Configured) -> bool:
        return self.session.started is None or any(each is one for one in self.session.started)

    def _controller(self, each: Configured) -> str:
        own = each.controller
        rules = [*self.errors.at(own.type.at if own.type is not None else None), *self.errors.at(own.declared_at)]
        kind = "broadcaster" if is_broadcaster(each) else "controller"
        detail = own.type.text if own.type is not None else ""
        return self._node(kind, own.full_name, detail, active=self._is_active(each), rules=rules)

    def _claims(self, each: Configured) -> None:
        key, active = self._keys[id(each)], self._is_active(each)
        following = {(one.kind, one.claim.name): one.following for one in chained_claims(self.session, each)}
        for kind in ClaimKind:
            for claim in each.claimed(kind):
                other = following.get((kind, claim.name))
                if other is None:
                    interface = self._behind(kind, claim, active=active)
                else:
                    interface = self._exported(kind, claim, self._keys[id(other)], active=active)
                rules = self._rules_of(each, claim)
                if kind is ClaimKind.COMMAND:
                    self._edge(key, interface, "claims", active=active, rules=rules)
                else:
                    self._edge(interface, key, "reads", active=active, rules=rules)

    def _rules_of(self, each: Configured, claim: Claim) -> list[str]:
        """The codes of lint's errors about a claim: at its parameter, or at the controller's type or key if they name
        it; if nothing offers the interface, those in the parts of the description that should."""
        own = each.controller
        around = [place for place in (home(own), own.declared_at) if place is not None]
        found: list[str] = []
        for place in (place_of(each, claim), place_of(each, claim, of_interface=True)):
            if place is not None and not any(place.is_same(one) for one in around):
                found += self.errors.at(place, (claim.name, claim.component, claim.interface) if own.parameters else ())
        for place in around:
            found += self.errors.at(place, (claim.name, claim.component, claim.interface))
        if any(missing.claim is claim for missing in each.missing):
            found += [code for place in self._offering(claim.component) for code in self.errors.within(place)]
        return found

    def _offering(self, component: str) -> Iterator[Place]:
        """The parts of the description that should offer the interfaces of a component."""
        robot = self.project.robot
        for transmission in robot.transmissions if robot else ():
            if component in {joint.name for joint in transmission.joints}:
                yield transmission.at
        for control in robot.ros2_controls if robot else ():
            yield from (part.at for part in control.parts if part.name == component)

    def _topics(self, each: Configured) -> None:
        key, active, own = self._keys[id(each)], self._is_active(each), each.controller
        kind = own.type.text if own.type is not None else None
        topics = topics_of(kind, self.session.distro, each.values)
        for names, way in ((topics.subscribes, "topic"), (topics.actions, "action")):
            for name in names:
                node = self._node("input", _full(name, each), way, active=active)
                self._edge(node, key, "commands", active=active)
        for name in topics.publishes:
            node = self._node("output", _full(name, each), "topic", active=active)
            self._edge(key, node, "publishes", active=active)

    # -- interfaces --------------------------------------------------------------------------------------------------

    def _exported(self, kind: ClaimKind, claim: Claim, other: str, *, active: bool) -> str:
        """Make the interface of another controller, and return its id."""
        key = self._node(kind.value, claim.name, claim.interface, active=active)
        if kind is ClaimKind.COMMAND:
            self._edge(key, other, "commands", active=active)
        else:
            self._edge(other, key, "publishes", active=active)
        return key

    def _behind(self, kind: ClaimKind, claim: Claim, *, active: bool) -> str:
        """Make an interface of the hardware, and the way from it to the joint or back, and return its id."""
        key = self._node(kind.value, claim.name, claim.interface, active=active)
        if self.session.hardware.absence(kind, claim.component, claim.interface) is Absence.SURE:
            return key
        rules = [code for place in self._places_of(claim.component) for code in self.errors.at(place)]
        joint = self._node("joint", claim.component, self._type_of(claim.component), active=active, rules=rules)
        if kind is ClaimKind.STATE:
            self._edge(joint, key, "measures", active=active)
            return key
        for hardware in self._hardware(claim):
            codes = [code for place in hardware.at for code in self.errors.at(place)]
            node = self._node("hardware", hardware.name, hardware.detail, active=active, rules=codes)
            self._edge(key, node, "drives", active=active)
            self._edge(node, joint, "moves", active=active)
        return key

    def _hardware(self, claim: Claim) -> list[_Hardware]:
        """The hardware components that offer a command interface; in ROS 1, the joint's transmissions."""
        robot = self.project.robot
        offers = self.session.hardware.of(ClaimKind.COMMAND, claim.component)
        names = {offer.by for offer in offers if offer.interface == claim.interface and offer.by}
        found = []
        for component in robot.ros2_controls if robot else ():
            if component.name in names:
                places = (component.at, *(one.at for one in component.hardware))
                found.append(_Hardware(component.name or "", component.plugin or "", places))
        for transmission in robot.transmissions if robot else ():
            if claim.component in {joint.name for joint in transmission.joints}:
                kind = transmission.type.value if transmission.type else ""
                found.append(_Hardware(transmission.name or claim.component, kind, (transmission.at,)))
        return found or [_Hardware(_UNKNOWN, "", ())]

    def _type_of(self, component: str) -> str:
        robot = self.project.robot
        joint = robot.joint(component) if robot else None
        if joint is not None:
            return joint.type or ""
        parts = (part for control in (robot.ros2_controls if robot else ()) for part in control.parts)
        return next((part.kind for part in parts if part.name == component), "")

    def _places_of(self, component: str) -> list[Place]:
        joint = self.project.robot.joint(component) if self.project.robot else None
        return [joint.at, joint.at["name"]] if joint is not None else []

    # -- MoveIt ------------------------------------------------------------------------------------------------------

    def _groups(self) -> None:
        """Make the planning groups, and the actions to which MoveIt sends their trajectories."""
        moveit, robot = self.project.moveit, self.project.robot
        if moveit is None or moveit.semantic is None or robot is None:
            return
        groups = Groups(robot, moveit.semantic)
        for group in moveit.semantic.groups:
            joints = set(groups.active(group))
            for controller in moveit.controllers:
                if not joints & {joint.text for joint in controller.joints}:
                    continue
                action = controller.action.text if controller.action else "follow_joint_trajectory"
                name = f"/{controller.name.text.strip('/')}/{action.strip('/')}"
                known = self.nodes.get(f"input:{_shown(name)}")
                codes = [*self.errors.at(controller.name.at), *self.errors.at(group.name.at)]
                target = self._node("input", name, "action", active=known is not None and known.active)
                source = self._node("group", group.name.text, "MoveIt")
                self._edge(source, target, "plans", active=True, rules=codes)


def _full(name: str, each: Configured) -> str:
    """The full name of a topic of a controller."""
    own = each.controller
    if name.startswith("~/"):
        return f"/{own.full_name.strip('/')}/{name[2:]}"
    space = (own.namespace or "").strip("/")
    return f"/{space}{name}" if space and name != "/tf" else name


def _names(error: Diagnostic, name: str) -> bool:
    """Whether an error's message names a part, with or without its namespace."""
    return f"'{name}'" in error.message or f"'{name.strip('/').rpartition('/')[2]}'" in error.message


def _shown(text: str) -> str:
    return text.replace(UNKNOWN, "?")
