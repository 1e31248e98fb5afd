"""Each fault of a running system: a recording in which it is told, and its sound twin in which nothing is."""

from __future__ import annotations

import json
from typing import Any

import pytest
from folder import Folder

from urdfctl.fault import Fault
from urdfctl.rules import faults_found_by

FAULTS = {fault.name: fault for fault in faults_found_by("doctor")}


def diagnosed(folder: Folder, files: dict[str, str]) -> dict[str, Any]:
    folder.write(files)
    ran = folder.run("doctor", "snapshot.json", "--format", "json")
    assert ran.returncode in {0, 1}, ran.stderr
    report: dict[str, Any] = json.loads(ran.stdout)
    assert ran.returncode == bool(report["findings"])
    return report


@pytest.mark.parametrize("fault", FAULTS.values(), ids=FAULTS)
def test_a_fault_is_the_first_that_is_told_of_its_example(folder: Folder, fault: Fault) -> None:
    for example in fault.bad:
        first, *_ = diagnosed(folder, example.files)["findings"]
        assert (first["code"], first["severity"]) == (fault.code, fault.severity.value), first["message"]


def test_of_the_sound_system_nothing_is_told(folder: Folder) -> None:
    [good] = {tuple(sorted(example.files.items())) for fault in FAULTS.values() for example in fault.good}
    report = diagnosed(folder, dict(good))
    assert (report["findings"], report["compared_with"]) == ([], "launch/arm.launch.xml")
    assert report["fine"] == [
        "'/controller_manager' answers, with 1 active component and 2 active controllers",
        "/joint_states comes at 100 Hz with 2 joints",
    ]
