"""The tests run this checkout, even where another copy of urdfctl is installed."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

from folder import CHECKOUT, Folder

import urdfctl

FAKE = "raise RuntimeError('another copy of urdfctl was imported')\n"
WHERE = "import urdfctl; print(urdfctl.__file__)"


def test_this_process_imports_the_checkout() -> None:
    assert Path(urdfctl.__file__) == CHECKOUT / "urdfctl" / "__init__.py"


def test_a_command_runs_the_checkout_though_python_path_names_another_copy(folder: Folder) -> None:
    folder.write({"other/urdfctl/__init__.py": FAKE, "other/urdfctl/__main__.py": FAKE})
    ran = folder.run("--version", environ={"PYTHONPATH": str(folder.path / "other")})
    assert (ran.stdout, ran.stderr) == (f"urdfctl {urdfctl.__version__}\n", "")


def test_a_process_that_inherits_the_environment_imports_the_checkout(folder: Folder) -> None:
    ran = subprocess.run([sys.executable, "-c", WHERE], capture_output=True, text=True, check=True)
    assert Path(ran.stdout.strip()) == CHECKOUT / "urdfctl" / "__init__.py"


def test_pytest_imports_the_checkout_though_another_copy_is_installed(folder: Folder) -> None:
    folder.write({"other/urdfctl/__init__.py": FAKE})
    other = repr(str(folder.path / "other"))
    # as an installed copy: on sys.path before pytest starts, and in the environment that its processes inherit
    code = f"import os, sys; sys.path.insert(1, {other}); os.environ['PYTHONPATH'] = {other}; import pytest"
    words = ["-q", "-p", "no:cacheprovider", "-k", "this_process or inherits", str(Path(__file__))]
    ran = subprocess.run(
        [sys.executable, "-c", f"{code}; sys.exit(pytest.main({words!r}))"],
        cwd=CHECKOUT,
        capture_output=True,
        text=True,
        check=False,
    )
    assert "2 passed" in ran.stdout, ran.stdout + ran.stderr
