"""Rules of other packages: they run like all others, and only installed packages can bring them."""

from __future__ import annotations

import json
import os
import re
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path

import pytest
from folder import CHECKOUT

from urdfctl.errors import UserError
from urdfctl.rules.installed import installed_rules

PAGE = (CHECKOUT / "docs" / "own-rules.md").read_text(encoding="utf-8")
RULES, TESTS = re.findall(r"^```python\n(.*?)^```", PAGE, re.MULTILINE | re.DOTALL)
ROBOT = """\
<robot name="r">
  <link name="a"/>
  <joint name="J1" type="fixed"><parent link="a"/><child link="b"/></joint>
  <link name="b"/>
</robot>
"""
STARTED = """\
import sys
sys.prefix = sys.argv.pop(1)
sys.path.insert(0, sys.argv.pop(1))
from urdfctl.__main__ import main
main()
"""


@pytest.fixture
def site(tmp_path: Path) -> Iterator[Path]:
    """A Python's folder of installed packages, with the rules of the page."""
    yield install(tmp_path / "python" / "lib" / "site-packages", RULES)
    installed_rules.cache_clear()


def install(site: Path, code: str, name: str = "acme") -> Path:
    """Install a package of rules in a folder."""
    info = site / f"{name}_rules-1.0.dist-info"
    info.mkdir(parents=True)
    (info / "METADATA").write_text(f"Metadata-Version: 2.1\nName: {name}-rules\nVersion: 1.0\n")
    (info / "entry_points.txt").write_text(f"[urdfctl.rules]\n{name} = {name}_rules:RULES\n")
    (site / f"{name}_rules.py").write_text(code, encoding="utf-8")
    return site


def run(site: Path, *words: str, prefix: Path | None = None) -> subprocess.CompletedProcess[str]:
    """Run urdfctl in a Python with a folder of installed packages."""
    where = [str(prefix or site.parents[1]), str(site)]
    environ = {**os.environ, "PYTHONPATH": str(CHECKOUT)}
    command = [sys.executable, "-P", "-c", STARTED] if sys.version_info >= (3, 11) else [sys.executable, "-c", STARTED]
    return subprocess.run([*command, *where, *words], env=environ, capture_output=True, text=True, check=False)


def in_this_process(site: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Let this process have a folder of installed packages."""
    for name in [name for name in sys.modules if name.endswith("_rules") and name.count("_") == 1]:
        monkeypatch.delitem(sys.modules, name)
    monkeypatch.setattr(sys, "prefix", str(site.parents[1]))
    monkeypatch.syspath_prepend(str(site))
    installed_rules.cache_clear()


def test_the_rule_of_the_page_finds_is_listed_and_is_explained(site: Path, tmp_path: Path) -> None:
    robot = tmp_path / "robot.urdf"
    robot.write_text(ROBOT)
    found = json.loads(run(site, "lint", str(robot), "--format", "json", "--select", "ACME").stdout)["findings"]
    assert [(one["code"], one["severity"]) for one in found] == [("ACME001", "warning")]
    assert "joint 'J1' has capital letters; write 'j1'" in found[0]["message"]
    assert run(site, "rules", "--select", "ACME").stdout.endswith("capital letters. (from acme-rules 1.0)\n")
    assert "The recorder writes names in lower case" in run(site, "explain", "ACME001").stdout


def test_it_is_silenced_by_a_comment(site: Path, tmp_path: Path) -> None:
    robot = tmp_path / "robot.urdf"
    robot.write_text(ROBOT.replace("<joint", "<!-- urdfctl: ignore[ACME001] as bought -->\n<joint"))
    assert "ACME001" not in run(site, "lint", str(robot), "--select", "ACME").stdout


def test_a_changed_rule_is_no_earlier_result(site: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path / "cache"))
    robot = tmp_path / "robot.urdf"
    robot.write_text(ROBOT)
    assert "ACME001" in run(site, "lint", str(robot), "--select", "ACME").stdout
    (site / "acme_rules.py").write_text(RULES.replace("joint.name.lower()", "joint.name"), encoding="utf-8")
    assert "ACME001" not in run(site, "lint", str(robot), "--select", "ACME").stdout


def test_the_tests_of_the_page_pass(site: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    in_this_process(site, monkeypatch)
    names: dict[str, object] = {}
    exec(compile(TESTS, "test_acme.py", "exec"), names)  # noqa: S102 (the page's own)
    [installed] = installed_rules()
    for rule in installed.rules:
        names["test_the_examples_of_a_rule_hold"](rule)  # type: ignore[operator]


@pytest.mark.parametrize(
    ("old", "new", "said"),
    [
        ("«Wrist»", "«wrist»", "bad example 1 of ACME001 is not reported"),
        ("«Wrist»", "Wrist", "bad example 1 of ACME001 marks no place"),
        ('<joint name="«Wrist»" type="fixed">', '<joint name="Wrist" type="«fixed»">', "is reported elsewhere"),
        ('<joint name="«Wrist»" type="fixed">', '<joint name="Wrist" type="«fixed»">', "reported:\nrobot.urdf:"),
        ('name="wrist"', 'name="Wrist"', "good example 1 of ACME001 is reported"),
        ("Severity.WARNING", "Severity.ERROR", "its severity is warning"),
        ("for joint in", "for joint in 1 / 0 or", "ZeroDivisionError"),
    ],
)
def test_a_rule_whose_examples_do_not_hold_fails_with_the_reason(
    old: str, new: str, said: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    from urdfctl.testing import assert_rule

    in_this_process(install(tmp_path / "lib" / "site-packages", RULES.replace(old, new)), monkeypatch)
    [rule] = installed_rules()[0].rules
    with pytest.raises(AssertionError, match=re.escape(said)):
        assert_rule(rule)
    installed_rules.cache_clear()


@pytest.mark.parametrize(
    ("code", "said"),
    [
        (
            "import missing_module",
            "the rules of acme-rules 1.0 (acme_rules:RULES) cannot be loaded: Module",
        ),
        ("RULES = [1]", "acme_rules:RULES of acme-rules 1.0 has 1, which is not a rule"),
        (RULES.replace("ACME001", "UC999"), "rule 'UC999' of acme-rules 1.0 needs a code of its own"),
        (RULES.replace("ACME001", "acme"), "rule 'acme' of acme-rules 1.0 needs a code of its own"),
        (RULES + "RULES *= 2\n", "rule ACME001 comes from both acme-rules 1.0 and acme-rules 1.0"),
    ],
)
def test_a_package_that_cannot_be_used_ends_the_run_with_one_line(code: str, said: str, tmp_path: Path) -> None:
    site = install(tmp_path / "python" / "lib" / "site-packages", code)
    robot = tmp_path / "robot.urdf"
    robot.write_text(ROBOT)
    for command in ("lint", "smoke"):
        ended = run(site, command, str(robot))
        assert ended.returncode == 2
        assert said in ended.stderr
        assert ended.stderr.count("\n") == 1


def test_two_packages_with_one_code_are_told_apart(site: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    in_this_process(install(site, RULES, name="other"), monkeypatch)
    with pytest.raises(UserError, match=r"ACME001 comes from both acme-rules 1\.0 and other-rules 1\.0"):
        installed_rules()


def test_what_lies_in_the_linted_folder_or_on_pythonpath_brings_no_rules(tmp_path: Path) -> None:
    evil = f"open({str(tmp_path / 'ran')!r}, 'w').close()\nRULES = []\n"
    linted = install(tmp_path / "linted" / "install" / "lib" / "site-packages", evil)
    (tmp_path / "linted" / "robot.urdf").write_text(ROBOT)
    run(linted, "lint", str(tmp_path / "linted"), prefix=Path(sys.prefix))
    assert not (tmp_path / "ran").exists()
    run(linted, "lint", str(tmp_path / "linted"))
    assert (tmp_path / "ran").exists(), "it would have been seen"
