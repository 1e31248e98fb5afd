"""What keeps a started simulation from running its controllers: what gz, the robot, its controller manager and the
spawners expect of each other, as their programs see it."""

from __future__ import annotations

import os
import re
from collections.abc import Iterator, Mapping, Sequence
from typing import Any
from xml.etree import ElementTree as ET

import yaml

CREATE = frozenset("-world -file -param -string -topic -name -allow_renaming -x -y -z -R -P -Y -model_name".split())
"""The options of ros_gz_sim's create (create.cpp)."""
SPAWNER = frozenset(
    """
    -c --controller-manager -p --param-file -n --namespace --load-only --inactive -u --unload-on-kill
    --activate-as-group
    --controller-manager-timeout --switch-timeout --service-call-timeout --switch-asap --no-switch-asap
    --controller-ros-args --ros-args --stopped -t --controller-type
    """.split()
)
WITH_VALUE = SPAWNER - {"--load-only", "--inactive", "--stopped", "-u", "--unload-on-kill", "--activate-as-group"}
Started = Sequence[Mapping[str, Any]]


def resolved(name: str, namespace: str, remaps: Sequence[Sequence[str]] = ()) -> str:
    """The full name of a topic or node."""
    name = next((new for old, new in remaps if old.strip("/") == name.strip("/")), name)
    return name if name.startswith("/") else "/" + f"{namespace.strip('/')}/{name}".strip("/")


def faults(started: Started) -> list[str]:
    """Return what keeps the robots from being simulated and controlled, each as a sentence."""
    return [*_of_gz(started), *_of_files(started), *_of_controllers(started), *_of_nodes(started)]


def spawned(started: Started) -> set[str]:
    """Return the full names of the controllers that are spawned."""
    found: set[str] = set()
    for one in _nodes(started, "spawner"):
        names, options = _spawned(one["words"])
        manager = resolved(options.get("-c", ["controller_manager"])[-1], one["namespace"])
        found |= {resolved(name, manager.rpartition("/")[0]) for name in names}
    return found


def _nodes(started: Started, program: str) -> list[Mapping[str, Any]]:
    return [one for one in started if one["kind"] == "node" and one["executable"] == program]


def published(started: Started) -> dict[str, str]:
    """Return the descriptions that are published, by topic."""
    return {
        resolved("robot_description", one["namespace"], one["remaps"]): one["values"].get("robot_description", "")
        for one in _nodes(started, "robot_state_publisher")
    }


def _of_gz(started: Started) -> Iterator[str]:
    gz = [one for one in started if one["kind"] == "include" and "gz_sim" in os.path.basename(one["file"])]
    gz = [one for one in gz if "-g" not in one["arguments"].get("gz_args", "").split()]  # a window alone
    created = _nodes(started, "create")
    if created and not gz:
        yield "a robot is created, but gz is not started"
    for one in gz:
        yield from _of_world(one["arguments"].get("gz_args", "").split())
    for one in created:
        yield from _of_create(one, started)
    clock = [one for one in _nodes(started, "parameter_bridge") if _bridges_clock(one)]
    if len(clock) != bool(gz):
        yield f"/clock has {len(clock)} bridges"


def _of_world(words: Sequence[str]) -> Iterator[str]:
    world = [word for word in words if not word.startswith("-") and not word.isdigit()]
    if not world:
        yield f"gz has no world: gz_args is '{' '.join(words)}'"
    if "-r" not in words:
        yield "gz does not run"
    for word in world:
        if word.startswith("/") and not word.startswith("/stand_in/") and not os.path.isfile(word):
            yield f"the world {word} does not exist"


def _of_create(create: Mapping[str, Any], started: Started) -> Iterator[str]:
    wrong = [word for word in create["words"] if re.match(r"--?[a-zA-Z]", word) and word not in CREATE]
    if wrong:
        yield f"create has no option {wrong}"
    given = dict(zip(create["words"], create["words"][1:], strict=False))
    topic = resolved(given.get("-topic", ""), create["namespace"], create["remaps"])
    if "-topic" in given and topic not in published(started):
        yield f"create waits for {topic}, published are {sorted(published(started))}"


def _bridges_clock(bridge: Mapping[str, Any]) -> bool:
    file = bridge["values"].get("config_file")
    texts = list(bridge["words"])
    if file and os.path.isfile(file):
        with open(file, encoding="utf-8") as stream:
            texts += [str(one.get("ros_topic_name")) for one in yaml.safe_load(stream) or []]
    return any(text.split("@")[0] in ("/clock", "clock") for text in texts)


def _of_files(started: Started) -> Iterator[str]:
    for one in started:
        paths = [*one.get("files", []), *(word for word in one.get("words", []) if word.startswith("/"))]
        if one["kind"] == "include" and not one["file"].startswith("/stand_in/") and not one["is_there"]:
            yield f"{one['file']} does not exist"
        for path in paths:
            if os.path.splitext(path)[1] in (".yaml", ".rviz", ".urdf", ".xacro", ".sdf") and not os.path.isfile(path):
                yield f"{path} does not exist"
        path = one.get("values", {}).get("config_file", "")
        if path and not os.path.isfile(path):
            yield f"{path} does not exist"


def _of_controllers(started: Started) -> Iterator[str]:
    spawners = _nodes(started, "spawner")
    managers: dict[str, list[str]] = {}
    topics = published(started)
    for text in topics.values() if _nodes(started, "create") else ():
        for plugin in ET.fromstring(text or "<robot/>").iter("plugin"):
            if "ros2_control" in plugin.get("filename", ""):
                yield from _of_plugin(plugin, topics, managers)
    for one in _nodes(started, "ros2_control_node"):
        managers[resolved(one["name"] or "controller_manager", one["namespace"])] = list(one["files"])
    if bool(spawners) != bool(managers):
        yield f"{len(spawners)} spawners, {len(managers)} managers"
    for one in spawners:
        yield from _of_spawner(one, managers)


def _of_plugin(plugin: ET.Element, topics: Mapping[str, str], managers: dict[str, list[str]]) -> Iterator[str]:
    space = (plugin.findtext("ros/namespace") or "").strip("/")
    remaps = [one.text.split(":=") for one in plugin.iterfind("ros/remapping") if one.text]
    read = resolved("robot_description", space, remaps)
    if read not in topics:
        yield f"the manager in '/{space}' reads {read}, published are {sorted(topics)}"
    files = [one.text.strip() for one in plugin.iterfind("parameters") if one.text]
    managers[resolved("controller_manager", space)] = files
    yield from (f"{file} of the plugin does not exist" for file in files if not os.path.isfile(file))


def _of_spawner(spawner: Mapping[str, Any], managers: Mapping[str, list[str]]) -> Iterator[str]:
    names, options = _spawned(spawner["words"])
    manager = resolved(options.get("-c", ["controller_manager"])[-1], spawner["namespace"])
    wrong = [word for word in spawner["words"] if word.startswith("-") and _option(word) is None]
    if wrong:
        yield f"spawner has no option {wrong}"
    if manager not in managers:
        yield f"the spawner of {names} waits for {manager}, there are {sorted(managers)}"
        return
    if not names:
        yield "a spawner names no controller"
    files = [*managers[manager], *options.get("-p", [])]
    for name in names:
        if not any("type" in _parameters(file, manager).get(name, {}) for file in files):
            yield f"'{name}' has no type for {manager} in {files}"
        full = resolved(name, manager.rpartition("/")[0])
        has_own = any(_parameters(file, full) for file in files)
        if not has_own and "broadcaster" not in name and "state" not in name:
            yield f"'{full}' has no parameters in {files}"


def _spawned(words: Sequence[str]) -> tuple[list[str], dict[str, list[str]]]:
    names: list[str] = []
    options: dict[str, list[str]] = {}
    rest = iter(words)
    short = {"--controller-manager": "-c", "--param-file": "-p"}
    for word in rest:
        option = _option(word)
        if option in WITH_VALUE:
            value = word.partition("=")[2] if "=" in word else next(rest, "")
            options.setdefault(short.get(option, option), []).append(value)
        elif not word.startswith("-"):
            names.append(word)
    return names, options


def _option(word: str) -> str | None:
    """The option of the spawner that a word is, as argparse reads it: also by its beginning, and with `=`."""
    name = word.partition("=")[0]
    found = [name] if name in SPAWNER else [one for one in SPAWNER if word[:2] == "--" and one.startswith(name)]
    return found[0] if len(found) == 1 else None


def _parameters(file: str, node: str) -> dict[str, Any]:
    """The parameters of a file for a node, by its full name or a wildcard."""
    if not os.path.isfile(file):
        return {}
    with open(file, encoding="utf-8") as stream:
        content = yaml.safe_load(stream) or {}
    found: dict[str, Any] = {}
    for name, value in _flat(content):
        pattern = re.sub(r"\\\*\\\*/", "(.*/)?", re.escape(name.strip("/")))
        pattern = pattern.replace(r"\*\*", ".*").replace(r"\*", "[^/]+")
        if re.fullmatch(pattern, node.strip("/")):
            found |= value
    return found


def _flat(content: Any, above: str = "") -> Iterator[tuple[str, dict[str, Any]]]:
    for name, value in content.items() if isinstance(content, dict) else ():
        if name == "ros__parameters":
            yield above, value or {}
        elif isinstance(value, dict):
            yield from _flat(value, f"{above}/{name}".strip("/"))


def _of_nodes(started: Started) -> Iterator[str]:
    is_simulated = any(one["kind"] == "include" and "gz_sim" in one["file"] for one in started)
    timed = ("robot_state_publisher", "rviz2")
    for one in started if is_simulated else ():
        if one["kind"] == "node" and one["executable"] in timed and one["values"].get("use_sim_time") is not True:
            yield f"{one['executable']} has no use_sim_time"
    full = [
        resolved(one["name"], one["namespace"])
        for one in started
        if one["kind"] == "node" and one["name"] and one["executable"] not in ("create", "spawner")
    ]
    yield from (f"two nodes are named {name}" for name in sorted({one for one in full if full.count(one) > 1}))
    for one in _nodes(started, "robot_state_publisher"):
        text = one["values"].get("robot_description")
        if not isinstance(text, str) or not text.strip():
            yield "a robot_state_publisher has no robot_description"
