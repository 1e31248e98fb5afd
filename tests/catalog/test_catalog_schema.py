"""The data of the catalogue obeys its schema, and an entry that does not is told of in words."""

from __future__ import annotations

import json
import re
import shutil
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import jsonschema
import pytest
import yaml
from sampling import assert_each

import urdfctl.catalog.schema
from urdfctl.catalog import compiled
from urdfctl.catalog.compiled import DATA
from urdfctl.catalog.distros import spanned
from urdfctl.catalog.schema import flaws

SCHEMA = json.loads(Path(urdfctl.catalog.schema.__file__).with_name("schema.json").read_text(encoding="utf-8"))
FORMATS = jsonschema.FormatChecker(())
FORMATS.checks("span", ValueError)(lambda value: not isinstance(value, str) or spanned(value, 1) is not None)
VALIDATORS = {
    kind: jsonschema.Draft202012Validator({**SCHEMA, "$ref": f"#/$defs/{kind}"}, format_checker=FORMATS)
    for kind in ("controller", "hardware", "simulator", "transmission")
}
KINDS = {
    "controllers": "controller",
    "hardware": "hardware",
    "simulators": "simulator",
    "transmissions": "transmission",
}


def entries() -> Iterator[tuple[str, tuple[Any, str]]]:
    """Yield each entry of the catalogue and its kind, by name."""
    for path in sorted(DATA.glob("ros?/**/*.yaml")):
        kind = KINDS.get(path.relative_to(DATA).parts[1].removesuffix(".yaml"))
        if kind is not None:
            for entry in yaml.load(path.read_text(encoding="utf-8"), yaml.CSafeLoader):
                name = f"{path.relative_to(DATA)}: {entry.get('type', entry.get('id'))}"
                yield name, (entry, kind)


def test_the_data_obeys_the_schema() -> None:
    def check(case: tuple[Any, str]) -> None:
        entry, kind = case
        assert list(flaws(entry, kind)) == []
        VALIDATORS[kind].validate(entry)

    assert_each(check, dict(entries()))


@pytest.mark.parametrize(
    ("old", "new", "told"),
    [
        ("distros: humble..", "distros: humbel..", "distros: 'humbel..' is not a distro"),
        (
            " joints: {type: s",
            " joints: {requird: true, type: s",
            "parameters.joints: unknown key 'requird'; did you mean 'required'?",
        ),
    ],
)
def test_an_entry_that_does_not_is_not_compiled(
    old: str, new: str, told: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    data = tmp_path / "data"
    shutil.copytree(DATA, data)
    edited = data / "ros2" / "controllers" / "ros2_control_demo_example_7.yaml"
    text = edited.read_text(encoding="utf-8")
    edited.write_text(text.replace(old, new), encoding="utf-8")
    monkeypatch.setattr(compiled, "DATA", data)
    with pytest.raises(SystemExit) as ended:
        compiled.main()
    entry = "ros2/controllers/ros2_control_demo_example_7.yaml: ros2_control_demo_example_7/RobotController"
    assert f"{entry}: {told}" in str(ended.value).splitlines()
    assert (data / "ros2/controllers.json").read_bytes() == (DATA / "ros2/controllers.json").read_bytes()


def test_the_entry_that_the_page_shows_is_one_of_the_data() -> None:
    [shown] = re.findall(
        r"^```yaml\n(.*?)^```", (DATA / "README.md").read_text(encoding="utf-8"), re.MULTILINE | re.DOTALL
    )
    file = DATA / "ros2" / "controllers" / "ros2_control_demo_example_7.yaml"
    assert file.read_text(encoding="utf-8").endswith(shown), f"copy the entry of {file.name} to README.md again"


def test_the_schema_is_one() -> None:
    jsonschema.Draft202012Validator.check_schema(SCHEMA)


@pytest.mark.parametrize(
    ("entry", "told"),
    [
        ({}, ": required key 'type' is missing"),
        ({"type": 3}, "type: must be a string, not 3"),
        ({"type": "my Arm"}, "type: 'my Arm' is invalid; expected a plugin type, such as package/Class"),
        ({"type": "a/B", "paramters": {}}, ": unknown key 'paramters'; did you mean 'parameters'?"),
        ({"type": "a/B", "distros": "humbel.."}, "distros: 'humbel..' is not a distro"),
        ({"type": "a/B", "chainable": "humbel.."}, "chainable: 'humbel..' is not a distro"),
        ({"type": "a/B", "chainable": 1}, "chainable: must be a string, not 1"),
        ({"type": "a/B", "kind": "sensor"}, 'kind: must be "controller" or "broadcaster", not "sensor"'),
        (
            {"type": "a/B", "parameters": {"p": {"type": "float"}}},
            f"parameters.p.type: 'float' is invalid; expected a {SCHEMA['$defs']['parameter_type']['description']}",
        ),
        (
            {"type": "a/B", "parameters": {"gains.<joints>.p": {}}},
            "parameters.\"gains.<joints>.p\": required key 'type' is missing",
        ),
        ({"type": "a/B", "parameters": ["p"]}, 'parameters: must be a table, not ["p"]'),
        (
            {"type": "a/B", "parameters": {"p": {"type": "int", "validators": {"bounds": [1]}}}},
            "parameters.p.validators.bounds: must have at least 2 elements",
        ),
        (
            {"type": "a/B", "parameters": {"p": {"type": "int", "overrides": {"humbel": {}}}}},
            "parameters.p.overrides.humbel: 'humbel' is not a distro",
        ),
        (
            {"type": "a/B", "claims": {"command": [{"for_each": "joints", "interface": ["effort"]}]}},
            'claims.command[0].interface: must be a string, not ["effort"]',
        ),
    ],
)
def test_the_first_flaw_is_told_with_its_key(entry: dict[str, Any], told: str) -> None:
    flaw = next(flaws(entry, "controller"))
    assert f"{flaw.path}: {flaw.message}" == told
    with pytest.raises(jsonschema.ValidationError):
        VALIDATORS["controller"].validate(entry)
