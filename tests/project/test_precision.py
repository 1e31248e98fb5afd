"""The page on precision counts what people judged, and nothing of the repositories' content."""

from __future__ import annotations

from pathlib import Path

from precision import judged, page, verdicts_in

ROBOT = """<robot name="secret">
  <link name="base"/><link name="arm"/>
  <joint name="c" type="fixed"><parent link="base"/><child link="arm"/></joint>
  <joint name="a" type="fixed"><parent link="base"/><child link="nowhere"/></joint>
  <joint name="b" type="fixed"><parent link="base"/><child link="elsewhere"/></joint>
</robot>
"""


def test_errors_are_counted_by_their_verdict_and_others_as_not_judged(tmp_path: Path) -> None:
    tree = tmp_path / "ada__arm"
    (tree / ".git").mkdir(parents=True)
    (tree / "robot.urdf").write_text(ROBOT)
    labels = tmp_path / "verdicts.yaml"
    labels.write_text("errors:\n- {repo: ada__arm, code: UC116, file: robot.urdf, line: 4, verdict: true}\n")
    found = judged(tree, verdicts_in(labels))
    assert (found.verdicts["true"], found.verdicts["not judged"]) == (1, 1)
    written = page([found])
    assert "| ada/arm | 2 | 1 | 0 | 0 | 1 |" in written
    assert "Of 1 errors that were judged 1 are true (100%) and\n0 false (0%)." in written
    assert "secret" not in written
