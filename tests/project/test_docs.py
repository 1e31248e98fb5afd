"""What README.md and docs/ show is so: the terminal's words, the commands and their options, and where links lead."""

from __future__ import annotations

import inspect
import re
import textwrap
from pathlib import Path

import pytest
from doc_lines import lines_of
from folder import CHECKOUT
from generating import command

from urdfctl.catalog.log_messages import log_messages
from urdfctl.commands import COMMANDS, FIND, command_named
from urdfctl.commands.document import explanation_of, man_page
from urdfctl.commands.document import pages as documented
from urdfctl.logs.cookbook import COMMONEST, cookbook
from urdfctl.migrate.document import document
from urdfctl.rules import all_faults

PAGES = [
    path.relative_to(CHECKOUT).as_posix()
    for path in (*CHECKOUT.glob("*.md"), *CHECKOUT.glob("docs/**/*.md"), *CHECKOUT.glob("samples/*.md"))
    if "node_modules" not in path.parts
]
README = (CHECKOUT / "README.md").read_text(encoding="utf-8")
OPTIONS = {name: command_named(name).options for name in COMMANDS}


def blocks(page: str) -> list[str]:
    """The fenced blocks of a page, without their fences."""
    return re.findall(r"^```\w*\n(.*?)^```", (CHECKOUT / page).read_text(encoding="utf-8"), re.MULTILINE | re.DOTALL)


def test_the_readme_is_read_in_two_screens() -> None:
    assert len(README.splitlines()) <= 100


def test_the_readme_promises_no_more_rules_and_messages_than_there_are() -> None:
    [rules] = re.findall(r"more than (\d+) rules", README)
    assert 0.8 * len(all_faults()) < int(rules) < len(all_faults())
    known = sum(len(message.patterns) for message in log_messages())
    for page in ("docs/commands/explain.md", "docs/cookbook.md", "CHANGELOG.md"):
        [messages] = re.findall(r"more than (\d+) messages", (CHECKOUT / page).read_text("utf-8"))
        assert 0.8 * known < int(messages) < known, page


@pytest.mark.parametrize("page", PAGES)
def test_each_command_on_a_page_has_the_options_that_stand_there(page: str) -> None:
    for line in "".join(blocks(page)).splitlines():
        said = re.match(r"(?:\$ )?urdfctl ([a-z0-9-]+)", line)
        if said:
            assert said[1] in COMMANDS, line
            declared = OPTIONS[said[1]].declared.values()
            known = {"--help", *(flag for one in declared for flag in (*one.flags, *one.negatives))}
            assert set(re.findall(r"(?<!\S)\(?(--[a-z-]+)", line)) <= known, line


@pytest.mark.parametrize("name", COMMANDS)
def test_the_help_of_every_command_has_an_example(name: str) -> None:
    [example] = re.findall(r"^  Example: (urdfctl .*)$", command(name, "--help").stdout, re.MULTILINE)
    assert example in inspect.cleandoc(str(OPTIONS[name].__doc__)), "it is not broken, for it is copied"
    assert example.startswith(f"urdfctl {name} ")


def test_the_pages_of_the_commands_say_what_their_declarations_say() -> None:
    old = [path.name for path, text in documented(CHECKOUT / "docs") if path.read_text(encoding="utf-8") != text]
    assert old == [], "python -m urdfctl.commands.document docs"


def test_the_page_of_a_command_begins_with_the_examples_of_its_help() -> None:
    for name, options in OPTIONS.items():
        text, examples = explanation_of(options)
        page = (CHECKOUT / f"docs/commands/{name}.md").read_text(encoding="utf-8")
        assert page.startswith(f"# urdfctl {name}\n\n{' '.join(text.split())}\n"), name
        assert set(examples) <= {line.text for line in lines_of(CHECKOUT / f"docs/commands/{name}.md")}, name


def test_the_manual_page_has_each_command_and_no_control_line_of_its_own() -> None:
    page = man_page()
    assert [name for name in COMMANDS if f".SS urdfctl {name} ".replace("-", "\\-") not in page] == []
    assert set(re.findall(r"^\.[A-Z]+", page, re.MULTILINE)) <= {".TH", ".SH", ".SS", ".TP", ".B", ".PP", ".EX", ".EE"}


def test_the_list_of_commands_says_each_to_its_end() -> None:
    assert "..." not in command("--help").stdout.partition(f"{FIND}:")[2]


@pytest.mark.parametrize("page", PAGES)
def test_every_link_of_a_page_leads_to_a_file(page: str) -> None:
    text = re.sub(r"^```.*?^```", "", (CHECKOUT / page).read_text(encoding="utf-8"), flags=re.MULTILINE | re.DOTALL)
    links = [link.partition("#")[0] for link in re.findall(r"\]\((?!https?:)([^)\s]+)\)", text)]
    assert [link for link in links if link and not (CHECKOUT / Path(page).parent / link).exists()] == []


def test_the_cookbook_is_up_to_date() -> None:
    written = (CHECKOUT / "docs/cookbook.md").read_text(encoding="utf-8")
    assert written == cookbook(), "python -m urdfctl.logs.cookbook > docs/cookbook.md"


def test_the_page_on_migrating_is_up_to_date() -> None:
    written = (CHECKOUT / "docs/migrating.md").read_text(encoding="utf-8")
    assert written == document(), "python -m urdfctl.migrate.document > docs/migrating.md"


def test_the_cookbook_has_ten_messages_with_nothing_left_to_fill_in() -> None:
    headings = re.findall(r"^## `(.*)`$", cookbook(), re.MULTILINE)
    assert len(headings) == 10
    assert "Could not find resource 'JOINT' in 'INTERFACE'." in headings[1]
    assert "{ros__parameters: {CONTROLLER: {type: package/Class}}}" in cookbook()
    assert cookbook().count(", fixed:\n```diff\n--- ") == len([code for code in COMMONEST.values() if code])


def test_the_rule_that_shows_how_to_write_one_is_the_real_one() -> None:
    text = (CHECKOUT / "CONTRIBUTING.md").read_text("utf-8")
    shown = textwrap.dedent(text.partition("```python\n")[2].partition("   ```\n")[0])
    path = "urdfctl/rules/urdf/gazebo_reference_unknown.py"
    assert shown == (CHECKOUT / path).read_text("utf-8"), f"copy {path} to CONTRIBUTING.md again"
