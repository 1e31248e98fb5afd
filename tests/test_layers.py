"""The layers point one way, and what is heavy is loaded only where it is needed."""

from __future__ import annotations

import subprocess
import sys

from folder import CHECKOUT, Folder, environment

HEAVY = ("numpy", "yourdfpy", "pybullet", "mujoco", "matplotlib", "jinja2", "lxml", "pydantic")
ROBOT = """\
<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">
  <xacro:property name="n" value="${1 + 1}"/>
  <link name="a${n}"/>
  <joint name="j" type="x"/>
</robot>
"""


def test_the_import_contracts_hold() -> None:
    ran = subprocess.run(
        [sys.executable, "-c", "from importlinter.cli import lint_imports_command; lint_imports_command()"],
        cwd=CHECKOUT,
        env=environment({}),
        capture_output=True,
        text=True,
        check=False,
    )
    assert ran.returncode == 0, ran.stdout + ran.stderr


def loaded_by(folder: Folder, code: str) -> set[str]:
    """The packages that some code loads in a fresh Python."""
    folder.write({"r.xacro": ROBOT})
    told = "import sys; print('LOADED', *sorted({name.split('.')[0] for name in sys.modules}))"
    ran = subprocess.run(
        [sys.executable, "-c", f"{code}\n{told}"],
        env=environment({}),
        capture_output=True,
        text=True,
        check=True,
    )
    return set(ran.stdout.rpartition("LOADED")[2].split())


LINT = "from urdfctl.__main__ import _run\nassert _run(['lint', 'r.xacro', '--jobs', '1']) == 1"
LINT_HERE = (
    "from urdfctl.load import Loader, Target\n"
    "from urdfctl.lint import Selection\n"
    "from urdfctl.settings import Settings\n"
    "assert Loader(Settings(), Selection()).lint(Target('r.xacro')).outcome.diagnostics"
)


def test_the_command_line_loads_nothing_heavy(folder: Folder) -> None:
    assert not loaded_by(folder, "import urdfctl.cli.app") & set(HEAVY)


def test_a_plain_run_of_lint_loads_neither_that_nor_typer_rich_or_yaml(folder: Folder) -> None:
    unwanted = {*HEAVY, "typer", "click", "rich", "yaml", "inspect", "difflib", "subprocess", "asyncio"}
    assert not loaded_by(folder, LINT) & unwanted


def test_its_worker_loads_nothing_heavy_either(folder: Folder) -> None:
    assert not loaded_by(folder, LINT_HERE) & {*HEAVY, "typer", "click", "rich", "yaml"}
