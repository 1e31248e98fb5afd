"""MuJoCo as we load it."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import pytest

pytest.importorskip("mujoco")
LOADED = "from urdfctl.smoke.engines.quick_mujoco import load\nmujoco = load()\nassert load() is mujoco\n"
PLUGIN = "def register():\n    print('plugin of another package')\n"
MANIFEST = "Metadata-Version: 2.1\nName: gears\nVersion: 1.0\n"


def printed(script: str, *folders: Path) -> str:
    """What a new process prints that runs a script, with folders of other packages."""
    paths = os.pathsep.join([*map(str, folders), *filter(None, sys.path)])
    done = subprocess.run(
        [sys.executable, "-c", script],
        env={**os.environ, "PYTHONPATH": paths},
        capture_output=True,
        text=True,
        check=True,
    )
    return done.stdout.strip()


def test_modules_that_were_left_out_are_there_when_they_are_used() -> None:
    script = (
        "import io, sys, zipfile, importlib.metadata, ctypes.util, subprocess\n"
        "spec = mujoco.MjSpec.from_string('<mujoco model=\"crane\"><worldbody/></mujoco>')\n"
        "file = io.BytesIO()\n"
        "mujoco.MjSpec.to_zip(spec, file)\n"
        "print(zipfile.ZipFile(file).namelist(), importlib.metadata.version('pyyaml') > '', subprocess.PIPE)\n"
    )
    assert printed(LOADED + script) == "['crane.xml'] True -1"


def test_plugins_of_other_packages_are_not_run(tmp_path: Path) -> None:
    (tmp_path / "gears.py").write_text(PLUGIN, encoding="utf-8")
    folder = tmp_path / "gears-1.0.dist-info"
    folder.mkdir()
    (folder / "METADATA").write_text(MANIFEST, encoding="utf-8")
    (folder / "entry_points.txt").write_text("[mujoco.plugins]\ngears = gears:register\n", encoding="utf-8")
    assert printed(LOADED, tmp_path) == ""
    assert "plugin of another package" in printed("import mujoco", tmp_path)
