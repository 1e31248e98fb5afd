"""The file of a user's tasks: the times and keys that each kind of task takes, and how much is read."""

from __future__ import annotations

from pathlib import Path

import pytest

from urdfctl.errors import UserError
from urdfctl.smoke.tasks.task_file import TaskFile, UserTask, read_tasks


def read(folder: Path, text: str) -> TaskFile:
    path = folder / "tasks.yaml"
    path.write_text(text, encoding="utf-8")
    return read_tasks(str(path))


def task(folder: Path, inside: str) -> UserTask:
    [made] = read(folder, f"controllers:\n  arm: {{{inside}}}\n").user_tasks
    return made


@pytest.mark.parametrize("kind", ["target", "velocity"])
def test_a_joint_has_some_seconds_to_reach_its_target_unless_the_file_says(kind: str, tmp_path: Path) -> None:
    assert 1.0 < task(tmp_path, f"{kind}: {{j: 0.5}}").seconds < 5.0
    assert task(tmp_path, f"{kind}: {{j: 0.5}}, within: 7").seconds == 7.0


@pytest.mark.parametrize("inside", ["target: {j: 1}, within: 59", "drive: [{for: 30}, {for: 29}]"])
def test_a_task_of_nearly_a_minute_is_accepted_and_a_longer_one_is_not(inside: str, tmp_path: Path) -> None:
    assert task(tmp_path, inside).seconds == 59.0
    with pytest.raises(UserError, match="takes 61 s; at most 60"):
        task(tmp_path, inside.replace("59", "61").replace("29", "31"))


@pytest.mark.parametrize(
    ("inside", "tolerances"),
    [
        ("target: {j: 1}, tolerance: 0.1, path_tolerance: 0.2", (0.1, 0.2, None)),
        ("trajectory: [{at: 1, joints: {j: 1}}], tolerance: 0.1, path_tolerance: 0.2", (0.1, 0.2, None)),
        ("velocity: {j: 1}, tolerance: 0.1", (0.1, None, None)),
        ("drive: [{for: 1}], tolerance: 0.1, angle_tolerance: 0.3", (0.1, None, 0.3)),
    ],
)
def test_each_kind_has_its_tolerances(
    inside: str, tolerances: tuple[float | None, float | None, float | None], tmp_path: Path
) -> None:
    made = task(tmp_path, inside)
    assert (made.tolerance, made.path_tolerance, made.angle_tolerance) == tolerances


@pytest.mark.parametrize(
    ("inside", "word"),
    [
        ("velocity: {j: 1}, path_tolerance: 0.2", "path_tolerance"),
        ("drive: [{for: 1}], within: 1", "within"),
        ("drive: [{for: 1}], path_tolerance: 1", "path_tolerance"),
        ("velocity: {j: 1}, angle_tolerance: 1", "angle_tolerance"),
        ("trajectory: [{at: 1, joints: {j: 1}}], angle_tolerance: 1", "angle_tolerance"),
        ("trajectory: [{at: 1, joints: {j: 1}}], within: 1", "within"),
        ("target: {j: 1}, speed: 1", "speed"),
    ],
)
def test_a_key_without_a_meaning_is_an_error(inside: str, word: str, tmp_path: Path) -> None:
    with pytest.raises(UserError, match=word):
        task(tmp_path, inside)


def test_a_file_may_hold_a_start_pose_alone(tmp_path: Path) -> None:
    made = read(tmp_path, "start: {elbow: 0.5, shoulder: -1}\n")
    assert (made.start, made.user_tasks) == ((("elbow", 0.5, 1), ("shoulder", -1.0, 1)), ())


@pytest.mark.parametrize(("kibibytes", "whole"), [(900, True), (1100, False)])
def test_a_mebibyte_of_a_file_is_read(kibibytes: int, whole: bool, tmp_path: Path) -> None:
    text = ("#" + "x" * 1022 + "\n") * kibibytes + "start: {elbow: 0.5}\n"
    if whole:
        assert len(read(tmp_path, text).start) == 1
    else:
        with pytest.raises(UserError):
            read(tmp_path, text)
