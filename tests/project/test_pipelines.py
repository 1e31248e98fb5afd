"""What people copy into their pipelines works: hooks of pre-commit, the action, and the snippets of docs/pipelines.md.

Those that install urdfctl as a pipeline would are skipped unless URDFCTL_ONLINE is set: they need a package index.
"""

from __future__ import annotations

import json
import os
import re
import shutil
import subprocess
import sys
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import pytest
import yaml
from action_steps import ACTION, STEPS, Job
from folder import CHECKOUT, Folder, environment
from smoking_engines import needs_an_engine

SOUND = """\
<robot name="arm">
  <link name="world"/>
  <link name="tip">
    <inertial><mass value="1"/><inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/></inertial>
  </link>
  <joint name="elbow" type="revolute">
    <parent link="world"/><child link="tip"/><limit lower="-1" upper="1" effort="1" velocity="1"/>
  </joint>
</robot>
"""
BROKEN = SOUND.replace('type="revolute"', 'type="sideways"')
SLIP = SOUND.replace('type="revolute"', 'type="Revolute"')
CONTROLLED = """\
<robot name="arm">
  <link name="world"/>
  <link name="tip">
    <inertial>
      <origin xyz="0.5 0 0"/><mass value="2"/><inertia ixx="0.1" ixy="0" ixz="0" iyy="0.1" iyz="0" izz="0.1"/>
    </inertial>
  </link>
  <joint name="elbow" type="revolute">
    <parent link="world"/><child link="tip"/><axis xyz="0 1 0"/>
    <limit lower="-1" upper="1" effort="50" velocity="2"/>
  </joint>
  <ros2_control name="arm" type="system">
    <hardware><plugin>mock_components/GenericSystem</plugin></hardware>
    <joint name="elbow">
      <command_interface name="effort"/><state_interface name="position"/><state_interface name="velocity"/>
    </joint>
  </ros2_control>
</robot>
"""
CONTROLLERS = """\
controller_manager:
  ros__parameters:
    update_rate: 500
    mover: {type: joint_trajectory_controller/JointTrajectoryController}
mover:
  ros__parameters:
    joints: [elbow]
    command_interfaces: [effort]
    state_interfaces: [position, velocity]
    gains: {elbow: {p: 300.0, i: 20.0, d: 20.0}}
"""
HOOKS = yaml.safe_load((CHECKOUT / ".pre-commit-hooks.yaml").read_text(encoding="utf-8"))
BIN = Path(sys.executable).parent
needs_bash = pytest.mark.skipif(shutil.which("bash") is None, reason="bash is not here")
online = pytest.mark.skipif(
    not os.environ.get("URDFCTL_ONLINE"), reason="installs from a package index: set URDFCTL_ONLINE"
)
needs_command = pytest.mark.skipif(
    not (BIN / "urdfctl").is_file(), reason="urdfctl is not installed beside this Python"
)


def run(*command: str, **variables: str) -> subprocess.CompletedProcess[str]:
    """A command in the current folder that finds this Python's urdfctl first."""
    path = os.pathsep.join([str(BIN), os.environ["PATH"]])
    return subprocess.run(
        command, env=environment({"PATH": path, **variables}), capture_output=True, text=True, check=False, timeout=300
    )


def snippet(words: str) -> str:
    """The one snippet of the document that holds some words."""
    text = (CHECKOUT / "docs/pipelines.md").read_text(encoding="utf-8")
    [found] = [snippet for snippet in re.findall(r"```\w+\n(.*?)```", text, re.DOTALL) if words in snippet]
    return str(found)


# -- pre-commit ------------------------------------------------------------------------------------------------------


def repository(folder: Folder, files: Mapping[str, str], hooks: list[dict[str, Any]], **where: str) -> None:
    """A repository whose commits some hooks look at."""
    config = {"repos": [{**(where or {"repo": "local"}), "hooks": hooks}]}
    folder.write({**files, ".pre-commit-config.yaml": yaml.safe_dump(config)})
    run("git", "init", "--quiet")
    run("git", "add", ".")


def installed(hook_id: str, **changes: object) -> dict[str, Any]:
    """A hook as a repository of its own has it, but run with what is installed here."""
    [hook] = [hook for hook in HOOKS if hook["id"] == hook_id]
    return {**hook, "language": "system", **changes}


def pre_commit(folder: Folder, *words: str) -> subprocess.CompletedProcess[str]:
    pytest.importorskip("pre_commit", reason="pre-commit is not installed")
    if shutil.which("git") is None:
        pytest.skip("git is not here")
    command = (sys.executable, "-m", "pre_commit", "run", *words)
    return run(*command, PRE_COMMIT_HOME=str(folder.path / ".cache"), PRE_COMMIT_COLOR="never")


@needs_command
def test_the_lint_hook_stops_a_commit_of_a_broken_robot_and_lets_a_sound_one_pass(folder: Folder) -> None:
    repository(folder, {"urdf/arm.urdf": BROKEN}, [installed("urdfctl-lint")])
    ran = pre_commit(folder)
    assert ran.returncode == 1, ran.stderr
    assert "urdf/arm.urdf:6:29: error UC121" in ran.stdout
    folder.write({"urdf/arm.urdf": SOUND})
    run("git", "add", ".")
    assert pre_commit(folder).returncode == 0


@needs_command
@pytest.mark.parametrize(
    ("name", "looked_at"),
    [
        ("urdf/a.urdf", True),
        ("a.urdf.xacro", True),
        ("config/a.yaml", True),
        ("a.launch", True),
        ("launch/a.launch.py", True),
        ("launch/all.py", True),
        ("a_launch.xml", True),
        ("package.xml", True),
        ("p/package.xml", True),
        ("urdfctl.toml", True),
        ("README.md", False),
        ("src/all.py", False),
        ("world.xml", False),
        ("arm.urdf.orig", False),
    ],
)
def test_the_hooks_look_at_what_may_be_a_part_of_a_robot(name: str, looked_at: bool) -> None:
    assert [bool(re.search(hook["files"], name)) for hook in HOOKS] == [looked_at] * len(HOOKS)


@needs_command
def test_the_fix_hook_mends_and_stops_the_commit_for_a_look(folder: Folder) -> None:
    repository(folder, {"arm.urdf": SLIP}, [installed("urdfctl-fix")])
    ran = pre_commit(folder)
    assert ran.returncode == 1
    assert "files were modified by this hook" in ran.stdout
    assert (folder.path / "arm.urdf").read_text() == SOUND


@needs_command
def test_the_smoke_hook_stops_a_commit_of_a_robot_that_is_too_weak(folder: Folder) -> None:
    args = ["--engine", "none", "--distro", "jazzy", "--controllers", "arm.yaml", "."]
    weak = {"arm.urdf": CONTROLLED.replace('effort="50"', 'effort="1"'), "arm.yaml": CONTROLLERS}
    repository(folder, weak, [installed("urdfctl-smoke", args=args)])
    ran = pre_commit(folder)
    assert (ran.returncode, "error UC915" in ran.stdout) == (1, True), ran.stdout
    folder.write({"arm.urdf": CONTROLLED})
    run("git", "add", ".")
    assert pre_commit(folder).returncode == 0


@needs_command
def test_the_generate_hook_stops_where_the_controllers_file_is_stale(folder: Folder) -> None:
    folder.write({"arm.urdf": SOUND})
    args = ["arm.urdf", "--type", "trajectory", "-o", "arm.yaml"]
    assert run("urdfctl", "gen-controllers", *args).returncode == 0
    repository(folder, {}, [installed("urdfctl-generate-check", args=args)])
    assert pre_commit(folder).returncode == 0
    (folder.path / "arm.yaml").write_text("stale: true\n")
    ran = pre_commit(folder, "--all-files")
    assert (ran.returncode, "arm.yaml is out of date" in ran.stdout) == (1, True)


def test_the_manifest_of_the_hooks_is_right() -> None:
    pytest.importorskip("pre_commit", reason="pre-commit is not installed")
    ran = run(sys.executable, "-m", "pre_commit", "validate-manifest", str(CHECKOUT / ".pre-commit-hooks.yaml"))
    assert (ran.returncode, ran.stdout) == (0, "")


def test_the_documents_hooks_are_those_of_the_manifest() -> None:
    [repo] = yaml.safe_load(snippet("urdfctl-generate-check"))["repos"]
    assert {hook["id"] for hook in repo["hooks"]} <= {hook["id"] for hook in HOOKS}


@online
def test_pre_commit_installs_the_hooks_by_itself(folder: Folder) -> None:
    source = folder.path.parent / f"{folder.path.name}-source"
    shutil.copytree(CHECKOUT, source, ignore=shutil.ignore_patterns(".*_cache", ".git", ".hypothesis", "__pycache__"))
    identity = ("-c", "user.name=n", "-c", "user.email=e@example.com")
    for words in (("init", "--quiet"), ("add", "."), (*identity, "commit", "--quiet", "-m", "all")):
        assert run("git", "-C", str(source), *words).returncode == 0
    revision = run("git", "-C", str(source), "rev-parse", "HEAD").stdout.strip()
    repository(folder, {"arm.urdf": BROKEN}, [{"id": "urdfctl-lint"}], repo=str(source), rev=revision)
    ran = pre_commit(folder)
    assert (ran.returncode, "error UC121" in ran.stdout) == (1, True), ran.stdout + ran.stderr


# -- the action ------------------------------------------------------------------------------------------------------


def step(name: str, folder: Folder, **inputs: str) -> subprocess.CompletedProcess[str]:
    """The shell lines of a step in the folder, with the inputs that a workflow gives."""
    return job(folder).step(name, inputs, environment({}))


def job(folder: Folder) -> Job:
    """A job whose checkout is the folder, in which urdfctl is installed."""
    return Job(folder.path, folder.path)


def test_no_input_is_written_into_a_shell_line() -> None:
    assert [name for name, step in STEPS.items() if "${{" in step.get("run", "")] == []
    used = re.findall(r"inputs\.([\w-]+)", json.dumps(ACTION["runs"]))
    assert set(used) == set(ACTION["inputs"])


@needs_bash
@needs_command
def test_the_action_annotates_lines_and_writes_sarif(folder: Folder) -> None:
    folder.write({"my robot/arm.urdf": BROKEN, "sound/arm.urdf": SOUND})
    ran = step("Lint", folder, paths="my robot\n\nsound\n", distro="noetic", simulator="none", options="--jobs 1")
    assert ran.returncode == 1, ran.stderr
    assert "::error file=my robot/arm.urdf,line=6," in ran.stdout
    [result] = json.loads((folder.path / "urdfctl.sarif").read_text())["runs"][0]["results"]
    assert result["ruleId"] == "UC121"
    assert job(folder).told() == {"sarif": "urdfctl.sarif"}


@needs_bash
@needs_command
def test_the_action_passes_where_nothing_is_found_and_obeys_its_inputs(folder: Folder) -> None:
    folder.write({"arm.urdf": SOUND, "urdfctl.toml": "fail-on = 'info'\n"})
    assert step("Lint", folder).returncode == 0
    folder.write({"arm.urdf": BROKEN.replace("sideways", "floating")})
    assert step("Lint", folder, sarif="other.sarif").returncode == 1
    assert (folder.path / "other.sarif").is_file()
    assert step("Lint", folder, **{"fail-on": "error"}).returncode == 0
    assert step("Lint", folder, options="--ignore UC1").returncode == 0


@needs_bash
@needs_command
@pytest.mark.parametrize("field", sorted(ACTION["inputs"].keys() - {"upload", "smoke"}))
@pytest.mark.parametrize(
    "text", ["$(touch pwned)", "`touch pwned`", "; touch pwned", '"; touch pwned; "', "a\n$(touch pwned)"]
)
def test_no_input_of_the_action_runs_as_a_command(folder: Folder, field: str, text: str) -> None:
    folder.write({"arm.urdf": SOUND})
    of_diff = {"diff": "arm.urdf"} if field.startswith("diff") else {}
    name = "Diff" if of_diff else "Smoke" if field.startswith("smoke") else "Lint"
    ran = step(name, folder, **{**of_diff, field: text})
    assert not (folder.path / "pwned").exists()
    is_file_name = field in ("sarif", "smoke-report") and "\n" not in text
    assert ran.returncode == 2 or is_file_name


@needs_bash
@needs_command
def test_the_action_adds_what_changed_to_the_summary(folder: Folder) -> None:
    assert run("git", "init", "-q").returncode == 0
    for text in (SOUND, SOUND.replace("<robot", '<robot version="1.1"')):
        folder.write({"arm.urdf": text})
        for words in (["add", "arm.urdf"], ["commit", "-q", "-m", "a change"]):
            assert run("git", "-c", "user.name=n", "-c", "user.email=n@n", *words).returncode == 0
    ran = step("Diff", folder, diff="arm.urdf", **{"diff-fail-on": "other"})
    assert ran.returncode == 1, ran.stderr
    assert "| other | `@version` |  | `1.1` |" in (folder.path / "summary.md").read_text()


@needs_bash
@needs_command
def test_the_action_smoke_tests_the_robots_and_writes_junit(folder: Folder) -> None:
    folder.write({"weak/arm.urdf": CONTROLLED.replace('effort="50"', 'effort="1"'), "weak/arm.yaml": CONTROLLERS})
    folder.write({"sound/arm.urdf": CONTROLLED, "sound/arm.yaml": CONTROLLERS})
    inputs = {"distro": "jazzy", "smoke-options": "--engine none --controllers weak/arm.yaml"}
    ran = step("Smoke", folder, paths="weak\n", **inputs)
    assert ran.returncode == 1, ran.stderr
    assert "::error file=weak/arm.urdf,line=" in ran.stdout
    assert "needs 9.81 N m" in (folder.path / "urdfctl-smoke.xml").read_text()
    assert job(folder).told() == {"report": "urdfctl-smoke.xml"}
    inputs["smoke-options"] = "--engine none --controllers sound/arm.yaml"
    assert step("Smoke", folder, paths="sound\n", **inputs).returncode == 0


@online
@needs_bash
def test_the_action_installs_itself(folder: Folder) -> None:
    ran = step("Install", folder)
    assert ran.returncode == 0, ran.stderr
    assert run(job(folder).told()["python"], "-I", "-m", "urdfctl", "--version").returncode == 0


# -- GitLab ----------------------------------------------------------------------------------------------------------


@needs_bash
@needs_command
def test_gitlabs_job_writes_the_reports_that_it_names(folder: Folder) -> None:
    folder.write({"arm.urdf": BROKEN})
    job = yaml.safe_load(snippet("codequality"))["urdfctl"]
    [line] = [line for line in job["script"] if not line.startswith("pip ")]
    statuses = [run("bash", "-c", line, CI_NODE_INDEX=index, CI_NODE_TOTAL="2").returncode for index in ("2", "1")]
    assert sorted(statuses) == [0, 1]
    reports = job["artifacts"]["reports"]
    assert [issue["check_name"][:5] for issue in json.loads(Path(reports["codequality"]).read_text())] == ["UC121"]
    assert "UC121" in Path(reports["junit"]).read_text()


@needs_bash
@needs_command
@needs_an_engine
def test_gitlabs_job_smoke_tests_the_robots_of_a_folder(folder: Folder) -> None:
    folder.write({"arm.urdf": CONTROLLED, "arm.yaml": CONTROLLERS})
    job = yaml.safe_load(snippet("urdfctl-smoke:"))["urdfctl-smoke"]
    [line] = [line for line in job["script"] if not line.startswith("pip ")]
    ran = run("bash", "-c", f"{line} --controllers arm.yaml --distro jazzy")
    assert ran.returncode == 0, ran.stdout
    assert 'name="mover"' in Path(job["artifacts"]["reports"]["junit"]).read_text()


# -- colcon and catkin -----------------------------------------------------------------------------------------------

STUBS = {
    "ament_cmake_testConfig.cmake": """
        set(AMENT_TEST_RESULTS_DIR "${CMAKE_BINARY_DIR}/test_results")
        function(ament_add_test name)
          cmake_parse_arguments(ARG "GENERATE_RESULT_FOR_RETURN_CODE_ZERO;SKIP_TEST"
            "OUTPUT_FILE;RESULT_FILE;RUNNER;TIMEOUT;WORKING_DIRECTORY" "COMMAND;ENV;APPEND_ENV" ${ARGN})
          if(ARG_UNPARSED_ARGUMENTS)
            message(FATAL_ERROR "unused arguments: ${ARG_UNPARSED_ARGUMENTS}")
          endif()
          add_test(NAME ${name} COMMAND ${ARG_COMMAND} WORKING_DIRECTORY "${ARG_WORKING_DIRECTORY}")
        endfunction()
    """,
    "catkin.cmake": """
        set(CATKIN_ENABLE_TESTING ON)
        set(CATKIN_TEST_RESULTS_DIR "${CMAKE_BINARY_DIR}/test_results")
        function(catkin_run_tests_target type name xunit)
          cmake_parse_arguments(ARG "" "WORKING_DIRECTORY" "COMMAND;DEPENDENCIES" ${ARGN})
          if(ARG_UNPARSED_ARGUMENTS)
            message(FATAL_ERROR "unused arguments: ${ARG_UNPARSED_ARGUMENTS}")
          endif()
          add_test(NAME ${type} COMMAND sh -c "${ARG_COMMAND}" WORKING_DIRECTORY "${ARG_WORKING_DIRECTORY}")
        endfunction()
    """,
}
"""What the snippets use of ament_cmake_test and catkin, with their arguments."""


@needs_command
@pytest.mark.skipif(shutil.which("cmake") is None or shutil.which("ctest") is None, reason="cmake is not here")
@pytest.mark.parametrize("words", ["ament_add_test(urdfctl\n", '"package" "urdfctl.xml"'])
def test_the_test_of_a_package_fails_with_its_robot(folder: Folder, words: str) -> None:
    head = "cmake_minimum_required(VERSION 3.10)\nproject(arm NONE)\nenable_testing()\nset(BUILD_TESTING ON)\n"
    lists = f"{head}include(stubs/catkin.cmake)\nset(ament_cmake_test_DIR stubs)\n{snippet(words)}"
    folder.write(
        {**{f"stubs/{name}": text for name, text in STUBS.items()}, "CMakeLists.txt": lists, "arm.urdf": BROKEN}
    )
    ran = run("cmake", "-B", "build", "-Dament_cmake_test_DIR=" + str(folder.path / "stubs"), ".")
    assert ran.returncode == 0, ran.stderr
    assert run("ctest", "--test-dir", "build").returncode != 0
    assert "UC121" in (folder.path / "build/test_results/arm/urdfctl.xml").read_text()
    folder.write({"arm.urdf": SOUND})
    assert run("ctest", "--test-dir", "build").returncode == 0


@needs_command
@pytest.mark.skipif(shutil.which("cmake") is None or shutil.which("ctest") is None, reason="cmake is not here")
@pytest.mark.parametrize("words", ["ament_add_test(urdfctl_smoke", '"smoke" "urdfctl_smoke.xml"'])
def test_the_smoke_test_of_a_package_fails_with_its_robot(folder: Folder, words: str) -> None:
    head = "cmake_minimum_required(VERSION 3.10)\nproject(arm NONE)\nenable_testing()\nset(BUILD_TESTING ON)\n"
    of_package = snippet(words).replace("smoke .", "smoke . --engine none --controllers arm.yaml --distro jazzy")
    files = {"arm.urdf": CONTROLLED.replace('effort="50"', 'effort="1"'), "arm.yaml": CONTROLLERS}
    lists = f"{head}include(stubs/catkin.cmake)\nset(ament_cmake_test_DIR stubs)\n{of_package}"
    folder.write({**{f"stubs/{name}": text for name, text in STUBS.items()}, "CMakeLists.txt": lists, **files})
    ran = run("cmake", "-B", "build", "-Dament_cmake_test_DIR=" + str(folder.path / "stubs"), ".")
    assert ran.returncode == 0, ran.stderr
    assert run("ctest", "--test-dir", "build").returncode != 0
    assert "needs 9.81 N m" in (folder.path / "build/test_results/arm/urdfctl_smoke.xml").read_text()
    folder.write({"arm.urdf": CONTROLLED})
    assert run("ctest", "--test-dir", "build").returncode == 0


@needs_command
def test_the_test_of_a_python_package_fails_with_its_robot(folder: Folder) -> None:
    folder.write({"test/test_urdfctl.py": snippet("def test_urdfctl"), "arm.urdf": BROKEN})
    ran = run(sys.executable, "-m", "pytest", "-q", "test")
    assert (ran.returncode, "UC121" in ran.stdout) == (1, True)
    folder.write({"arm.urdf": SOUND})
    assert run(sys.executable, "-m", "pytest", "-q", "test").returncode == 0
