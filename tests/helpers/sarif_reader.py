"""Read SARIF into the classes that Microsoft generates from the official schema.

These classes are an independent check of the allowed and required properties of each object. Types and ranges, which
they do not check, are copied from the text of the schema.
"""

from __future__ import annotations

import json
from typing import Any
from urllib.parse import urlsplit

import attr
import sarif_om

CLASSES = {
    "artifactChanges": sarif_om.ArtifactChange,
    "artifactLocation": sarif_om.ArtifactLocation,
    "artifacts": sarif_om.Artifact,
    "codeFlows": sarif_om.CodeFlow,
    "defaultConfiguration": sarif_om.ReportingConfiguration,
    "deletedRegion": sarif_om.Region,
    "description": sarif_om.Message,
    "driver": sarif_om.ToolComponent,
    "fixes": sarif_om.Fix,
    "fullDescription": sarif_om.MultiformatMessageString,
    "help": sarif_om.MultiformatMessageString,
    "insertedContent": sarif_om.ArtifactContent,
    "invocations": sarif_om.Invocation,
    "message": sarif_om.Message,
    "physicalLocation": sarif_om.PhysicalLocation,
    "region": sarif_om.Region,
    "relatedLocations": sarif_om.Location,
    "replacements": sarif_om.Replacement,
    "results": sarif_om.Result,
    "rules": sarif_om.ReportingDescriptor,
    "runs": sarif_om.Run,
    "shortDescription": sarif_om.MultiformatMessageString,
    "threadFlows": sarif_om.ThreadFlow,
    "tool": sarif_om.Tool,
}
WITHIN = {
    ("Result", "locations"): sarif_om.Location,
    ("ThreadFlow", "locations"): sarif_om.ThreadFlowLocation,
    ("ThreadFlowLocation", "location"): sarif_om.Location,
    ("Artifact", "location"): sarif_om.ArtifactLocation,
}
MAPS = {"originalUriBaseIds": sarif_om.ArtifactLocation, "partialFingerprints": str}
TEXTS = {
    "$schema",
    "version",
    "name",
    "semanticVersion",
    "id",
    "ruleId",
    "level",
    "text",
    "markdown",
    "uri",
    "helpUri",
} | {
    "uriBaseId",
    "columnKind",
}
LEAST = {"startLine": 1, "startColumn": 1, "endLine": 1, "endColumn": 1, "byteOffset": 0, "byteLength": 0, "id": 0} | {
    "ruleIndex": 0,
    "nestingLevel": 0,
}
UNLIKE = {"artifacts", "fixes", "relatedLocations", "rules"}
NEVER_EMPTY = {"codeFlows", "threadFlows", "locations", "fixes", "artifactChanges", "replacements"}
ALIKE = {"level": {"none", "note", "warning", "error"}, "columnKind": {"utf16CodeUnits", "unicodeCodePoints"}}


def read(text: str) -> Any:
    """Return the only run of a log. Raises AssertionError if the log is not SARIF 2.1.0."""
    log = json.loads(text)
    assert set(log) == {"$schema", "version", "runs"}
    assert log["version"] == "2.1.0"
    [run] = log["runs"]
    return made(sarif_om.Run, run)


def made(kind: Any, given: dict[str, Any]) -> Any:
    """Return a SARIF object, including nested objects."""
    fields = {field.metadata["schema_property_name"]: field for field in attr.fields(kind)}
    assert set(given) <= set(fields), f"{kind.__name__} has no {set(given) - set(fields)}"
    missing = {name for name, field in fields.items() if field.default is attr.NOTHING} - set(given)
    assert not missing, f"{kind.__name__} lacks {missing}"
    return kind(**{fields[name].name: value_of(kind, name, value) for name, value in given.items()})


def value_of(kind: Any, name: str, value: Any) -> Any:
    within = WITHIN.get((kind.__name__, name)) or CLASSES.get(name)
    if isinstance(value, list) and within:
        assert value or name not in NEVER_EMPTY, f"{name} is empty"
        assert name not in UNLIKE or len({json.dumps(item) for item in value}) == len(value), f"{name} repeats itself"
        return [made(within, item) for item in value]
    if within:
        return made(within, value)
    if name in MAPS:
        return {key: made(MAPS[name], item) if MAPS[name] is not str else item for key, item in value.items()}
    if name == "properties":
        return value
    if name in TEXTS and kind is not sarif_om.Location:
        assert isinstance(value, str), name
        assert value in ALIKE.get(name, {value})
        assert name != "uri" or urlsplit(value).geturl().isascii()
        return value
    if name in LEAST:
        assert type(value) is int, name
        assert value >= LEAST[name], (name, value)
        return value
    assert type(value) is bool, f"unknown property {name}"
    return value
