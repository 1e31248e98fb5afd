"""Each surface of the threat model links to tests that exist; their sentences are the tests' names."""

from __future__ import annotations

import ast
import re
from functools import cache

import pytest
from folder import CHECKOUT

PAGE = (CHECKOUT / "docs/threat-model.md").read_text(encoding="utf-8")
PARTS = re.split(r"^#{2,3} ", PAGE, flags=re.MULTILINE)
SECTIONS = {heading: text for heading, _, text in (part.partition("\n") for part in PARTS)}
SURFACES = [
    *("Robots", "Controller files and other YAML", "Launch files", "Configuration", "Build files and manifests"),
    *("Meshes", "Logs", "Generated headers", "Git revisions", "Reports and other files that are written", "HTML pages"),
    *("The GitHub action", "Hooks and other commands in a checkout", "The editor", "Worker processes"),
    "Cache and journal",
]
LINK = re.compile(r"^- (.+): \[(\w+\.py)\]\(\.\./(tests/\w+/(?:\w+/)?\2)\)$", re.MULTILINE)


@cache
def names_in(path: str) -> set[str]:
    """Return the names of the tests in a file."""
    tree = ast.parse((CHECKOUT / path).read_text(encoding="utf-8"))
    names = (node.name for node in tree.body if isinstance(node, ast.FunctionDef))
    return {name for name in names if name.startswith("test_")}


def test_the_page_has_a_section_for_each_surface_in_order() -> None:
    start = list(SECTIONS).index("Surfaces") + 1
    assert list(SECTIONS)[start : start + len(SURFACES)] == SURFACES
    assert "What is not defended" in SECTIONS


@pytest.mark.parametrize("surface", [*SURFACES, "The gates"])
def test_each_surface_links_to_tests_that_exist(surface: str) -> None:
    listed = re.findall(r"^- .*$", SECTIONS[surface], re.MULTILINE)
    links = LINK.findall(SECTIONS[surface])
    assert links
    assert len(links) == len(listed), "each item of the list is 'sentence: [file](../tests/folder/file)'"
    for sentence, _, path in links:
        assert f"test_{sentence.lower().replace(' ', '_')}" in names_in(path), sentence


def test_the_page_and_how_to_report_are_linked_to() -> None:
    for page in ("README.md", "SECURITY.md", "docs/commands.md", "CONTRIBUTING.md"):
        assert "threat-model.md" in (CHECKOUT / page).read_text(encoding="utf-8"), page
    security = (CHECKOUT / "SECURITY.md").read_text(encoding="utf-8")
    assert "Report a vulnerability" in security
    assert "@" not in security, "there is no mail address"
