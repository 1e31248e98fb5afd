"""Every literal message of the reference and of the runtimes' verdicts is explained; skipped if these are absent."""

from __future__ import annotations

import re
from collections.abc import Iterator
from functools import cache
from pathlib import Path
from typing import Any

import pytest
import robots
import yaml
from corpus import SHARED

from urdfctl.load.target import Target
from urdfctl.logs.digest import digest

REFERENCE, TRUTH = SHARED / "reference", SHARED / "truth"
needs_reference = pytest.mark.skipif(not REFERENCE.is_dir(), reason="the reference is not beside the checkout")
needs_truth = pytest.mark.skipif(not TRUTH.is_dir(), reason="the verdicts of the runtimes are not beside the checkout")

BY_THE_TOOLS = re.compile(
    r"""\(\d+\ more\ kinds\) | ok\ joints=\d+ | Valid\.\ model= | urdf\ parse\ failed | urdf\ does\ not\ parse
      | std::terminate:\  | \w+'\n\[INFO\]
      | no\ loader\ for\ type .* \(tool\ text\) | interface\ providers\ were\ not\ run | <\?xml | <robot\ name=""",
    re.VERBOSE,
)
"""Texts of the tools that recorded the verdicts, and ends of logs without an error; no runtime prints these alone."""
CODE = re.compile(
    r"""<[\w:]+[\ =>].*>$ | [\w.]+\( | [\w.]+=["\[$] | -\ \w+: | [\w/<>.*-]+:\ ?[\[{] | /\*\*: | \w+:\ \w+$
      | \$\((?!eval) | [{\[][\w,\ -]+[\]}\[] | --(?!params) | 'cmd'
      | (?:spawner|spawner\.py|ros2|rosservice|controller_\w+|controller_manager/\w+|spawn_model|xacro|load_controller
          |gen-\w+|init_node|constraints/\S+|gains\S+)(?:\ [^:]|$)""",
    re.VERBOSE,
)
"""Texts in backticks that are code, a command or an element."""
FRAGMENTS = (
    "is not a number.",
    "in URDF model.",
    "is not a float:",
    "Could not stop",
    "is not initialized",
    "less than or equal to",
    "greater than or equal to",
    "because no controller with this name exists",
    "since the state interface '{}' is not available.",
    "Joint ... expected 'joint1' or 'joint2'.",
    "When unspecified, the default is %s",
    'Invalid value: "{}", expected a positive integer.',
    'Out of range value: "{}", expected a positive valid integer.',
    "yaml prefix + rosparam ns/param + enclosing group ns",
    "a b:=default c:=^ d:=^|default *block **blocks",
)
"""Parts of messages that are also quoted in full, and two forms of syntax."""
NOTES = {"EXC_RESOURCE", "REQUIRES_IFACE_MULTI"}
"""Names that the reference gives to its own messages."""


@cache
def loaded(path: Path) -> Any:
    return yaml.load(path.read_bytes(), getattr(yaml, "CSafeLoader", yaml.SafeLoader))  # noqa: S506 (both are safe)


def messages_in(node: Any, key: str = r"messages$") -> Iterator[str]:
    """The texts below the keys that match."""
    if isinstance(node, dict):
        for name, value in node.items():
            yield from texts(value) if re.search(key, str(name)) else messages_in(value, key)
    elif isinstance(node, list):
        for value in node:
            yield from messages_in(value, key)


def texts(node: Any) -> Iterator[str]:
    if isinstance(node, str):
        yield node
    elif isinstance(node, dict) and "text" in node:
        yield node["text"]
    elif isinstance(node, dict | list):
        for value in node.values() if isinstance(node, dict) else node:
            yield from texts(value)


def is_explained(message: str) -> bool:
    return bool(digest([message], pasted=True).known)


@needs_truth
def test_every_message_of_the_real_runtimes_is_explained() -> None:
    paths = [*TRUTH.glob("*/*/verdict.yaml"), *TRUTH.glob("corpus_ros*.yaml")]
    messages = {message for path in paths for message in messages_in(loaded(path))}
    assert len(messages) > 500
    assert [m for m in sorted(messages) if not BY_THE_TOOLS.match(m) and not is_explained(m)] == []


@needs_reference
def test_every_message_of_the_catalogues_is_explained() -> None:
    paths = sorted(REFERENCE.glob("ros*/*.yaml"))
    messages = {message for path in paths for message in messages_in(loaded(path), r"message|error|text$")} - NOTES
    assert len(messages) > 200
    notes = ("default exists but violates", "<info>")
    assert [m for m in sorted(messages) if not m.startswith(notes) and not is_explained(m)] == []


@needs_reference
@pytest.mark.parametrize("name", ["failure_modes.md", "ros1", "ros2"])
def test_every_message_of_the_reference_s_texts_is_explained(name: str) -> None:
    path = REFERENCE / name
    quoted = [
        text.strip(". ").replace("\\n", " ")
        for page in (sorted(path.glob("*.md")) if path.is_dir() else [path])
        for text in re.findall(r"`([^`\n]+)`", page.read_text(encoding="utf-8"))
    ]
    fragments = {fragment.strip(". ") for fragment in FRAGMENTS}
    messages = {
        text for text in quoted if len(re.findall(r"[A-Za-z']{2,}", text)) > 2 and " " in text and not CODE.match(text)
    }
    assert len(messages) > 50
    assert [m for m in sorted(messages - fragments) if not is_explained(m)] == []


def rejected() -> list[tuple[Path, dict[str, Any], str]]:
    """Every eighth case that noetic or jazzy rejected, with the distro."""
    files = sorted(TRUTH.glob("ros*/*/verdict.yaml"))
    return [
        (file.parent, case, distro)
        for file in files[::8]
        for case in [loaded(file)]
        for distro in ("noetic", "jazzy")
        if "undecidable" not in case and case["distros"].get(distro, {}).get("verdict") == "error"
    ]


def codes_found(folder: Path, case: dict[str, Any], distro: str) -> set[str]:
    """The codes of the findings in a case's files."""
    started = case.get("activation_order") or case.get("controllers")
    simulator = "gazebo-classic" if folder.parent.name == "ros1" else "none"
    options = {"distro": distro, "simulator": simulator, "started": tuple(started or ())}
    first, *others = (str(folder / name) for name in case["files"])
    target = Target(first, controllers=tuple(others))
    return {finding.code for finding in robots.findings(target, workspace=str(folder), **options)}


@needs_truth
def test_the_rules_that_an_explanation_names_find_the_fault_in_the_files() -> None:
    """In more than nine of ten cases; the other messages have too many causes."""
    cases = []
    for folder, case, distro in rejected():
        codes = codes_found(folder, case, distro)
        known = digest(case["distros"][distro]["messages"], pasted=True).known
        rules = {code for message in known for code in message.message.rules}
        if codes:
            cases.append((folder.name, bool(codes & rules)))
    assert len(cases) > 50
    assert sum(named for _, named in cases) > 0.9 * len(cases), [name for name, named in cases if not named]
