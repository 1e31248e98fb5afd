"""Makes the JSON that the program reads of the YAML that people edit: `python -m urdfctl.catalog.compiled`.

YAML of this size takes a fifth of a second to read, its JSON some milliseconds. What only people read (messages, notes,
provenance) is left out; what an entry shares with others (`extends`, `groups`) is put into it.
"""

from __future__ import annotations

import json
from collections.abc import Iterator
from pathlib import Path

from urdfctl.catalog.distros import ROS1, ROS2
from urdfctl.catalog.entries import ControllerType
from urdfctl.catalog.reading import controller_type, extension
from urdfctl.hints import Any

DATA = Path(__file__).parent / "data"
KINDS = ("controllers", "hardware", "simulators", "transmissions", "interfaces", "manager")
_FOR_PEOPLE = {
    "messages", "message", "notes", "topics", "unit", "default_from", "wrong_type", "vendor", "releases", "since_of",
    "built_from_source", "deprecated_since", "removed_since", "chainable_since", "distros_of_branches", "order",
    "fields", "distros_not_read", "read_by", "purpose",
}  # fmt: skip
_BY_NAME = {
    "parameters", "removed_parameters", "children", "hardware_parameters", "joint_parameters", "sensor_parameters",
    "joint_children", "actuator_children", "manager", "controller", "every_controller", "joint_limits",
}  # fmt: skip
_KEY = {"controllers": "type", "hardware": "type", "simulators": "id", "transmissions": "type", "filters": "type"}


def files() -> Iterator[tuple[Path, str]]:
    """Each JSON file, with the text that it ought to hold."""
    for ros in (1, 2):
        folder = DATA / f"ros{ros}"
        for kind in KINDS:
            yield folder / f"{kind}.json", _json(_collected(folder, kind))
    yield DATA / "renamed.json", _json(_yaml(DATA / "renamed.yaml"))
    yield DATA / "log_messages.json", _json(dict(_log_messages()))


def sources() -> list[Path]:
    """The YAML files that people edit."""
    return sorted(DATA.rglob("*.yaml"))


def _collected(folder: Path, kind: str) -> dict[str, Any]:
    """All entries of a kind by their key."""
    one = folder / f"{kind}.yaml"
    paths = sorted((folder / kind).glob("*.yaml")) if (folder / kind).is_dir() else [one] if one.exists() else []
    read = [_yaml(path) for path in paths]
    if kind not in _KEY and kind == "interfaces" and isinstance(read[0], list):
        return {entry["name"]: _for_program(entry) for entry in read[0]}
    if kind not in _KEY:
        return _for_program(read[0])  # type: ignore[no-any-return]
    entries = {entry[_KEY[kind]]: entry for file in read for entry in file}
    if kind == "controllers":
        groups = _yaml(folder / "groups.yaml") if (folder / "groups.yaml").exists() else {}
        entries = {key: _whole(entry, entries, groups) for key, entry in entries.items() if not entry.get("base")}
    made = {key: _for_program(entry) for key, entry in sorted(entries.items())}
    distros = ROS1 if folder.name == "ros1" else ROS2
    return {key: _with_likes(entry, distros) for key, entry in made.items()} if kind == "controllers" else made


def _with_likes(entry: dict[str, Any], distros: tuple[str, ...]) -> dict[str, Any]:
    """An entry of a controller with the distros that have it just as an earlier one does, which `same_as` tells."""
    first: list[ControllerType] = []
    same: dict[str, str] = {}
    for distro in distros:
        made = controller_type(entry, distro)
        earlier = next((one for one in first if made == one._replace(distro=distro)), None)
        if earlier is not None:
            same[distro] = earlier.distro
        elif made is not None:
            first.append(made)
    return {**entry, "same_as": same} if same else entry


def _log_messages() -> Iterator[tuple[str, dict[str, Any]]]:
    """The entries of the messages by their ids, with what their group says of all its own; the rules of a cause stand
    behind its text."""
    for path in sorted((DATA / "log_messages").glob("*.yaml")):
        for group in _yaml(path):
            shared = {key: value for key, value in group.items() if key != "entries"}
            for entry in group["entries"]:
                own = {**shared, **entry}
                own["causes"] = [_cause(cause) for cause in own.get("causes", ())]
                yield own.pop("id"), own


def _cause(cause: str | dict[str, str]) -> list[str]:
    """A cause and the codes of the rules that find it: `UC201, UC223: text`, or the text alone."""
    if isinstance(cause, str):
        return [cause]
    ((codes, text),) = cause.items()
    return [text, *codes.split(", ")]


def _whole(entry: dict[str, Any], entries: dict[str, Any], groups: dict[str, Any]) -> dict[str, Any]:
    """An entry with the parameters of its groups, and with what it extends."""
    own = dict(entry)
    grouped = {
        f"{prefix}.{name}" if prefix else name: parameter
        for prefix, group in own.pop("groups", {}).items()
        for name, parameter in groups[group].items()
    }
    if grouped:
        own["parameters"] = {**grouped, **own.get("parameters", {})}
    extended = own.pop("extends", None)
    return extension(_whole(entries[extended], entries, groups), own) if extended else own


def _for_program(plain: Any) -> Any:
    if isinstance(plain, dict):
        return {key: _part(key, value) for key, value in plain.items() if key not in _FOR_PEOPLE}
    return [_for_program(part) for part in plain] if isinstance(plain, list) else plain


def _part(key: str, value: Any) -> Any:
    """A value of an entry; where its keys are names and no words of ours, they all stay."""
    if key in _BY_NAME and isinstance(value, dict):
        return {name: _for_program(named) for name, named in value.items()}
    return _for_program(value)


def _json(entries: dict[str, Any]) -> str:
    """One line an entry, so that a change of one shows as one."""
    lines = (f"{json.dumps(key)}:{json.dumps(value, separators=(',', ':'))}" for key, value in entries.items())
    return "{\n" + ",\n".join(lines) + "\n}\n"


def _yaml(path: Path) -> Any:
    import yaml

    return yaml.load(path.read_bytes(), getattr(yaml, "CSafeLoader", yaml.SafeLoader))  # noqa: S506 (both are safe)


def main() -> None:
    """Write the files that are not what they ought to be."""
    for path, text in files():
        if not path.exists() or path.read_text(encoding="utf-8") != text:
            path.write_text(text, encoding="utf-8")


if __name__ == "__main__":
    main()
