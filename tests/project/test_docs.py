"""What README.md and docs/ show is so: the terminal's words, the commands and their options, and where links lead."""

from __future__ import annotations

import inspect
import re
import shlex
import textwrap
from collections.abc import Iterator
from pathlib import Path

import pytest
from folder import CHECKOUT
from generating import command

from urdfctl.catalog.log_messages import log_messages
from urdfctl.commands import COMMANDS, FIND, command_named
from urdfctl.commands.generate.options import GenerateOptions
from urdfctl.commands.options import ReadingOptions
from urdfctl.logs.cookbook import COMMONEST, cookbook
from urdfctl.migrate.document import document
from urdfctl.rules import all_faults

PAGES = [
    path.relative_to(CHECKOUT).as_posix()
    for path in (*CHECKOUT.glob("*.md"), *CHECKOUT.glob("docs/*.md"), *CHECKOUT.glob("samples/*.md"))
]
README = (CHECKOUT / "README.md").read_text(encoding="utf-8")
OPTIONS = {name: command_named(name).options for name in COMMANDS}


def blocks(page: str) -> list[str]:
    """The fenced blocks of a page, without their fences."""
    return re.findall(r"^```\w*\n(.*?)^```", (CHECKOUT / page).read_text(encoding="utf-8"), re.MULTILINE | re.DOTALL)


def test_the_terminal_in_the_readme_says_what_it_really_says(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(CHECKOUT)
    shown = [block for block in blocks("README.md") if block.startswith("$ ")]
    assert shown
    for block in shown:
        typed, _, printed = block.partition("\n")
        assert command(*shlex.split(typed)[2:]).stdout == printed


def test_the_readme_is_read_in_two_screens() -> None:
    assert len(README.splitlines()) <= 100


def test_the_readme_promises_no_more_rules_and_messages_than_there_are() -> None:
    [rules] = re.findall(r"more than (\d+) rules", README)
    assert 0.8 * len(all_faults()) < int(rules) < len(all_faults())
    known = sum(len(message.patterns) for message in log_messages())
    for page in ("docs/commands.md", "docs/cookbook.md", "CHANGELOG.md"):
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
def test_the_help_of_every_command_has_an_example_and_the_pages_name_it(name: str) -> None:
    [example] = re.findall(r"^  Example: (urdfctl .*)$", command(name, "--help").stdout, re.MULTILINE)
    assert example in inspect.cleandoc(str(OPTIONS[name].__doc__)), "it is not broken, for it is copied"
    assert example.startswith(f"urdfctl {name} ")
    assert f"urdfctl {name}" in (CHECKOUT / "docs/commands.md").read_text(encoding="utf-8")


def commands_in(cell: str) -> set[str]:
    """The commands that a row of the table of options names."""
    sets = {
        "robots": {name for name, options in OPTIONS.items() if issubclass(options, ReadingOptions)},
        "generators": {name for name, options in OPTIONS.items() if issubclass(options, GenerateOptions)},
    }
    return set().union(*(sets.get(name, {name}) for name in cell.split(", ")))


def rows_of_options() -> Iterator[tuple[str, str, str]]:
    """Yield what the page of commands says of options: a command, a flag and what it does."""
    page = (CHECKOUT / "docs/commands.md").read_text(encoding="utf-8").partition("## Options")[2]
    for flags, cell, text in re.findall(r"^\| (`-.*?`) \| ([a-z0-9, -]+) \| (\S.*?) *\|$", page, re.MULTILINE):
        for name in commands_in(cell):
            for flag in re.findall("[\\w-]+", flags):
                yield name, flag, text


def test_each_option_of_each_command_is_on_the_page_of_commands_and_no_other() -> None:
    written = {(name, flag) for name, flag, _ in rows_of_options()}
    there = {
        (name, flag)
        for name, options in OPTIONS.items()
        for one in options.declared.values()
        for flag in (*one.flags, *one.negatives)
        if not one.hidden
    }
    assert there - written == set(), "give each option a line in its group's table of docs/commands.md"
    assert written - there == set(), "docs/commands.md has options that are not there"


def test_the_page_of_commands_says_of_an_option_what_its_help_says() -> None:
    helps = {
        (name, flag): one.help.removesuffix(".")
        for name, options in OPTIONS.items()
        for one in options.declared.values()
        for flag in one.flags
    }
    others = [(*row, said) for *row, said in rows_of_options() if helps.get((row[0], row[1]), "") not in said]
    assert others == [], "write the words of the option's declaration into docs/commands.md"


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
