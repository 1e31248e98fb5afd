"""The layers point one way, and what is heavy is loaded only where it is needed."""

from __future__ import annotations

import subprocess
import sys

import pytest
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
    "from urdfctl.config.settings import Settings\n"
    "from urdfctl.lint.job import job_for, lint_work, perform_alone\n"
    "from urdfctl.load.target import Target\n"
    "assert perform_alone(job_for(lint_work, Target('r.xacro'), Settings()))['outcome']['diagnostics']"
)


def test_the_command_line_loads_nothing_heavy(folder: Folder) -> None:
    assert not loaded_by(folder, "import urdfctl.cli.app") & set(HEAVY)


def test_a_plain_run_of_lint_loads_neither_that_nor_typer_rich_or_yaml(folder: Folder) -> None:
    unwanted = {*HEAVY, "typer", "click", "rich", "yaml", "inspect", "difflib", "subprocess", "asyncio"}
    assert not loaded_by(folder, LINT) & unwanted


def test_a_plain_run_of_lint_loads_nothing_of_the_commands_that_show_a_robot(folder: Folder) -> None:
    folder.write({"r.xacro": ROBOT})
    code = f"{LINT}\nimport sys\nprint('LOADED', *sys.modules)"
    ran = subprocess.run([sys.executable, "-c", code], env=environment({}), capture_output=True, text=True, check=True)
    loaded = ran.stdout.rpartition("LOADED")[2].split()
    shown = (
        "urdfctl.trace",
        "urdfctl.compare",
        "urdfctl.graph",
        "urdfctl.source.xacro.tracing",
        "urdfctl.report.pages",
    )
    assert [name for name in loaded if name.startswith(shown)] == []
    assert "urdfctl.source.xacro.expansion" in loaded or "urdfctl.lint.job" in loaded


def test_its_worker_loads_nothing_heavy_either(folder: Folder) -> None:
    assert not loaded_by(folder, LINT_HERE) & {*HEAVY, "typer", "click", "rich", "yaml"}


FAMILIES = """
import sys
from urdfctl.config.settings import Settings
from urdfctl.lint.job import job_for, lint_work, perform_alone
from urdfctl.load.target import Target
perform_alone(job_for(lint_work, Target("r.urdf", controllers=tuple(sys.argv[1:])), Settings()))
families = (name.split(".") for name in sys.modules if name.startswith("urdfctl.rules."))
print(*sorted({name[2] for name in families if name[3:] == ["family"]}))
"""
COMPONENT = '<ros2_control name="c" type="system"><hardware><plugin>{}</plugin></hardware></ros2_control>'
MOCK, GZ = "mock_components/GenericSystem", "gz_ros2_control/GazeboSimSystem"
CAMERA = '<sensor type="camera" name="c"><plugin filename="libgazebo_ros_camera.so"/></sensor>'


@pytest.mark.parametrize(
    ("inside", "families"),
    [
        ('<gazebo reference="a"><material>Gazebo/Red</material></gazebo>', "urdf"),
        (COMPONENT.format(MOCK), "migration ros2_control urdf"),
        (COMPONENT.format(GZ), "migration ros2_control simulation urdf"),
        ('<gazebo><plugin filename="libgazebo_ros_control.so"/></gazebo>', "simulation urdf"),
        (f'<gazebo reference="a">{CAMERA}</gazebo>', "migration simulation urdf"),
    ],
)
def test_only_the_families_that_concern_a_robot_are_loaded(folder: Folder, inside: str, families: str) -> None:
    folder.write({"r.urdf": f'<robot name="r"><link name="a"/>{inside}</robot>'})
    ran = subprocess.run([sys.executable, "-c", FAMILIES], capture_output=True, text=True, check=True)
    assert ran.stdout.strip() == families


def test_rules_on_controllers_are_loaded_with_their_files(folder: Folder) -> None:
    robot = f'<robot name="r"><link name="a"/>{COMPONENT.format(MOCK)}</robot>'
    folder.write({"r.urdf": robot, "c.yaml": "controller_manager: {ros__parameters: {update_rate: 100}}"})
    ran = subprocess.run([sys.executable, "-c", FAMILIES, "c.yaml"], capture_output=True, text=True, check=True)
    assert ran.stdout.split() == ["claims", "controllers", "migration", "ros2_control", "urdf"]


def test_no_module_imports_itself_through_others() -> None:
    code = """
import graphlib, grimp
graph = grimp.build_graph("urdfctl", exclude_type_checking_imports=False)
edges = {module: graph.find_modules_directly_imported_by(module) for module in graph.modules}
graphlib.TopologicalSorter(edges).prepare()
"""
    ran = subprocess.run([sys.executable, "-c", code], cwd=CHECKOUT, capture_output=True, text=True, check=False)
    assert ran.returncode == 0, ran.stderr


def test_few_modules_are_loose() -> None:
    assert len(list((CHECKOUT / "urdfctl").glob("*.py"))) <= 6
