"""A project's urdfctl.toml, or its pyproject.toml, sets what the command line does not."""

from __future__ import annotations

import json
import re
from typing import Any

import pytest
from folder import CHECKOUT, Folder

from urdfctl.catalog.additions import Additions
from urdfctl.config.file import Config, config_for, config_of, with_environ
from urdfctl.errors import UserError

ARM = """
<robot name="arm">
  <link name="base"/>
  <link name="upper"/>
  <joint name="shoulder" type="revolute">
    <parent link="base"/><child link="upper"/><limit lower="-1" upper="1" effort="9" velocity="1"/>
  </joint>
  <transmission name="t">
    <type>transmission_interface/SimpleTransmission</type>
    <joint name="shoulder"/>
    <actuator name="m"><mechanicalReduction>1</mechanicalReduction></actuator>
  </transmission>
</robot>
"""


def test_the_nearest_file_upwards_is_read(folder: Folder) -> None:
    folder.write(
        {
            ".git/HEAD": "",
            "urdfctl.toml": "distro = 'noetic'",
            "a/pyproject.toml": "[tool.urdfctl]\ndistro = 'humble'\n",
            "a/b/pyproject.toml": "[tool.other]\nname = 'b'\n",
            "a/b/arm.urdf": ARM,
            "c/urdfctl.toml": "distro = 'jazzy'",
            "c/pyproject.toml": "[tool.urdfctl]\ndistro = 'iron'\n",
        }
    )
    assert config_for(("a/b/arm.urdf",)) == Config("a/pyproject.toml", "humble", "pyproject.toml")
    assert config_for(("a/b",)).distro == "humble"
    assert config_for(("c/nothing.urdf",)).distro == "jazzy"
    assert config_for(()).distro == "noetic"


@pytest.mark.parametrize(
    "text",
    [
        "[tool.urdfctl]\ndistro = 'humble'",
        "[ tool . 'urdfctl' ]\ndistro = 'humble'",
        "[tool]\nurdfctl.distro = 'humble'",
    ],
)
def test_a_pyproject_may_write_its_table_in_any_way(folder: Folder, text: str) -> None:
    folder.write({"pyproject.toml": text})
    config = config_of("pyproject.toml")
    assert config is not None
    assert config.distro == "humble"


def test_no_file_beyond_the_workspace_is_read(folder: Folder) -> None:
    folder.write({"urdfctl.toml": "distro = 'noetic'", "ws/.git/HEAD": "", "ws/arm.urdf": ARM})
    assert config_for(("ws/arm.urdf",), workspace="ws") == Config()
    assert config_for(("ws/arm.urdf",), workspace=".").distro == "noetic"


WHOLE = """
distro = "jazzy"
simulator = "gz"
package-paths = ["packages"]
select = ["uc2", "UC101"]
ignore = ["UC201"]
extend-select = ["UC3"]
exclude = ["old", "*.bad.xacro"]
fail-on = "warning"

[severity]
UC105 = "off"
UC2 = "info"

[per-file-ignores]
"vendor/*" = ["uc1"]

[[controllers]]
type = "my_controllers/Stiff"
extends = "joint_trajectory_controller/JointTrajectoryController"
distros = "humble.."
claims.command = [{ for_each = "joints", interface = "stiffness" }]
parameters.stiffness = { type = "double", required = true, validators = { gt = 0.0 } }
parameters."limits.<joints>.most" = { type = "double", default = 1.0 }

[[hardware]]
type = "my_driver/Driver"
command_interfaces = ["position", "stiffness"]
"""


def test_all_that_it_may_set_is_read(folder: Folder) -> None:
    folder.write({"sub/urdfctl.toml": WHOLE, "sub/packages/p/package.xml": "<package/>"})
    config = config_of("sub/urdfctl.toml")
    assert config is not None
    assert config._replace(additions=Additions()) == Config(
        "sub/urdfctl.toml",
        "jazzy",
        "urdfctl.toml",
        "gz",
        "urdfctl.toml",
        ("sub/packages",),
        ("UC2", "UC101"),
        ("UC201",),
        ("UC3",),
        ("old", "*.bad.xacro"),
        "warning",
        (("UC105", "off"), ("UC2", "info")),
        per_file_ignores=(("vendor/*", ("UC1",)),),
    )
    assert [entry["type"] for entry in config.additions.controllers] == ["my_controllers/Stiff"]
    assert [entry["type"] for entry in config.additions.hardware] == ["my_driver/Driver"]


STIFF = '[[controllers]]\ntype = "my_controllers/Stiff"\n'


@pytest.mark.parametrize(
    ("text", "told"),
    [
        ("distro = ", "invalid TOML: "),
        ("\xff", "invalid TOML: 'utf-8' codec can't decode byte 0xff"),
        ("distros = 'jazzy'", "unknown key 'distros'; did you mean 'distro'?"),
        ("distro = 'jazy'", "distro: unknown distro 'jazy'; did you mean 'jazzy'?"),
        ("distro = 3", "distro: must be a string, not 3"),
        ("simulator = 'ode'", 'simulator: must be "gz", "gazebo-classic", "mujoco" or "none", not "ode"'),
        ("select = 'UC2'", 'select: must be a list, not "UC2"'),
        ("package-paths = ['nowhere']", "package-paths: folder 'nowhere' does not exist"),
        ("[severity]\nUC2 = 'loud'", 'severity.UC2: must be "error", "warning", "info" or "off", not "loud"'),
        ("[severity]\nX2 = 'off'", "severity.X2: 'X2' is invalid; expected a rule code or prefix, such as UC1"),
        ("[[controllers]]\npackage = 'p'", "controllers[0]: required key 'type' is missing"),
        (STIFF + "paramters = {}", "controllers[0]: unknown key 'paramters'; did you mean 'parameters'?"),
        (
            STIFF + "parameters.stiffness = { type = 'float' }",
            (
                "controllers[0].parameters.stiffness.type: 'float' is invalid; "
                "expected a parameter type: bool, int, double"
            ),
        ),
        (
            STIFF + "extends = 'imu_sensor_broadcaster/IMUSensorBroadcastr'",
            "controllers[0].extends: unknown type 'imu_sensor_broadcaster/IMUSensorBroadcastr'; did you mean",
        ),
        (
            STIFF + "distros = 'noetic'\nextends = 'imu_sensor_broadcaster/IMUSensorBroadcaster'",
            "controllers[0].extends: 'imu_sensor_broadcaster/IMUSensorBroadcaster' exists only in other distros: ROS 2",
        ),
        (STIFF + "extends = 'my_controllers/Stiff'", "controllers[0].extends: unknown type 'my_controllers/Stiff'"),
        (
            STIFF + "parameters.joints = { type = 'string_array' }\n"
            "claims.command = [{ for_each = 'joint', interface = 'stiffness' }]",
            "controllers[0]: entry uses parameter 'joint', but does not declare it; did you mean 'joints'?",
        ),
        ("[[hardware]]\ntype = 'a/B'\ncommand_interfaces = 'all'", "hardware[0].command_interfaces: must be a list"),
    ],
)
def test_what_means_nothing_is_told_with_file_and_key(folder: Folder, text: str, told: str) -> None:
    folder.write({"urdfctl.toml": text.encode("latin-1")})
    with pytest.raises(UserError) as refused:
        config_of("urdfctl.toml")
    assert str(refused.value).startswith(f"urdfctl.toml: {told}")


def test_a_file_that_is_too_large_is_not_read(folder: Folder) -> None:
    folder.write({"urdfctl.toml": b"#" * (1 << 21)})
    with pytest.raises(UserError, match="larger than 1 MiB"):
        config_of("urdfctl.toml")


def test_a_key_of_pyproject_is_told_with_its_table(folder: Folder) -> None:
    folder.write({"pyproject.toml": "[tool.urdfctl]\ndistro = 1\n"})
    with pytest.raises(UserError, match=r"^pyproject.toml: tool\.urdfctl\.distro: must be a string, not 1$"):
        config_of("pyproject.toml")


def test_variables_go_over_the_file(folder: Folder) -> None:
    of_file = Config("urdfctl.toml", "noetic", "urdfctl.toml", "gz", "urdfctl.toml", ignore=("UC1",), fail_on="info")
    environ = {
        "URDFCTL_DISTRO": "jazzy",
        "URDFCTL_SIMULATOR": "none",
        "URDFCTL_SELECT": "uc2, UC3",
        "URDFCTL_PACKAGE_PATHS": "/a:/b",
        "URDFCTL_IGNORE": "",
    }
    assert with_environ(of_file, environ) == Config(
        "urdfctl.toml",
        "jazzy",
        "$URDFCTL_DISTRO",
        "none",
        "$URDFCTL_SIMULATOR",
        ("/a", "/b"),
        ("UC2", "UC3"),
        ("UC1",),
        fail_on="info",
    )
    assert with_environ(of_file, {}) == of_file


@pytest.mark.parametrize(
    ("path", "excluded"),
    [
        ("sub/old/arm.xacro", True),
        ("sub/older/arm.xacro", False),
        ("sub/x/y.bad.xacro", True),
        ("sub/x/y.xacro", False),
        ("old/arm.xacro", False),
    ],
)
def test_what_is_excluded_is_named_from_the_files_folder(folder: Folder, path: str, excluded: bool) -> None:
    assert Config("sub/urdfctl.toml", exclude=("old/", "*.bad.xacro")).excludes(path) == excluded
    assert not Config("sub/urdfctl.toml").excludes(path)


# -- on the command line ---------------------------------------------------------------------------------------------


def findings(folder: Folder, *words: str, **environ: str) -> dict[str, Any]:
    ran = folder.run("lint", *words, "--format", "json", environ=environ)
    assert ran.stderr == ""
    return {**json.loads(ran.stdout), "status": ran.returncode}


def told(folder: Folder, *words: str, **environ: str) -> list[str]:
    return [f"{one['severity']} {one['code']}" for one in findings(folder, *words, **environ)["findings"]]


def test_lint_obeys_it_and_options_and_variables_go_over_it(folder: Folder) -> None:
    folder.write({".git/HEAD": "", "arm.urdf": ARM, "urdfctl.toml": "distro = 'noetic'\nselect = ['UC2']\n"})
    target = findings(folder, "arm.urdf")["targets"][0]
    assert (target["distro"], target["distro_from"]) == ("noetic", "urdfctl.toml")
    assert told(folder, "arm.urdf") == ["error UC201"]
    assert told(folder, "arm.urdf", "--ignore", "UC201") == []
    assert told(folder, "arm.urdf", URDFCTL_IGNORE="UC201") == []
    given = findings(folder, "arm.urdf", "--distro", "melodic", URDFCTL_DISTRO="kinetic")["targets"][0]
    assert (given["distro"], given["distro_from"]) == ("melodic", "--distro")
    of_variable = findings(folder, "arm.urdf", URDFCTL_DISTRO="kinetic")["targets"][0]
    assert (of_variable["distro"], of_variable["distro_from"]) == ("kinetic", "$URDFCTL_DISTRO")


def test_severities_are_what_the_project_wants(folder: Folder) -> None:
    folder.write(
        {
            ".git/HEAD": "",
            "arm.urdf": ARM,
            "urdfctl.toml": "distro = 'noetic'\n[severity]\nUC1 = 'off'\nUC201 = 'info'\n",
        }
    )
    assert told(folder, "arm.urdf") == ["info UC201"]
    assert findings(folder, "arm.urdf")["status"] == 0
    assert findings(folder, "arm.urdf", "--fail-on", "info")["status"] == 1


def test_what_is_excluded_is_not_found_in_folders_but_may_be_named(folder: Folder) -> None:
    folder.write(
        {".git/HEAD": "", "a/arm.urdf": ARM, "b/arm.urdf": ARM, "urdfctl.toml": "select = ['UC2']\nexclude = ['b']\n"}
    )
    assert [one["file"] for one in findings(folder, ".")["findings"]] == ["a/arm.urdf"]
    assert [one["file"] for one in findings(folder, "b/arm.urdf")["findings"]] == ["b/arm.urdf"]


def test_in_some_files_some_rules_are_not_told(folder: Folder) -> None:
    ignores = "[per-file-ignores]\n'vendor' = ['uc2']\n'*_old.urdf' = ['UC201', 'UC1']\n"
    names = ["arm.urdf", "vendor/deep/arm.urdf", "x/arm_old.urdf"]
    folder.write({".git/HEAD": "", **dict.fromkeys(names, ARM), "urdfctl.toml": f"distro = 'noetic'\n{ignores}"})
    told = findings(folder, ".", "--select", "UC201", URDFCTL_FAIL_ON="error")
    assert ([one["file"] for one in told["findings"]], told["status"]) == (["arm.urdf"], 1)
    named = findings(folder, "vendor/deep/arm.urdf", "--select", "UC201")
    assert (named["findings"], named["status"]) == ([], 0)


def test_another_file_may_be_named(folder: Folder) -> None:
    folder.write(
        {".git/HEAD": "", "arm.urdf": ARM, "urdfctl.toml": "distro = 'noetic'", "ci.toml": "ignore = ['UC1', 'UC2']"}
    )
    assert told(folder, "arm.urdf", "--config", "ci.toml") == []
    ran = folder.run("lint", "arm.urdf", "--config", "no.toml")
    assert (ran.returncode, ran.stderr) == (2, "urdfctl: file 'no.toml' does not exist\n")


@pytest.mark.parametrize(
    ("text", "told"),
    [
        ("selct = ['UC2']", "urdfctl: urdfctl.toml: unknown key 'selct'; did you mean 'select'?\n"),
        ("select = ['UC87']", "urdfctl: urdfctl.toml: no rule's code begins with 'UC87'; see urdfctl rules\n"),
        (
            "[per-file-ignores]\n'x' = ['UC87']",
            "urdfctl: urdfctl.toml: no rule's code begins with 'UC87'; see urdfctl rules\n",
        ),
    ],
)
def test_what_means_nothing_ends_the_run_in_one_line(folder: Folder, text: str, told: str) -> None:
    folder.write({".git/HEAD": "", "arm.urdf": ARM, "urdfctl.toml": text})
    ran = folder.run("lint", "arm.urdf")
    assert (ran.returncode, ran.stdout, ran.stderr) == (2, "", told)


def test_expand_finds_packages_where_it_says(folder: Folder) -> None:
    folder.write(
        {
            ".git/HEAD": "",
            "urdfctl.toml": "package-paths = ['more']",
            "more/p/package.xml": "<package><name>p</name></package>",
            "more/p/a.xacro": "<r xmlns:xacro='http://www.ros.org/wiki/xacro'><xacro:property name='n' value='7'/></r>",
            "r/r.xacro": "<r xmlns:xacro='http://www.ros.org/wiki/xacro'>"
            "<xacro:include filename='$(find p)/a.xacro'/><a n='${n}'/></r>",
        }
    )
    ran = folder.run("expand", "r/r.xacro")
    assert (ran.returncode, 'n="7"' in ran.stdout) == (0, True)


def test_the_documents_examples_mean_something(folder: Folder) -> None:
    text = (CHECKOUT / "docs" / "configuration.md").read_text(encoding="utf-8")
    for number, example in enumerate(re.findall(r"```toml\n(.*?)```", text, re.DOTALL)):
        named = re.findall(r'"([^"]+/[^"]+\.(?:xacro|yaml|py))"', example)
        named += ["vendor/package.xml"]
        folder.write({f"{number}/x/urdfctl.toml": example, **{f"{number}/x/{path}": "" for path in named}})
        assert config_of(f"{number}/x/urdfctl.toml") is not None


SHOWN = """\
distro = "jazzy"
exclude = ["old"]
ignore = ["UC105"]
[severity]
UC1 = "info"
[per-file-ignores]
"urdf/*_old.xacro" = ["UC201"]
[[robot]]
path = "arm.urdf"
controllers = ["arm.yaml"]
launch = ["arm.launch"]
matrix = { kind = ["a", "b"] }
[[robot]]
path = "arm.urdf"
[[hardware]]
type = "my_driver/Driver"
command_interfaces = ["position"]
state_interfaces = []
"""


def test_show_settings_tells_what_is_set_and_by_what(folder: Folder) -> None:
    folder.write({".git/HEAD": "", "urdfctl.toml": SHOWN, "arm.urdf": ARM, "arm.yaml": "", "arm.launch": ""})
    variables = {"URDFCTL_IGNORE": "UC2", "URDFCTL_FAIL_ON": "warning"}
    ran = folder.run("lint", "--show-settings", "--fail-on", "info", "--select", "UC1,UC3", environ=variables)
    assert ran.stderr == ""
    assert ran.stdout.replace(str(folder.path), "HERE").splitlines() == [
        "# configuration: urdfctl.toml",
        "# workspace: HERE",
        "# at most 20 s and 2048 MiB for a robot",
        'distro = "jazzy"                          # urdfctl.toml',
        "# simulator: not set; detected from the files of each robot",
        "package-paths = []                        # default",
        'select = ["UC1", "UC3"]                   # --select',
        'ignore = ["UC2"]                          # $URDFCTL_IGNORE',
        "extend-select = []                        # default",
        'exclude = ["old"]                         # urdfctl.toml',
        'fail-on = "info"                          # --fail-on',
        "[severity]",
        '"UC1" = "info"',
        "[per-file-ignores]",
        '"urdf/*_old.xacro" = ["UC201"]',
        "[[robot]]",
        'path = "arm.urdf"',
        'controllers = ["arm.yaml"]',
        'launch = ["arm.launch"]',
        "# variant 1 of 2: kind:=a",
        "# variant 2 of 2: kind:=b",
        "[[robot]]",
        'path = "arm.urdf"',
        "# variant 1 of 1: no arguments",
        "# [[hardware]] my_driver/Driver",
    ]


def test_what_show_settings_tells_is_a_configuration_that_sets_the_same(folder: Folder) -> None:
    folder.write({".git/HEAD": "", "urdfctl.toml": SHOWN, "arm.urdf": ARM, "arm.yaml": "", "arm.launch": ""})
    folder.write({"other.toml": folder.run("lint", "arm.urdf", "x:=1", "--show-settings").stdout})
    given, shown = config_of("urdfctl.toml"), config_of("other.toml")
    assert given is not None
    assert shown is not None
    assert (shown.distro, shown.exclude, shown.ignore) == (given.distro, given.exclude, given.ignore)
    assert (shown.severities, shown.per_file_ignores) == (given.severities, given.per_file_ignores)
    assert [robot.files for robot in shown.robots] == [robot.files for robot in given.robots]


def test_show_settings_says_where_there_is_no_configuration(folder: Folder) -> None:
    folder.write({"robots/arm.urdf": ARM})
    lines = folder.run("lint", "robots", "--show-settings").stdout.splitlines()
    assert lines[0] == "# configuration: none"
    assert "# distro: not set; detected from the files of each robot" in lines
