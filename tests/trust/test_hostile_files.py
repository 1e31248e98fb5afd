"""What strangers may put into a pull request: each file gets a located finding in bounded time, and harms nobody."""

from __future__ import annotations

import json
from typing import Any

import pytest
from corpus import CORPUS, own_roots, roots
from folder import Folder
from hostile.robots import HIDDEN, TRIED, XACRO
from sampling import sample

from urdfctl.config.settings import Settings
from urdfctl.lint.selection import Selection
from urdfctl.lint.target import lint_target
from urdfctl.load.loader import Loader
from urdfctl.load.target import Target


@pytest.mark.parametrize("tried", TRIED)
def test_a_hostile_file_gets_a_finding_in_bounded_time_and_harms_nobody(folder: Folder, tried: str) -> None:
    code, files = TRIED[tried]
    folder.write({"secret": HIDDEN, **{f"pull/{name}": text for name, text in files.items()}})
    (folder.path / "pull" / "out").symlink_to(folder.path)
    main = next(iter(files))
    words = ("lint", f"pull/{main}", "--workspace", "pull", "--format", "json", "--timeout", "50")  # on a busy machine
    ran = folder.run(*words, environ={"PASSWORD": HIDDEN})
    found = [finding for finding in json.loads(ran.stdout)["findings"] if finding["severity"] == "error"]
    assert ran.returncode == 1, ran.stderr
    assert [(one["code"], one["file"]) for one in found][:1] == [(code, f"pull/{main}")], found
    assert HIDDEN not in ran.stdout + ran.stderr
    assert not (folder.path / "ran").exists()


def test_a_variable_of_the_users_is_not_read(folder: Folder) -> None:
    folder.write({"r.xacro": XACRO.format('<link name="$(env PASSWORD)"/>')})
    ran = folder.run("lint", "r.xacro", "--format", "json", environ={"PASSWORD": HIDDEN})
    found = [(finding["code"], finding["message"]) for finding in json.loads(ran.stdout)["findings"]]
    assert ("UC030", "needs environment variable PASSWORD; what depends on it is not checked") in found
    assert HIDDEN not in ran.stdout + ran.stderr


def test_no_expression_of_a_real_robot_is_refused() -> None:
    loader = Loader(Settings())
    refused: list[Any] = []
    for root in (*own_roots(), *sample(roots(), 12)):
        arguments = tuple((str(name), str(value)) for name, value in (root.get("args") or {}).items())
        refused += lint_target(
            loader, Target(str(CORPUS / root["path"]), arguments), Selection(select=("UC015",))
        ).result.outcome.diagnostics
    assert refused == []
