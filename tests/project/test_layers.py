"""The layers point one way, and what is heavy is loaded only where it is needed."""

from __future__ import annotations

import ast
import re
import subprocess
import sys
from pathlib import Path

import pytest
from folder import CHECKOUT, Folder, environment

PACKAGES_OF_THE_MODEL = ("robot", "controllers", "moveit", "launch", "launch/ros2")
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


def test_the_packages_of_the_smoke_test_are_imported_by_their_faces() -> None:
    """What stands in `urdfctl/smoke/robot/__init__.py` is what others may use of the package; tests import modules."""
    smoke = CHECKOUT / "urdfctl" / "smoke"
    packages = [face.parent for face in smoke.glob("*/__init__.py")]
    inside = {path: package for package in packages for path in package.rglob("*.py")}
    past_a_face = [
        f"{path.relative_to(CHECKOUT)}:{node.lineno}: {node.module}"
        for path in (CHECKOUT / "urdfctl").rglob("*.py")
        for node in ast.walk(ast.parse(path.read_text(encoding="utf-8")))
        if isinstance(node, ast.ImportFrom) and node.module
        for package in packages
        if node.module.startswith(f"urdfctl.smoke.{package.name}.") and inside.get(path) != package
    ]
    assert len(packages) > 1
    assert past_a_face == []


def test_what_the_face_of_a_package_of_the_model_names_is_imported_from_it() -> None:
    """The modules that build a model are imported by their own names: a lint without such files does not load them."""
    model = CHECKOUT / "urdfctl" / "model"
    faces = {package: _names_of(model / package / "__init__.py") for package in PACKAGES_OF_THE_MODEL}
    texts = {path: path.read_text(encoding="utf-8") for path in (CHECKOUT / "urdfctl").rglob("*.py")}
    past_a_face = [
        f"{path.relative_to(CHECKOUT)}:{node.lineno}: {node.module}"
        for path, text in texts.items()
        if re.search(r"from urdfctl\.model\.\w+\.", text)
        for node in ast.walk(ast.parse(text))
        if isinstance(node, ast.ImportFrom)
        for package, named in faces.items()
        if (node.module or "").startswith(f"urdfctl.model.{package.replace('/', '.')}.")
        if model / package not in path.parents and named & {each.name for each in node.names}
    ]
    assert past_a_face == []


def _names_of(face: Path) -> set[str]:
    """The names in `__all__`."""
    tree = ast.parse(face.read_text(encoding="utf-8"))
    lists = [node.value for node in tree.body if isinstance(node, ast.Assign) and isinstance(node.value, ast.List)]
    assert len(lists) == 1
    return {str(item.value) for item in lists[0].elts if isinstance(item, ast.Constant)}


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


LINT = "from urdfctl.commands.running import run_words\nassert run_words(['lint', 'r.xacro', '--jobs', '1']) == 1"
LINT_HERE = (
    "from urdfctl.config.settings import Settings\n"
    "from urdfctl.lint.job import job_for, lint_work, perform_alone\n"
    "from urdfctl.load.target import Target\n"
    "assert perform_alone(job_for(lint_work, Target('r.xacro'), Settings()))['outcome']['diagnostics']"
)


def test_the_command_line_loads_nothing_heavy(folder: Folder) -> None:
    assert not loaded_by(folder, "import urdfctl.commands.app") & set(HEAVY)


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
        "urdfctl.source.xacro.tracing.expansion",
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
    faces = {"__init__.py", "__main__.py", "api.py", "testing.py"}
    assert len({path.name for path in (CHECKOUT / "urdfctl").glob("*.py")} - faces) <= 5
