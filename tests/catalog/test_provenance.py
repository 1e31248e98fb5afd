"""Every entry of the catalogue says where it comes from: a repository with what was read of it, or an authority."""

from __future__ import annotations

import re
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
from corpus import quick_yaml

from urdfctl.catalog.compiled import DATA

PROVENANCE = quick_yaml(DATA / "provenance.yaml")
UNSOURCED = {one["entry"]: one["why"] for one in PROVENANCE["unsourced"]}
GENERATIONS = ("ros1", "ros2")


def entries(ros: str) -> Iterator[tuple[str, str]]:
    """Yield each entry of a generation: its name, and what `sources` calls it."""
    for path in sorted((DATA / ros).rglob("*.yaml")):
        found = quick_yaml(path)
        if isinstance(found, dict):
            yield path.stem, path.stem
            found = found.get("filters", [])
        for entry in found:
            name = next(entry[key] for key in ("type", "id", "name") if key in entry)
            yield name, _source_name(entry, name, path)


def _source_name(entry: dict[str, Any], name: str, path: Path) -> str:
    sourced = {one for names in PROVENANCE["sources"][path.relative_to(DATA).parts[0]].values() for one in names}
    prefix = re.split("/|::", name)[0] if re.search("/|::", name) else path.stem
    return next((one for one in (name, entry.get("package")) if one in sourced), entry.get("package", prefix))


ENTRIES = [pytest.param(ros, *entry, id=f"{ros}-{entry[0]}") for ros in GENERATIONS for entry in entries(ros)]


@pytest.mark.parametrize(("ros", "name", "called"), ENTRIES)
def test_an_entry_has_a_source(ros: str, name: str, called: str) -> None:
    repositories = [repo for repo, names in PROVENANCE["sources"][ros].items() if called in names]
    assert len(repositories) == 1 or name in UNSOURCED, (
        f"name '{called}' under 'sources', '{ros}' in provenance.yaml, after its repository"
    )


@pytest.mark.parametrize("ros", GENERATIONS)
def test_of_each_source_it_is_noted_what_was_read(ros: str) -> None:
    read = {one["repo"] for one in (*PROVENANCE["ros1"], *PROVENANCE["ros2"]) if one.get("commit") or one.get("read")}
    assert set(PROVENANCE["sources"][ros]) - read == set(), (
        "list what was read under 'ros1' or 'ros2' of provenance.yaml: a line with 'repo' and 'commit', or 'read'"
    )


@pytest.mark.parametrize("ros", GENERATIONS)
def test_each_source_is_one_of_an_entry(ros: str) -> None:
    named = [name for names in PROVENANCE["sources"][ros].values() for name in names]
    entered = {called for name, called in entries(ros) if name not in UNSOURCED}
    assert entered - set(named) == set(), "name them under 'sources' in provenance.yaml"
    assert set(named) - entered == set(), "no entry is from what 'sources' in provenance.yaml names"
    assert len(named) == len(set(named)), "'sources' in provenance.yaml names one of them twice"


def test_what_has_no_source_is_known_and_says_why() -> None:
    assert set(UNSOURCED) == {"franka_ign_ros2_control/IgnitionSystem", "franka_ign", "renamed"}
    assert all(UNSOURCED.values())


@pytest.mark.parametrize("path", sorted((DATA / "moves").glob("*.yaml")), ids=lambda path: path.stem)
def test_a_move_has_an_authority(path: Path) -> None:
    found = quick_yaml(path)
    assert all(group["authority"] for group in (found if isinstance(found, list) else [found]))


@pytest.mark.parametrize("path", sorted((DATA / "log_messages").glob("*.yaml")), ids=lambda path: path.stem)
def test_a_message_has_an_authority(path: Path) -> None:
    without = [
        entry["id"]
        for group in quick_yaml(path)
        for entry in group["entries"]
        if not (entry.get("authority") or group.get("authority"))
    ]
    assert without == []
