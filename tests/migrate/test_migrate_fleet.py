"""The table of a migration of many packages."""

from __future__ import annotations

import json
from pathlib import Path

import pytest
from folder import Folder
from ros1_packages import EFFORT, MANIFEST, arm, transmission

WORDS = ("migrate", ".", "--to", "jazzy", "--simulator", "none")


@pytest.fixture
def packages(folder: Folder) -> Folder:
    robot = arm(transmission("EffortJointInterface"))
    for name in ("arm", "hand"):
        manifest = MANIFEST.replace("<name>arm<", f"<name>{name}<")
        folder.write({f"{name}/package.xml": manifest, f"{name}/config/c.yaml": EFFORT, f"{name}/urdf/a.xacro": robot})
    folder.write({"hand/urdf/broken.urdf": "<robot><link></robot>\n", "hand/src/n.py": "import rospy\n"})
    return folder


def numbers(text: str) -> dict[str, list[int]]:
    lines = [line.split() for line in text.splitlines()]
    start = next(index for index, line in enumerate(lines) if line[:2] == ["package", "applied"])
    return {line[0]: [int(word) for word in line[-5:]] for line in lines[start + 1 :]}


def test_the_table_has_a_line_for_each_package_and_one_for_all(packages: Folder) -> None:
    ran = packages.run(*WORDS, "--table", "-")
    found = numbers(ran.stdout)
    assert list(found) == ["arm", "hand", "2"]
    assert found["2"] == [one + other for one, other in zip(found["arm"], found["hand"], strict=True)]
    assert found["arm"][4] == 0
    assert found["hand"][4] == 1
    assert found["hand"][2] == found["arm"][2] + 1
    done, choices, left = (sum(found["2"][:1]), found["2"][1], sum(found["2"][2:]))
    assert f"{done} applied, {choices} choice" in ran.stderr
    assert f"{left} left to you" in ran.stderr


def test_the_table_is_json_or_a_page_by_the_name_of_its_file(packages: Folder) -> None:
    packages.run(*WORDS, "--table", "table.json")
    data = json.loads(Path("table.json").read_text(encoding="utf-8"))
    assert [row["package"] for row in data["packages"]] == ["arm", "hand"]
    assert [line["file"] for line in data["packages"][1]["lines"] if "rospy" in line["message"]] == ["src/n.py"]
    packages.run(*WORDS, "--table", "table.html")
    page = Path("table.html").read_text(encoding="utf-8")
    assert "<h1>Migration of 2 packages to jazzy</h1>" in page
    assert "src/n.py:1" in page
