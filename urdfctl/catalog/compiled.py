"""Compile the YAML files that people edit to the JSON that the program reads: `python -m urdfctl.catalog.compiled`.

Reading the YAML takes a fifth of a second, reading the JSON a few milliseconds. Content that only people read
(messages, notes, provenance) is left out. Shared content (`extends`, `groups`) is copied into each entry.
"""

from __future__ import annotations

import json
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Any

from urdfctl.catalog.distros import ROS1, ROS2
from urdfctl.catalog.entries import ControllerType
from urdfctl.catalog.reading import controller_type, extension
from urdfctl.catalog.schema import flaws

DATA = Path(__file__).parent / "data"
KINDS = ("controllers", "hardware", "simulators", "transmissions", "interfaces", "manager")
_ONLY_FOR_PEOPLE = {
    "messages", "message", "notes", "topics", "unit", "default_from", "wrong_type", "vendor", "releases", "since_of",
    "built_from_source", "deprecated_since", "removed_since", "chainable_since", "distros_of_branches", "order",
    "fields", "distros_not_read", "read_by", "purpose",
}  # fmt: skip
"""Keys that are left out of the JSON."""
_BY_NAME = {
    "parameters", "removed_parameters", "children", "hardware_parameters", "joint_parameters", "sensor_parameters",
    "joint_children", "actuator_children", "manager", "controller", "every_controller", "joint_limits",
}  # fmt: skip
"""Keys whose value is a map from names of parameters or the like; a name is kept even if it is in the list above."""
_KEY = {"controllers": "type", "hardware": "type", "simulators": "id", "transmissions": "type", "filters": "type"}
"""The field that identifies an entry of each kind."""
_DEFINITIONS = {
    "controllers": "controller", "hardware": "hardware", "simulators": "simulator", "transmissions": "transmission",
}  # fmt: skip
"""What schema.json calls an entry of each kind."""


def files() -> Iterator[tuple[Path, str]]:
    """Yield the path of each JSON file with its expected content."""
    for ros in (1, 2):
        folder = DATA / f"ros{ros}"
        for kind in KINDS:
            yield folder / f"{kind}.json", _json(_collected(folder, kind))
    yield DATA / "renamed.json", _json(_yaml(DATA / "renamed.yaml"))
    moves = {path.stem: _with_literals(_yaml(path)) for path in sorted((DATA / "moves").glob("*.yaml"))}
    yield DATA / "moves.json", _json(moves)
    yield DATA / "log_messages.json", _json(dict(_log_messages()))


def _with_literals(plain: Any) -> Any:
    """Plain data with numbers that JSON does not have as YAML writes them: `.nan`."""
    if isinstance(plain, dict):
        return {key: _with_literals(value) for key, value in plain.items()}
    if isinstance(plain, list):
        return [_with_literals(item) for item in plain]
    return ".nan" if isinstance(plain, float) and plain != plain else plain  # noqa: PLR0124 (nan)


def wrong() -> Iterator[str]:
    """Yield what schema.json does not allow in the entries that people edit: the file, the entry, the key and why."""
    for ros in ("ros1", "ros2"):
        for kind, definition in _DEFINITIONS.items():
            for path in _paths(DATA / ros, kind):
                for entry in _yaml(path):
                    name = entry.get(_KEY[kind], "an entry without a name")
                    for flaw in flaws(entry, definition):
                        yield f"{path.relative_to(DATA).as_posix()}: {name}: {flaw.path}: {flaw.message}"


def sources() -> list[Path]:
    """Return the YAML files that people edit."""
    return sorted(DATA.rglob("*.yaml"))


def _collected(folder: Path, kind: str) -> dict[str, Any]:
    """All entries of one kind, by key."""
    contents = [_yaml(path) for path in _paths(folder, kind)]
    if kind not in _KEY and kind == "interfaces" and isinstance(contents[0], list):
        return {entry["name"]: _for_program(entry) for entry in contents[0]}
    if kind not in _KEY:
        return _for_program(contents[0])  # type: ignore[no-any-return]
    entries = {entry[_KEY[kind]]: entry for content in contents for entry in content}
    if kind == "controllers":
        groups = _yaml(folder / "groups.yaml") if (folder / "groups.yaml").exists() else {}
        entries = {key: _merged(entry, entries, groups) for key, entry in entries.items() if not entry.get("base")}
    compiled = {key: _for_program(entry) for key, entry in sorted(entries.items())}
    distros = ROS1 if folder.name == "ros1" else ROS2
    return (
        {key: _with_same_as(entry, distros) for key, entry in compiled.items()} if kind == "controllers" else compiled
    )


def _paths(folder: Path, kind: str) -> list[Path]:
    """The YAML files of one kind."""
    file = folder / f"{kind}.yaml"
    return sorted((folder / kind).glob("*.yaml")) if (folder / kind).is_dir() else [file] if file.exists() else []


def _with_same_as(entry: dict[str, Any], distros: tuple[str, ...]) -> dict[str, Any]:
    """A controller's entry with `same_as`: for each distro, the earlier distro in which the type is identical."""
    distinct: list[ControllerType] = []
    same: dict[str, str] = {}
    for distro in distros:
        controller = controller_type(entry, distro)
        earlier = next((known for known in distinct if controller == known._replace(distro=distro)), None)
        if earlier is not None:
            same[distro] = earlier.distro
        elif controller is not None:
            distinct.append(controller)
    return {**entry, "same_as": same} if same else entry


def _log_messages() -> Iterator[tuple[str, dict[str, Any]]]:
    """The log messages by id, each merged with the settings of its group; a cause is its text followed by its rules."""
    for path in sorted((DATA / "log_messages").glob("*.yaml")):
        for group in _yaml(path):
            shared = {key: value for key, value in group.items() if key != "entries"}
            for entry in group["entries"]:
                own = {**shared, **entry}
                own["causes"] = [_cause(cause) for cause in own.get("causes", ())]
                yield own.pop("id"), own


def _cause(cause: str | dict[str, str]) -> list[str] | dict[str, Any]:
    """The text of a cause and the codes of the rules that find it, from `UC201, UC223: text` or the text alone.

    A cause with conditions remains a map.
    """
    if isinstance(cause, str):
        return [cause]
    if "text" in cause:
        return {**cause, "rules": cause["rules"].split(", ")} if "rules" in cause else dict(cause)
    ((codes, text),) = cause.items()
    return [text, *codes.split(", ")]


def _merged(entry: dict[str, Any], entries: dict[str, Any], groups: dict[str, Any]) -> dict[str, Any]:
    """An entry merged with the parameters of its groups and with the entry that it extends."""
    own = dict(entry)
    grouped = {
        f"{prefix}.{name}" if prefix else name: parameter
        for prefix, group in own.pop("groups", {}).items()
        for name, parameter in groups[group].items()
    }
    if grouped:
        own["parameters"] = {**grouped, **own.get("parameters", {})}
    extended = own.pop("extends", None)
    return extension(_merged(entries[extended], entries, groups), own) if extended else own


def _for_program(plain: Any) -> Any:
    if isinstance(plain, dict):
        return {key: _part(key, value) for key, value in plain.items() if key not in _ONLY_FOR_PEOPLE}
    return [_for_program(item) for item in plain] if isinstance(plain, list) else plain


def _part(key: str, value: Any) -> Any:
    """The value of a key; if the keys of the value are names from ROS, all of them are kept."""
    if key in _BY_NAME and isinstance(value, dict):
        return {name: _for_program(item) for name, item in value.items()}
    return _for_program(value)


def _json(entries: dict[str, Any]) -> str:
    """JSON with one line per entry, so that a changed entry is one changed line."""
    lines = (f"{json.dumps(key)}:{json.dumps(value, separators=(',', ':'))}" for key, value in entries.items())
    return "{\n" + ",\n".join(lines) + "\n}\n"


def _yaml(path: Path) -> Any:
    import yaml

    return yaml.load(path.read_bytes(), getattr(yaml, "CSafeLoader", yaml.SafeLoader))  # noqa: S506 (both are safe)


def main() -> None:
    """Write the JSON files that are not up to date; none if an entry is not as schema.json says."""
    told = list(wrong())
    if told:
        sys.exit("\n".join(told))
    for path, text in files():
        if not path.exists() or path.read_text(encoding="utf-8") != text:
            path.write_text(text, encoding="utf-8")


if __name__ == "__main__":
    main()
