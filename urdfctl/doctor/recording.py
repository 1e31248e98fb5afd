"""A recording of a running system: what its nodes, topics, controller managers and parameters answered."""

from __future__ import annotations

import json
from collections.abc import Iterator, Mapping, Sequence
from typing import Any

from urdfctl.errors import UserError
from urdfctl.source.disk.files import first_bytes
from urdfctl.startup.records import NamedTuple

_MOST_BYTES = 64 << 20
_PARTS = ("nodes", "topics", "controller_managers", "parameters")
"""What every recording has."""
LEFT_OUT = "left out"
"""What the collector writes instead of a private value."""
_STATES_OF_ROS1 = {"running": "active", "stopped": "inactive", "initialized": "inactive"}


class TopicEnd(NamedTuple):
    """A publisher or a subscription of a topic. node: its full name."""

    node: str
    type: str
    durability: str
    reliability: str


class RecordedTopic(NamedTuple):
    """A topic with its ends."""

    name: str
    publishers: tuple[TopicEnd, ...]
    subscriptions: tuple[TopicEnd, ...]


class RecordedController(NamedTuple):
    """A controller that a manager lists.

    claimed: the command interfaces that it holds.
    commands, states: the interfaces that it requires.
    references: the interfaces that it exports to controllers before it.
    """

    name: str
    state: str
    type: str
    claimed: tuple[str, ...]
    commands: tuple[str, ...]
    states: tuple[str, ...]
    references: tuple[str, ...] = ()


class RecordedHardware(NamedTuple):
    """A hardware component that a manager lists. commands, states: the interfaces that it exports."""

    name: str
    state: str
    plugin: str
    commands: tuple[str, ...] = ()
    states: tuple[str, ...] = ()


class RecordedManager(NamedTuple):
    """A controller manager.

    answers: whether it listed its controllers.
    exported: the names of the command and state interfaces that its hardware and its chained controllers export.
    types: the types of controllers that can be loaded.
    """

    name: str
    answers: bool
    controllers: tuple[RecordedController, ...] = ()
    hardware: tuple[RecordedHardware, ...] = ()
    exported: frozenset[str] = frozenset()
    types: frozenset[str] = frozenset()

    @property
    def namespace(self) -> str:
        """Its namespace; empty for the root."""
        return self.name.rpartition("/")[0]

    def controller(self, name: str) -> RecordedController | None:
        """Return one of its controllers; None if it does not list it."""
        return next((one for one in self.controllers if one.name == name), None)


class JointStates(NamedTuple):
    """What was received on a topic of joint states.

    received: how many messages.
    names: the joints of all messages.
    writers: how many different publishers sent messages.
    rate: messages per second.
    numbers: the position of each joint in the last message; None where it is not finite.
    lists: the joints of the messages, once for each different list.
    stamps: the time stamps in s, those of the first and last message at least.
    """

    topic: str
    received: int
    names: frozenset[str]
    writers: int
    rate: float
    numbers: Mapping[str, float | None]
    lists: tuple[tuple[str, ...], ...] = ()
    stamps: tuple[float, ...] = ()


class RecordedTransform(NamedTuple):
    """A transform that was received on a topic.

    writers: how many different publishers sent it. received: how often. first, last: its time stamps in s.
    """

    topic: str
    parent: str
    child: str
    writers: int
    received: int
    first: float | None
    last: float | None


class Recording(NamedTuple):
    """A recording. data: its JSON."""

    path: str
    data: Mapping[str, Any]

    @property
    def is_of_ros1(self) -> bool:
        """Whether the system is of ROS 1: its parameters are on a server, and topics have no QoS."""
        return _map(self.data.get("recorded")).get("how") == "rospy"

    @property
    def nodes(self) -> tuple[str, ...]:
        """The full names of all nodes."""
        return tuple(_full(node) for node in _maps(self.data["nodes"]))

    @property
    def topics(self) -> dict[str, RecordedTopic]:
        """The topics by name."""
        return {topic.name: topic for topic in map(_topic, _maps(self.data["topics"]))}

    @property
    def services(self) -> frozenset[str]:
        """The names of all services."""
        return frozenset(str(one.get("name", "")) for one in _maps(self.data.get("services", ())))

    @property
    def managers(self) -> dict[str, RecordedManager]:
        """The controller managers by full name."""
        return {name: _manager(name, answers) for name, answers in _items(self.data["controller_managers"])}

    @property
    def distro(self) -> str | None:
        """The ROS distro, if the recording names it."""
        value = _map(self.data.get("recorded")).get("distro")
        return value if isinstance(value, str) else None

    @property
    def descriptions(self) -> dict[str, tuple[str, ...]]:
        """The texts that were received on each topic of a robot description."""
        found = _items(self.data.get("robot_description", {}))
        return {topic: tuple(str(one["data"]) for one in _maps(sent) if "data" in one) for topic, sent in found}

    @property
    def joint_states(self) -> dict[str, JointStates]:
        """What was received on each topic of joint states."""
        found = _items(self.data.get("joint_states", {}))
        return {topic: _joint_states(topic, sent) for topic, sent in found if isinstance(sent, dict)}

    @property
    def has_clock(self) -> bool:
        """Whether anything publishes the time of a simulation."""
        clock = self.topics.get("/clock")
        return clock is not None and bool(clock.publishers)

    @property
    def clock_advances(self) -> bool:
        """Whether messages on /clock, if any were recorded, have different times."""
        clock = _map(self.data.get("clock"))
        return "first" not in clock or clock["first"] != clock.get("last")

    @property
    def transforms(self) -> Iterator[RecordedTransform]:
        """Yield the transforms that were received."""
        for topic, sent in _items(self.data.get("tf", {})):
            for one in _maps(sent):
                count = one.get("count")
                yield RecordedTransform(
                    topic,
                    parent=str(one.get("parent")),
                    child=str(one.get("child")),
                    writers=len(_map(one.get("publishers"))),
                    received=count if isinstance(count, int) else 0,
                    first=_seconds(one.get("first_stamp")),
                    last=_seconds(one.get("last_stamp")),
                )

    @property
    def said(self) -> tuple[str, ...]:
        """The messages of all diagnostics."""
        topics = _items(self.data.get("diagnostics", {}))
        return tuple(str(_map(status).get("message", "")) for _, by_name in topics for _, status in _items(by_name))

    def parameters(self, node: str) -> dict[str, Any]:
        """Return the parameters of a node, by its full name; none if it did not answer."""
        if self.is_of_ros1:
            every = _map(_map(self.data["parameters"].get("/")).get("values"))
            below = f"{node}/"
            return {name[len(below) :].replace("/", "."): one for name, one in every.items() if name.startswith(below)}
        return dict(_map(_map(self.data["parameters"].get(node)).get("values")))


def read_recording(path: str) -> Recording:
    """Return the recording in a file. UserError if it is none."""
    try:
        text = first_bytes(path, _MOST_BYTES + 1)
    except OSError as error:
        raise UserError(f"'{path}' cannot be read: {error.strerror}") from None
    if len(text) > _MOST_BYTES:
        raise UserError(f"'{path}' is not a recording: larger than {_MOST_BYTES >> 20} MiB")
    return recording_of(path, text)


def recording_of(path: str, text: bytes | str) -> Recording:
    """Return the recording in a text. UserError if it is none; path: what it is called there."""
    try:
        data = json.loads(text)
    except (ValueError, RecursionError) as error:
        raise UserError(f"'{path}' is not a recording: invalid JSON: {error}") from None
    if not isinstance(data, dict):
        raise UserError(f"'{path}' is not a recording: it is no JSON object")
    for part in _PARTS:
        wanted = list if part in ("nodes", "topics") else dict
        if not isinstance(data.get(part), wanted):
            raise UserError(f"'{path}' is not a recording: it has no '{part}'")
    return Recording(path, data)


def _map(value: object) -> Mapping[str, Any]:
    return value if isinstance(value, dict) else {}


def _maps(value: object) -> Iterator[Mapping[str, Any]]:
    return (one for one in value if isinstance(one, dict)) if isinstance(value, list) else iter(())


def _items(value: object) -> Iterator[tuple[str, Any]]:
    """The parts of an answer by name; none if there was only an error."""
    return ((name, part) for name, part in _map(value).items() if name != "error")


def _texts(value: object) -> tuple[str, ...]:
    return tuple(map(str, value)) if isinstance(value, list) else ()


def _seconds(value: object) -> float | None:
    """A time stamp in s, which may be written as a text."""
    try:
        return float(value) if isinstance(value, str | int | float) else None
    except ValueError:
        return None


def _full(node: Mapping[str, Any]) -> str:
    name = str(node.get("name") or node.get("node") or "")
    return f"{str(node.get('namespace') or '').rstrip('/')}/{name}"


def _topic(topic: Mapping[str, Any]) -> RecordedTopic:
    publishers, subscriptions = (
        tuple(map(_end, _maps(topic.get(side, [])))) for side in ("publishers", "subscriptions")
    )
    return RecordedTopic(str(topic.get("name", "")), publishers, subscriptions)


def _end(end: Mapping[str, Any]) -> TopicEnd:
    qos = _map(end.get("qos"))
    kind = str(end.get("type", ""))
    if kind.count("/") == 1:  # ROS 1
        kind = kind.replace("/", "/msg/")
    return TopicEnd(_full(end), kind, str(qos.get("durability", "")), str(qos.get("reliability", "")))


def _manager(name: str, answers: object) -> RecordedManager:
    found = _map(answers)
    listed = _map(found.get("list_controllers"))
    if not isinstance(listed.get("controller"), list):
        return RecordedManager(name, answers=False)
    interfaces = _map(found.get("list_hardware_interfaces"))
    both = (*_maps(interfaces.get("command_interfaces", [])), *_maps(interfaces.get("state_interfaces", [])))
    return RecordedManager(
        name,
        answers=True,
        controllers=tuple(map(_controller, _maps(listed["controller"]))),
        hardware=tuple(map(_hardware, _maps(_map(found.get("list_hardware_components")).get("component", [])))),
        exported=frozenset(str(one.get("name", "")) for one in both),
        types=frozenset(_texts(_map(found.get("list_controller_types")).get("types"))),
    )


def _controller(one: Mapping[str, Any]) -> RecordedController:
    return RecordedController(
        name=str(one.get("name", "")),
        state=_STATES_OF_ROS1.get(str(one.get("state", "")), str(one.get("state", ""))),
        type=str(one.get("type", "")),
        claimed=_texts(one.get("claimed_interfaces")),
        commands=_texts(one.get("required_command_interfaces")),
        states=_texts(one.get("required_state_interfaces")),
        references=tuple(f"{one.get('name')}/{name}" for name in _texts(one.get("reference_interfaces"))),
    )


def _hardware(one: Mapping[str, Any]) -> RecordedHardware:
    state = _map(one.get("state"))
    commands, states = (
        tuple(str(each.get("name", "")) for each in _maps(one.get(f"{kind}_interfaces")))
        for kind in ("command", "state")
    )
    plugin = str(one.get("plugin_name", ""))
    return RecordedHardware(str(one.get("name", "")), str(state.get("label", "")), plugin, commands, states)


def _joint_states(topic: str, sent: Mapping[str, Any]) -> JointStates:
    lists: Sequence[object] = sent.get("name_lists") or []
    last = _map(sent.get("last"))
    texts = sent.get("stamps") or [_map(sent.get("first")).get("stamp"), last.get("stamp")]
    positions = last.get("position")
    numbers = dict(zip(_texts(last.get("name")), positions if isinstance(positions, list) else (), strict=False))
    rate = sent.get("rate_hz")
    count = sent.get("count")
    return JointStates(
        topic,
        received=count if isinstance(count, int) else 0,
        names=frozenset(name for names in lists for name in _texts(names)),
        writers=len(_map(sent.get("publishers"))),
        rate=float(rate) if isinstance(rate, int | float) else 0.0,
        numbers={name: float(one) if isinstance(one, int | float) else None for name, one in numbers.items()},
        lists=tuple(map(_texts, lists)),
        stamps=tuple(one for one in map(_seconds, texts if isinstance(texts, list) else ()) if one is not None),
    )
