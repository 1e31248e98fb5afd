"""Unknown is not wrong: arguments that are needed, packages that are not here, and what follows from either."""

from __future__ import annotations

import json

import pytest
from folder import Folder

XACRO = '<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">\n{}\n</robot>\n'
LOOSE = '<joint name="{}" type="sideways"><parent link="base"/><child link="tip"/></joint><link name="tip"/>'
"""A joint with a fault of its own: an unknown type, UC121."""
MANIFEST = '<package format="3"><name>arm_description</name>{}</package>\n'


def told(folder: Folder, *words: str, select: str = "UC0,UC121") -> list[str]:
    """Return findings, by default those about reading files and UC121, as `file:line severity CODE message`."""
    ran = folder.run("lint", *words, "--select", select, "--format", "json")
    return [
        f"{f['file']}:{f['line']} {f['severity']} {f['code']} {f['message']}"
        for f in json.loads(ran.stdout)["findings"]
    ]


def codes(folder: Folder, *words: str) -> list[str]:
    return [" ".join(line.split()[1:3]) for line in told(folder, *words)]


# -- arguments -------------------------------------------------------------------------------------------------------


def test_a_description_alone_needs_arguments_and_the_rest_of_it_is_checked(folder: Folder) -> None:
    body = """<xacro:arg name="tool" default=""/>
        <xacro:arg name="arm" default=""/>
        <xacro:include filename="$(arg tool)/tool.xacro"/>
        <xacro:call macro="$(arg arm)_arm"/>
        <xacro:tool_of_that_file/>
        <link name="$(arg prefix)${offset}"/><link name="base"/>"""
    folder.write({"r.xacro": XACRO.format(body + LOOSE.format("j"))})
    fault, needs = told(folder, "r.xacro")
    assert needs == "r.xacro:2 info UC030 needs arguments prefix, tool, arm; what depends on them is not checked"
    assert fault.startswith("r.xacro:7 error UC121 joint 'j' has unknown type 'sideways'")


ARMS = """<xacro:arg name="ip" default=""/>
    <xacro:arg name="prefix_1" default=""/><xacro:arg name="prefix_2" default="{}"/>
    <xacro:macro name="arm" params="prefix"><link name="${{prefix}}tip"/><joint name="${{prefix}}j" type="fixed">
    <parent link="base"/><child link="${{prefix}}tip"/></joint></xacro:macro>
    <link name="base"/><xacro:arm prefix="$(arg prefix_1)"/><xacro:arm prefix="$(arg prefix_2)"/>"""


def test_two_arms_whose_prefixes_are_empty_by_default_need_them(folder: Folder) -> None:
    folder.write({"r.xacro": XACRO.format(ARMS.format(""))})
    ran = folder.run("lint", "r.xacro", "--select", "UC030,UC11", "--format", "concise")
    assert ran.stdout.splitlines() == [
        "r.xacro:3:22: info UC030 needs arguments prefix_1, prefix_2; what depends on them is not checked"
    ]


def test_names_that_are_repeated_whatever_the_arguments_are_stay_an_error(folder: Folder) -> None:
    folder.write({"r.xacro": XACRO.format(ARMS.format("") + '<link name="base"/>')})
    ran = folder.run("lint", "r.xacro", "--select", "UC110", "--format", "concise")
    assert "link 'base' is already defined" in ran.stdout


def test_a_launch_file_that_gives_no_prefixes_starts_two_arms_of_one_name(folder: Folder) -> None:
    folder.write({"r.xacro": XACRO.format(ARMS.format(""))})
    command = "xacro $(dirname)/r.xacro ip:=10.0.0.1"
    folder.write({"l.launch": f'<launch><param name="robot_description" command="{command}"/></launch>'})
    ran = folder.run("lint", "l.launch", "--select", "UC110,UC111", "--format", "concise")
    assert "error UC110" in ran.stdout


def test_an_argument_is_not_needed_only_because_a_call_that_fails_passes_it(folder: Folder) -> None:
    body = """<xacro:arg name="side" default=""/>
        <xacro:include filename="wheel.xacro"/><xacro:wheel side="$(arg side)"/><link name="base"/>"""
    folder.write({"r.xacro": XACRO.format(body)})
    assert codes(folder, "r.xacro") == ["error UC002"]


def test_a_condition_on_an_argument_without_a_value_is_unknown(folder: Folder) -> None:
    body = """<xacro:arg name="sim" default=""/>
        <xacro:if value="$(arg sim)"><link name="world"/><xacro:property name="a" value="1"/></xacro:if>
        <xacro:unless value="$(arg sim)"><xacro:property name="a" value="2"/></xacro:unless>
        <link name="base_${a}"/>"""
    folder.write({"r.xacro": XACRO.format(body)})
    assert codes(folder, "r.xacro") == ["info UC030"]


def test_arguments_that_nothing_declares_are_told_at_the_root(folder: Folder) -> None:
    folder.write({"r.xacro": "\n" + XACRO.format('<link name="$(arg prefix)base"/>')})
    assert told(folder, "r.xacro") == ["r.xacro:2 info UC030 needs argument prefix; what depends on it is not checked"]


def test_an_argument_that_is_used_before_its_default_is_needed(folder: Folder) -> None:
    folder.write({"r.xacro": XACRO.format('<link name="$(arg prefix)base"/><xacro:arg name="prefix" default="a"/>')})
    assert codes(folder, "r.xacro") == ["info UC030"]


def test_a_value_through_properties_and_macro_parameters_is_unknown_too(folder: Folder) -> None:
    body = """<xacro:arg name="kind" default=""/>
        <xacro:property name="folder" value="kinds/$(arg kind)"/>
        <xacro:macro name="load" params="where">
          <xacro:property name="facts" value="${xacro.load_yaml(where + '/facts.yaml')}"/>
          <xacro:if value="${facts['long'] and where == 'kinds/a'}"><link name="${facts['name']}"/></xacro:if>
          <xacro:if value="$(eval arg('kind') == 'a')"><link name="a"/></xacro:if>
        </xacro:macro>
        <xacro:load where="${folder}"/><link name="base"/>"""
    folder.write({"r.xacro": XACRO.format(body)})
    assert codes(folder, "r.xacro") == ["info UC030"]


def test_a_default_that_only_stands_for_a_value_is_needed(folder: Folder) -> None:
    body = '<xacro:arg name="kind" default="none"/><xacro:include filename="kinds/$(arg kind)/arm.xacro"/>'
    folder.write({"r.xacro": XACRO.format(body), "kinds/a/arm.xacro": XACRO.format('<link name="base"/>')})
    assert codes(folder, "r.xacro") == ["info UC030"]
    folder.write({"r.xacro": XACRO.format(body.replace("kinds/", "sorts/"))})
    assert codes(folder, "r.xacro") == ["error UC002"]


def test_a_description_that_is_given_arguments_is_checked_with_them(folder: Folder) -> None:
    body = '<xacro:arg name="tool" default=""/><xacro:include filename="$(arg tool).xacro"/><link name="$(arg side)"/>'
    folder.write({"r.xacro": XACRO.format(body)})
    assert codes(folder, "r.xacro", "side:=left") == ["error UC002", "warning UC028"]
    folder.write({"claw.xacro": XACRO.format('<link name="claw"/>')})
    assert codes(folder, "r.xacro", "tool:=claw") == ["error UC007"]
    folder.write({"urdfctl.toml": '[[robot]]\npath = "r.xacro"\nargs = { tool = "claw" }\n'})
    assert codes(folder) == ["error UC007"]


def test_a_description_is_checked_with_the_arguments_of_its_launch_file(folder: Folder) -> None:
    launch = '<launch><param name="robot_description" command="xacro $(dirname)/r.xacro prefix:=a_"/></launch>'
    folder.write({"r.xacro": XACRO.format('<link name="$(arg prefix)$(arg side)"/>'), "arm.launch": launch})
    assert codes(folder, "r.xacro", "arm.launch") == ["error UC007"]


def test_a_variable_of_the_environment_is_needed(folder: Folder) -> None:
    folder.write({"r.xacro": XACRO.format('<link name="$(env ARM)"/><link name="$(env ARM)_$(env SIDE)"/>')})
    assert told(folder, "r.xacro") == [
        "r.xacro:1 info UC030 needs environment variables ARM, SIDE; what depends on them is not checked"
    ]


# -- packages --------------------------------------------------------------------------------------------------------

USING = (
    '<xacro:include filename="$(find other)/a.xacro"/><xacro:include filename="$(find more)/b.xacro"/><link name="b"/>'
)


def test_packages_that_package_xml_declares_are_named_once(folder: Folder) -> None:
    declared = "<depend>other</depend><exec_depend condition='x'>more</exec_depend><test_depend>shapes</test_depend>"
    mesh = '<link name="c"><visual><geometry><mesh filename="package://shapes/a.stl"/></geometry></visual></link>'
    folder.write({"package.xml": MANIFEST.format(declared), "urdf/r.xacro": XACRO.format(USING + mesh)})
    line = "3 packages are not in this workspace: more, other and shapes; what they define is not checked"
    ran = folder.run("lint", "--select", "UC0,UC15")
    assert (ran.stdout.splitlines()[-2], ran.stdout.count("package")) == (line, 1)
    assert folder.run("lint", "--select", "UC0,UC15", "--format", "concise").stderr == f"urdfctl: {line}\n"
    report = json.loads(folder.run("lint", "--format", "json").stdout)
    assert report["missing_packages"] == ["more", "other", "shapes"]


def test_a_package_that_package_xml_does_not_declare_is_a_warning_that_says_so(folder: Folder) -> None:
    commented = "<!-- <depend>other</depend> --><depend>more</depend>"
    folder.write({"package.xml": MANIFEST.format(commented), "r.xacro": XACRO.format(USING)})
    assert told(folder, "r.xacro") == [
        "r.xacro:2 warning UC003 package 'other' was not found in this workspace, and package.xml does not declare it"
    ]
    (folder.path / "package.xml").unlink()
    assert codes(folder, "r.xacro") == ["warning UC003", "warning UC003"]


@pytest.mark.parametrize(
    ("path", "expected"),
    [
        ("urdf/wheel.xacro", "error"),
        ("${folder}/wheel.xacro", "error"),
        ("urdf/inc/wheel.xacro", "warning"),
        ("inc/${wheel}.xacro", "warning"),
    ],
)
def test_a_package_is_the_own_one_with_a_wrong_letter_only_where_that_has_the_file(
    path: str, expected: str, folder: Folder
) -> None:
    include = f'<xacro:include filename="$(find arm_description)/{path}"/>'
    folder.write(
        {
            "package.xml": MANIFEST.format("").replace("arm_d", "farm_d"),
            "urdf/wheel.xacro": XACRO.format(""),
            "r.xacro": XACRO.format(f'<xacro:property name="folder" value="urdf"/>{include}'),
        }
    )
    [found] = [each for each in told(folder, "r.xacro") if "UC003" in each]
    assert (expected in found, "did you mean 'farm_description'" in found) == (True, expected == "error")


def test_a_file_that_is_missing_in_a_package_without_package_xml_is_a_warning(folder: Folder) -> None:
    included = '<xacro:include filename="$(find arm)/tool.xacro"/>'
    folder.write({"arm/urdf/r.xacro": XACRO.format(included + '<link name="base"/>'), "top/package.xml": MANIFEST})
    assert codes(folder, "arm/urdf/r.xacro") == ["warning UC023"]
    folder.write({"arm/package.xml": "<package><name>arm</name></package>"})
    assert codes(folder, "arm/urdf/r.xacro") == ["error UC002"]


def test_a_missing_file_that_git_ignores_is_made_later(folder: Folder) -> None:
    mesh = (
        '<link name="base"><visual><geometry><mesh filename="package://arm/meshes/a.stl"/></geometry></visual></link>'
    )
    launch = '<launch><param name="robot_description" command="xacro $(find arm)/made.xacro"/></launch>'
    files = {
        "package.xml": "<package><name>arm</name><depend>xacro</depend></package>",
        "shape.xacro": XACRO.format(mesh + '<link name="tip"/>'),
        "whole.xacro": XACRO.format('<xacro:include filename="calibration.xacro"/>'),
        "l.launch": launch,
    }
    folder.write(files)
    missing = {"shape.xacro": "warning UC149", "whole.xacro": "error UC002", "l.launch": "error UC616"}
    found = {file: told(folder, file, select="UC002,UC149,UC616") for file in missing}
    assert {file: " ".join(finding.split()[1:3]) for file, [finding] in found.items()} == missing
    folder.write({".gitignore": "meshes/\ncalibration.xacro\nmade.xacro\n"})
    found = {file: told(folder, file, select="UC002,UC149,UC616") for file in missing}
    message = "file does not exist: 'calibration.xacro'; .gitignore lists it: create it before the robot starts"
    assert {file: [finding.partition(" ")[2] for finding in each] for file, each in found.items()} == {
        "shape.xacro": [],
        "whole.xacro": [f"warning UC002 {message}"],
        "l.launch": [],
    }


@pytest.mark.parametrize(
    ("cmake", "expected"),
    [
        ("file(DOWNLOAD https://x.org/a ${CMAKE_CURRENT_BINARY_DIR}/arm.urdf)", "info"),
        ('set(NAME "arm.urdf")\nadd_custom_command(OUTPUT ${NAME} COMMAND make_it)', "info"),
        ("install(FILES urdf/arm.urdf DESTINATION share/arm)", "error"),
        ("file(DOWNLOAD https://x.org/a ${CMAKE_CURRENT_BINARY_DIR}/other_arm.urdf)", "error"),
        ("file(DOWNLOAD https://x.org/a other.urdf) # not arm.urdf", "error"),
        ("", "error"),
    ],
)
def test_a_missing_file_that_the_build_creates_is_no_error(folder: Folder, cmake: str, expected: str) -> None:
    for included in ("arm.urdf", "$(find arm)/urdf/arm.urdf"):
        folder.write(
            {
                "package.xml": "<package><name>arm</name></package>",
                "CMakeLists.txt": f"project(arm)\n{cmake}\n",
                "urdf/whole.xacro": XACRO.format(f'<xacro:include filename="{included}"/>'),
            }
        )
        [finding] = told(folder, "urdf/whole.xacro", select="UC002")
        assert finding.split()[1] == expected
        assert ("CMakeLists.txt names it" in finding) == (expected == "info")


@pytest.mark.parametrize(("package", "expected"), [("arm", "info"), ("hand", "error")])
def test_a_file_in_the_space_of_the_build_is_one_that_its_package_creates(
    folder: Folder, package: str, expected: str
) -> None:
    included = f"../../devel/share/{package}/arm.urdf"
    folder.write(
        {
            "package.xml": "<package><name>arm</name></package>",
            "CMakeLists.txt": "project(arm)\nadd_custom_target(arm COMMAND make_it ${CATKIN_DEVEL_PREFIX}/arm.urdf)\n",
            "urdf/whole.xacro": XACRO.format(f'<xacro:include filename="{included}"/>'),
        }
    )
    [finding] = told(folder, "urdf/whole.xacro", select="UC016")
    assert finding.split()[1] == expected
    assert ("CMakeLists.txt names it" in finding) == (expected == "info")


# -- consequences ----------------------------------------------------------------------------------------------------


def notes(folder: Folder, *words: str) -> dict[str, list[str]]:
    report = json.loads(folder.run("lint", *words, "--select", "UC0", "--format", "json").stdout)
    return {f["code"]: [note["message"] for note in f["notes"]] for f in report["findings"]}


def test_what_follows_from_a_failed_include_is_counted_at_the_include(folder: Folder) -> None:
    body = """<xacro:include filename="sizes.xacro"/>
        <xacro:wheel side="left"/><xacro:wheel side="right"/><link name="${width}"/><link name="${height}"/>"""
    folder.write({"r.xacro": XACRO.format(body)})
    assert notes(folder, "r.xacro") == {"UC002": ["3 more errors follow"]}


def test_what_a_failed_condition_may_define_is_not_missed(folder: Folder) -> None:
    body = '<xacro:if value="perhaps"><xacro:property name="a" value="1"/></xacro:if><link name="${a}"/>'
    folder.write({"r.xacro": XACRO.format(body)})
    assert notes(folder, "r.xacro") == {"UC011": ["1 more error follows"]}


def test_a_name_that_is_undefined_by_itself_hides_nothing(folder: Folder) -> None:
    folder.write({"r.xacro": XACRO.format('<link name="${a}"/><link name="${b}"/>')})
    assert codes(folder, "r.xacro") == ["error UC006", "error UC006"]


# -- the prefix ------------------------------------------------------------------------------------------------------

UNPREFIXED = """<macro name="arm" params="side"><link name="${side}_arm"/></macro>
    <property name="mass" value="1"/>
    <arm side="left"/>
    <link name="base_${mass}"/>"""


def test_a_missing_prefix_is_one_error_with_one_fix_for_the_whole_file(folder: Folder) -> None:
    folder.write({"r.xacro": XACRO.format(UNPREFIXED)})
    (line,) = told(folder, "r.xacro")
    assert line.startswith("r.xacro:2 error UC018 <macro> needs the prefix: <xacro:macro>.")
    assert line.endswith("; 2 more in this file")
    assert notes(folder, "r.xacro", "--distro", "noetic") == {"UC018": ["2 more errors follow"]}
    folder.run("lint", "r.xacro", "--unsafe-fixes")
    fixed = (folder.path / "r.xacro").read_text()
    assert fixed.count("<xacro:") + fixed.count("</xacro:") == 4
    assert codes(folder, "r.xacro") == []


@pytest.mark.parametrize(("distro", "severity"), [(None, "warning"), ("melodic", None), ("noetic", "error")])
def test_a_missing_prefix_is_no_error_where_an_earlier_distro_of_ros1_may_run(
    folder: Folder, distro: str | None, severity: str | None
) -> None:
    manifest = "<package><name>p</name><buildtool_depend>catkin</buildtool_depend></package>"
    folder.write({"r.xacro": XACRO.format(UNPREFIXED), "package.xml": manifest})
    found = [code for code in codes(folder, "r.xacro", *(("--distro", distro) if distro else ())) if "UC018" in code]
    assert found == ([f"{severity} UC018"] if severity else [])


def test_missing_prefixes_are_told_in_each_file(folder: Folder) -> None:
    part = XACRO.format('<property name="{}" value="1"/>')
    included = '<xacro:include filename="a.xacro"/><xacro:include filename="b.xacro"/><link name="${a}${b}"/>'
    folder.write({"a.xacro": part.format("a"), "b.xacro": part.format("b"), "r.xacro": XACRO.format(included)})
    found = [line for line in told(folder, "r.xacro") if "UC018" in line]
    assert [line.partition(":")[0] for line in found] == ["a.xacro", "b.xacro"]


def test_a_macro_call_without_prefix_that_only_loses_a_part_is_an_error_from_noetic_on(folder: Folder) -> None:
    body = (
        '<xacro:macro name="arm" params="side"><link name="${side}"/></xacro:macro><arm side="left"/><link name="b"/>'
    )
    folder.write({"r.xacro": XACRO.format(body)})
    assert codes(folder, "r.xacro") == ["warning UC018"]
    assert codes(folder, "r.xacro", "--distro", "jazzy") == ["error UC018"]


def test_until_melodic_tags_without_the_prefix_are_read(folder: Folder) -> None:
    folder.write({"r.xacro": XACRO.format(UNPREFIXED + '<link name="base"/>' + LOOSE.format("j"))})
    assert codes(folder, "r.xacro", "--distro", "melodic") == ["error UC121"]
    assert codes(folder, "r.xacro", "--distro", "noetic") == ["error UC018", "error UC121"]


def test_tags_of_sdformat_need_no_prefix(folder: Folder) -> None:
    body = '<link name="base"/><world><include><uri>model://sun</uri></include></world><gazebo><arg name="a"/></gazebo>'
    folder.write({"r.xacro": XACRO.format(body)})
    assert codes(folder, "r.xacro") == []


# -- macros that nobody calls ----------------------------------------------------------------------------------------


def test_a_macro_that_ends_by_a_condition_on_its_argument_may_call_itself(folder: Folder) -> None:
    steps = """<xacro:macro name="steps" params="n">
        <link name="step_${n}"/>
        <xacro:if value="${n > 0}"><xacro:steps n="${n - 1}"/></xacro:if>
      </xacro:macro>
      <xacro:macro name="ever"><xacro:ever/></xacro:macro>"""
    folder.write({"lib.xacro": XACRO.format(steps)})
    assert codes(folder, "lib.xacro") == []
    folder.write({"r.xacro": XACRO.format(steps + '<xacro:steps n="4"/><xacro:ever/>')})
    assert codes(folder, "r.xacro") == ["error UC014"]


def test_a_name_with_an_unknown_part_is_shown_as_it_is_written(folder: Folder) -> None:
    body = """<xacro:macro name="arm" params="prefix name">
        <link name="base"/><xacro:property name="full" value="${prefix}_j"/>
        <joint name="${prefix}_elbow" type="revolute"><parent link="base"/><child link="tip"/>
          <limit lower="-1" upper="1" effort="1" velocity="0"/></joint>
        <joint name="${name}" type="revolute"><parent link="tip"/><child link="top"/>
          <limit lower="-1" upper="1" effort="1" velocity="0"/></joint>
        <link name="tip"/><link name="top"/>
      </xacro:macro>"""
    folder.write({"lib.xacro": XACRO.format(body)})
    found = json.loads(folder.run("lint", "lib.xacro", "--select", "UC131", "--format", "json").stdout)["findings"]
    messages = [place["message"] for finding in found for place in (finding, *finding["also"])]
    assert [message.split("'")[1] for message in messages] == ["${prefix}_elbow", "${name}"]


# -- files that xacro wrote ------------------------------------------------------------------------------------------

BANNER = "<!-- |    This document was autogenerated by xacro from /home/me/{}    | -->\n"
PLAIN = '<robot name="r"><link name="base"/>' + LOOSE.format("j") + "</robot>\n"


def test_findings_in_a_file_that_xacro_wrote_are_told_in_its_source(folder: Folder) -> None:
    folder.write({
        "package.xml": MANIFEST.format(""),
        "xacro/arm.urdf.xacro": XACRO.format('<link name="base"/>' + LOOSE.format("j")),
        "urdf/arm.urdf": BANNER.format("arm.urdf.xacro") + PLAIN,
        "urdf/changed.urdf": BANNER.format("arm.urdf.xacro") + PLAIN,
        "urdf/lost.urdf": BANNER.format("lost.xacro") + PLAIN,
    })  # fmt: skip
    assert [line.split(":")[0] for line in told(folder) if "UC121" in line] == [
        "urdf/changed.urdf",
        "urdf/lost.urdf",
        "xacro/arm.urdf.xacro",
    ]
    assert codes(folder, "urdf/arm.urdf") == ["error UC121"]


def test_a_file_beside_a_xacro_file_that_expands_to_it_has_no_findings_of_its_own(folder: Folder) -> None:
    source = '<xacro:property name="n" value="j"/><link name="base"/>' + LOOSE.format("${n}")
    folder.write({"arm.xacro": XACRO.format(source), "arm.urdf": PLAIN})
    assert [line.split(":")[0] for line in told(folder, ".") if "UC121" in line] == ["arm.xacro"]
    folder.write({"arm.urdf": PLAIN.replace('"j"', '"k"')})
    assert [line.split(":")[0] for line in told(folder, ".") if "UC121" in line] == ["arm.urdf", "arm.xacro"]


@pytest.mark.parametrize("file", ["wheel.xacro", "urdf/$(arg kind).xacro"])
def test_a_package_without_the_file_is_not_the_one_that_is_meant(folder: Folder, file: str) -> None:
    include = f'<xacro:arg name="kind" default="a"/><xacro:include filename="$(find arm_descripton)/{file}"/>'
    folder.write({"package.xml": MANIFEST.format(""), "r.xacro": XACRO.format(include)})
    assert "did you mean" not in told(folder, "r.xacro", select="UC003")[0]
