"""The documentation site: every rule and message has a page, links lead somewhere, and what is wrong is told."""

from __future__ import annotations

import sys
from pathlib import Path

import pytest
import tomli
from folder import CHECKOUT

from urdfctl import REPOSITORY, SITE
from urdfctl.catalog.log_messages import log_messages
from urdfctl.rules import all_faults

sys.path.append(str(CHECKOUT / "docs" / "site"))

import faults
from checking import ask_nobody, problems_of
from documents import document_pages, linked
from faults import fault_pages, page_of
from messages import message_pages

PAGE = """<!doctype html><html lang="en"><head><title>A page</title><meta name="description" content="what it says">
</head><body><h1 id="top">A page</h1>{body}</body></html>"""


def built(folder: Path, **pages: str) -> list[str]:
    """Return the problems of a site of these pages, given by the contents of their bodies."""
    for name, body in pages.items():
        (folder / f"{name}.html").write_text(PAGE.format(body=body), "utf-8")
    return list(problems_of(folder))


def test_each_message_of_explain_has_a_page_with_the_literal_message_as_title() -> None:
    pages = message_pages()
    for message in log_messages():
        assert f"messages/{message.id}.md" in pages
    title = pages["messages/gazebo-pid-gains-absent.md"].split("\n")[1]
    assert title.startswith('title: "No p gain specified for pid.')


def test_the_page_of_a_rule_says_what_is_printed_wrong_right_and_the_authority() -> None:
    fault = next(fault for fault in all_faults() if fault.code == "UC201")
    page = page_of(fault)
    for part in ("## Wrong", "## Right", "## Authority", "`urdfctl lint` says", "## What is printed because of it"):
        assert part in page
    assert "](../messages/no-hardware-interface-in-joint.md)" in page


def test_a_finding_has_the_address_of_the_page_that_its_rule_has_here(monkeypatch: pytest.MonkeyPatch) -> None:
    fault = next(fault for fault in all_faults() if fault.code == "UC201")
    monkeypatch.setattr(faults, "all_faults", lambda: [fault])
    assert fault.url == f"{SITE}rules/UC201/"
    assert f"rules/{fault.code}.md" in fault_pages()


def test_the_manifests_name_the_addresses_of_the_release() -> None:
    urls = tomli.loads((CHECKOUT / "pyproject.toml").read_text("utf-8"))["project"]["urls"]
    assert urls["Documentation"] == SITE
    assert urls["Source"] == REPOSITORY
    assert f"homepage: {REPOSITORY}" in (CHECKOUT / "packaging" / "recipe.yaml").read_text("utf-8")


def test_links_of_documents_lead_to_pages_of_the_site_or_to_the_source() -> None:
    file = CHECKOUT / "docs" / "commands.md"
    places = {str(CHECKOUT / "docs" / "doctor.md"): "doctor.md", str(CHECKOUT / "urdfctl/rules/a.py"): "rules/UC001.md"}

    def here(text: str) -> str:
        return linked(text, file, "commands.md", places)

    assert here("[a](doctor.md#x)") == "[a](doctor.md#x)"
    assert here("[a](../urdfctl/rules/a.py)") == "[a](rules/UC001.md)"
    assert here("[a](../tests/conftest.py)") == f"[a]({REPOSITORY}/blob/main/tests/conftest.py)"
    assert here("`[a](../tests/conftest.py)`") == "`[a](../tests/conftest.py)`"
    assert here("[a](https://example.org/x)") == "[a](https://example.org/x)"


def test_every_page_that_the_menu_names_is_made() -> None:
    menu = (CHECKOUT / "docs" / "site" / "zensical.toml").read_text("utf-8")
    made = {*document_pages(), "messages/index.md", "playground/index.md"}
    named = [part for part in menu.split('"') if part.endswith(".md")]
    assert named
    assert [name for name in named if name not in made] == []


@pytest.mark.parametrize(
    ("body", "told"),
    [
        ('<a href="other.html">x</a>', "the link other.html leads nowhere"),
        ('<a href="#nowhere">x</a>', "the link #nowhere leads nowhere"),
        (f'<a href="{SITE}none/">x</a>', f"the link {SITE}none/ leads nowhere"),
        ('<script src="https://example.org/x.js"></script>', "loads https://example.org/x.js"),
        ("<h3>a level is left out</h3>", "a heading of level 3 after one of level 1"),
        ("<h1>another</h1>", "2 headings of the first level"),
        ('<img src="data:,">', "1 pictures without text"),
    ],
)
def test_what_is_wrong_with_a_page_is_told(tmp_path: Path, body: str, told: str) -> None:
    assert built(tmp_path, page=body) == [f"page.html: {told}"]


def test_a_page_asks_no_other_host_for_the_stars_of_the_repository(tmp_path: Path) -> None:
    page = '<a href="https://github.com/x/y" class="md-source" data-md-component="source">y</a>'
    (tmp_path / "a").mkdir()
    (tmp_path / "a" / "index.html").write_text(page, "utf-8")
    ask_nobody(tmp_path)
    assert (tmp_path / "a" / "index.html").read_text(
        "utf-8"
    ) == '<a href="https://github.com/x/y" class="md-source">y</a>'


def test_a_sound_site_has_no_problems(tmp_path: Path) -> None:
    assert built(tmp_path, page='<a href="other.html#top">x</a><h2>y</h2>', other='<a href="page.html">x</a>') == []
