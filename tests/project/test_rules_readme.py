"""urdfctl/rules/README.md is what its generator writes."""

from __future__ import annotations

import re

from folder import CHECKOUT

from urdfctl.rules import all_faults
from urdfctl.rules.readme import readme

RULES = CHECKOUT / "urdfctl" / "rules"


def test_the_table_of_the_rules_is_up_to_date() -> None:
    written = (RULES / "README.md").read_text(encoding="utf-8")
    assert written == readme(), "python -m urdfctl.rules.readme > urdfctl/rules/README.md"


def test_it_names_every_fault_and_links_to_its_file() -> None:
    links = dict(re.findall(r"^\| \[(UC\d+)\]\((\S+)\)", readme(), re.MULTILINE))
    assert list(links) == [fault.code for fault in all_faults()]
    assert [path for path in links.values() if not (RULES / path).is_file()] == []


def test_every_fault_has_a_file_of_its_own_named_after_it() -> None:
    for fault in all_faults():
        module = fault.module.rpartition(".")[2]
        assert module == fault.function.__name__, fault.code


def test_every_file_with_a_fault_is_listed() -> None:
    listed = {fault.module.removeprefix("urdfctl.rules.") for fault in all_faults()}
    written = {
        ".".join(path.relative_to(RULES).with_suffix("").parts)
        for path in RULES.glob("*/*.py")
        if re.search(r"^@(?:rule|fault)\(", path.read_text(encoding="utf-8"), re.MULTILINE)
    }
    assert written - listed == set(), "import each in family.py of its folder, and list it there in FAULTS"
    assert listed - written == set()
