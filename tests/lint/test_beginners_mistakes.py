"""A beginner's mistakes, one at a time, in two packages that work: the first finding names each; fixes repair most."""

from __future__ import annotations

import json

import pytest
from beginners_mistakes import IN_ARM, IN_BASE, Mistake
from beginners_robots import ARM, BASE
from folder import Folder
from generating import command


def named(mistake: Mistake) -> str:
    return f"{mistake.code}-{mistake.told}"


@pytest.mark.parametrize(("files", "distro"), [(BASE, "noetic"), (ARM, "jazzy")], ids=["base", "arm"])
def test_the_packages_themselves_have_no_fault(folder: Folder, files: dict[str, str], distro: str) -> None:
    folder.write(files)
    found = json.loads(command("lint", ".", "--distro", distro, "--format", "json").stdout)["findings"]
    assert [finding["message"] for finding in found if finding["severity"] != "info"] == []


@pytest.mark.parametrize("mistake", IN_BASE, ids=named)
def test_a_mistake_in_the_base_is_named_first_and_repaired(folder: Folder, mistake: Mistake) -> None:
    check(folder, BASE, mistake, "noetic")


@pytest.mark.parametrize("mistake", IN_ARM, ids=named)
def test_a_mistake_in_the_arm_is_named_first_and_repaired(folder: Folder, mistake: Mistake) -> None:
    check(folder, ARM, mistake, "jazzy")


def check(folder: Folder, files: dict[str, str], mistake: Mistake, distro: str) -> None:
    """The mistake is the first finding, and its fix leaves no finding but info."""
    assert mistake.right in files[mistake.file]
    folder.write({**files, mistake.file: files[mistake.file].replace(mistake.right, mistake.wrong, 1)})
    first = json.loads(command("lint", ".", "--distro", distro, "--format", "json").stdout)["findings"][0]
    assert first["code"] == mistake.code
    assert mistake.told in first["message"]
    fix = first["fix"]
    assert ("" if not fix or not fix["edits"] else "safe" if fix["safe"] else "unsafe") == mistake.fix
    if mistake.fix:
        option = "--fix" if mistake.fix == "safe" else "--unsafe-fixes"
        command("lint", ".", "--distro", distro, option)
        after = json.loads(command("lint", ".", "--distro", distro, "--format", "json").stdout)["findings"]
        assert [finding["message"] for finding in after if finding["severity"] != "info"] == []


def test_most_mistakes_have_a_fix_and_few_fixes_leave_a_choice() -> None:
    fixes = [mistake.fix for mistake in (*IN_BASE, *IN_ARM)]
    assert len(fixes) == 25
    assert (fixes.count("safe"), fixes.count("unsafe"), fixes.count("")) == (16, 7, 2)
