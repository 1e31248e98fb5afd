"""The motions of a smoke test as a table, and what is asked wrongly for it."""

from __future__ import annotations

from folder import Folder
from generating import command
from smoking import smoked

from urdfctl.load.target import Target
from urdfctl.smoke.curves import COLUMNS, curves_as_csv
from urdfctl.smoke.results import Curve


def test_each_sample_of_a_curve_has_a_line(folder: Folder) -> None:
    folder.write({"arm.urdf": '<robot name="arm"><link name="base"/></robot>'})
    robot = smoked(Target("arm.urdf"))
    plain = Curve("arm", "elbow", "position", (0.0, 0.1), (0.0, 0.2), (0.0, 0.1 + 0.1 / 3))
    pushed = plain._replace(joint="lift", efforts=(5.0, 7.5), unit="m")
    path = folder.path / "arm.urdf"
    lines = curves_as_csv([robot._replace(curves=(plain, pushed))]).splitlines()
    assert lines == [
        ",".join(COLUMNS),
        f"{path},arm,elbow,position,rad,0,0,0,",
        f"{path},arm,elbow,position,rad,0.1,0.2,0.133333,",
        f"{path},arm,lift,position,m,0,0,0,5",
        f"{path},arm,lift,position,m,0.1,0.2,0.133333,7.5",
    ]


def test_a_table_needs_a_file_and_an_engine(folder: Folder) -> None:
    folder.write({"r.urdf": '<robot name="r"><link name="a"/></robot>'})
    assert "requires the name of a file" in command("smoke", "r.urdf", "--csv", "").stderr
    assert "requires a physics engine" in command("smoke", "r.urdf", "--csv", "c.csv", "--engine", "none").stderr
    assert not (folder.path / "c.csv").exists()
