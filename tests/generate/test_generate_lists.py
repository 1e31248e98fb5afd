"""Lists of joints as people have them: 40 in all forms, good and bad."""

from __future__ import annotations

import json

import pytest
from folder import Folder
from generating import command

from urdfctl.errors import UserError
from urdfctl.generate.request.joint_list import joints_listed

NAMES = ("elbow", "wrist")
GOOD = {
    "lines.txt": "elbow\nwrist\n",
    "comments.txt": "# my arm\nelbow  # the second\n\nwrist # the last\n",
    "windows.txt": "elbow\r\nwrist\r\n",
    "mark.txt": "\ufeffelbow\nwrist\n",
    "header.txt": "joint_name\nelbow\nwrist\n",
    "one_line.txt": "elbow, wrist\n",
    "comma.csv": "name,effort\nelbow,3\nwrist,4\n",
    "semicolon.csv": "name;effort\nelbow;3\nwrist;4\n",
    "tab.tsv": "name\teffort\nelbow\t3\nwrist\t4\n",
    "title.csv": "Name,Effort [Nm]\nelbow,3\nwrist,4\n",
    "joint.csv": "joint,interface\nelbow,effort\nwrist,effort\n",
    "joint_name.csv": "Joint Name,lower,upper\nelbow,-1,1\nwrist,-2,2\n",
    "second_column.csv": "interface,joint_name\neffort,elbow\neffort,wrist\n",
    "one_column.csv": "name\nelbow\nwrist\n",
    "mark.csv": "\ufeffname,effort\nelbow,3\nwrist,4\n",
    "comments.csv": "# exported\nname,effort\nelbow,3 # checked\n# old,5\nwrist,4\n",
    "quoted.csv": '"name","effort"\n"elbow","3"\n"wrist","4"\n',
    "empty_cells.csv": "name,effort,lower\nelbow,,\nwrist,4,\n",
    "trailing.csv": "name,effort,\nelbow,3,\nwrist,4,\n",
    "gains.csv": "name,pid.p,pid.d\nelbow,100,5\nwrist,50,2\n",
    "controllers.csv": "name,controller,type\nelbow,arm,trajectory\nwrist,arm,trajectory\n",
    "urdf_type.csv": "name,type,gear ratio\nelbow,revolute,50\nwrist,continuous,100\n",
    "names.yaml": "- elbow\n- wrist\n",
    "entries.yaml": "- {name: elbow, effort: 3}\n- {name: wrist, limits: {lower: -1, upper: 1}}\n",
    "mapping.yaml": "elbow: {effort: 3}\nwrist: {gains: {p: 100, d: 5}}\n",
    "bare_mapping.yaml": "elbow:\nwrist:\n",
    "pid.yaml": "- name: elbow\n  pid: {p: 100, i: 0.1, d: 5}\n- name: wrist\n  pid: [100, 0, 5]\n",
    "joints.yaml": "joints: [elbow, wrist]\n",
    "industrial.yaml": "controller_joint_names: ['', 'elbow', 'wrist']\n",
    "controller.yaml": "arm_controller:\n  ros__parameters:\n    type: x/Y\n    joints: [elbow, wrist]\n",
    "moveit.yaml": "joint_limits:\n  elbow: {has_velocity_limits: true, max_velocity: 2.0}\n  wrist: {upper: 1}\n",
    "names.json": json.dumps(NAMES),
    "entries.json": json.dumps([{"name": name, "effort": 3} for name in NAMES], indent="\t"),
    "joints.json": json.dumps({"joints": {name: {"velocity": 2} for name in NAMES}}),
}
BAD = {
    "rows.csv": ("interface,effort\nelbow,50\n", "the header has 'interface' and no column `name` with the joints"),
    "no_header.csv": (
        "elbow,50\nwrist,30\n",
        "'50' is not a joint name; a list with several columns starts with a",
    ),
    "space.txt": ("a b\n", "'a b' is not a joint name"),
    "number.txt": ("elbow\n50\n", "'50' is not a joint name"),
    "twice.csv": ("name,effort,effort\nelbow,3,4\n", "two columns are called 'effort'"),
    "long.csv": ("name,effort\nelbow,3,4\n", "row 2 has 3 cells, but the header has 2"),
    "no_number.csv": ("name,effort\nelbow,much\n", "'effort' must be a number, not 'much'"),
    "unknown.csv": ("name,efort\nelbow,3\n", "unknown key 'efort'; did you mean 'effort'?; known: name, type"),
    "two.yaml": ("a: {joints: [elbow]}\nb: {joints: [wrist]}\n", "several lists of joints; keep one of them"),
    "word.yaml": ("elbow\n", "not a list of joints; write one name per line"),
    "cut.json": ('["elbow", ', "not valid JSON: Expecting value"),
    "gains.yaml": ("- {name: elbow, pid: 3}\n", "'pid' must be a mapping such as {p: 1.0, d: 0.1}, not '3'"),
}


@pytest.mark.parametrize("source", GOOD)
def test_a_list_in_any_form_gives_its_joints(source: str) -> None:
    assert tuple(joint.name for joint in joints_listed(GOOD[source], source)) == NAMES


def test_values_have_the_same_meaning_in_every_form() -> None:
    assert [joint.effort for joint in joints_listed(GOOD["title.csv"], "title.csv")] == [3.0, 4.0]
    assert [joint.interface for joint in joints_listed(GOOD["second_column.csv"], "a.csv")] == ["effort", "effort"]
    assert joints_listed(GOOD["gains.csv"], "gains.csv")[0].gains == (("p", 100.0), ("d", 5.0))
    assert joints_listed(GOOD["pid.yaml"], "pid.yaml")[1].gains == (("p", 100.0), ("i", 0.0), ("d", 5.0))
    assert [joint.controller_type for joint in joints_listed(GOOD["controllers.csv"], "a.csv")] == ["trajectory"] * 2
    assert [joint.type for joint in joints_listed(GOOD["urdf_type.csv"], "a.csv")] == ["revolute", "continuous"]
    assert joints_listed(GOOD["moveit.yaml"], "moveit.yaml")[0].velocity == 2.0


@pytest.mark.parametrize("source", BAD)
def test_a_list_that_cannot_be_read_is_refused_in_one_line(source: str) -> None:
    text, message = BAD[source]
    with pytest.raises(UserError) as caught:
        joints_listed(text, source)
    assert str(caught.value).startswith(f"{source}: {message}")


def test_a_joint_that_the_robot_does_not_have_is_never_written(folder: Folder) -> None:
    folder.write(
        {
            "r.urdf": "<robot name='r'><link name='a'/><link name='b'/><joint name='elbow' type='continuous'>"
            "<parent link='a'/><child link='b'/></joint></robot>",
            "list.csv": "joint;effort\nelbwo;3\n",
        }
    )
    ran = command("gen-controllers", "r.urdf", "list.csv", "--type", "effort", "--distro", "jazzy", "-o", "c.yaml")
    assert (ran.returncode, ran.stderr) == (2, "urdfctl: the robot has no joint 'elbwo'; did you mean 'elbow'?\n")
    assert not (folder.path / "c.yaml").exists()
