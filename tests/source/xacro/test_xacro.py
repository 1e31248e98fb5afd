"""Whatever xacro can do comes out byte for byte as xacro writes it; where it fails, it fails for the same reason."""

from __future__ import annotations

import os
import subprocess
import sys
from collections.abc import Mapping
from pathlib import Path
from types import FunctionType, MethodType

import pytest
from expansion import NAMESPACE, elements, expanded, laid_out, ours, robot, said, theirs
from robots import findings
from xacro_features import FAILURES, FEATURES

from urdfctl.expand.xml_writer import write
from urdfctl.source.disk.files import Files
from urdfctl.source.workspaces.packages import PackageIndex, Packages
from urdfctl.source.xacro import expansion
from urdfctl.source.xacro.expansion import UNKNOWN, Expander
from urdfctl.source.xacro.private import private_module, safety, speed, without_ros
from urdfctl.source.xacro.private.replacements import REPLACEMENTS, replace
from urdfctl.source.xml.parsing import parse

ARGUMENTS = {"given": "yes"}


def files_of(feature: str | Mapping[str, str]) -> Mapping[str, str]:
    return {"r.xacro": robot(feature)} if isinstance(feature, str) else feature


@pytest.mark.parametrize("name", FEATURES)
def test_what_xacro_can_do_comes_out_as_xacro_writes_it(name: str, tmp_path: Path) -> None:
    path = laid_out(tmp_path, files_of(FEATURES[name]))
    expected = theirs(path, ARGUMENTS)
    assert not expected.startswith("error: ")
    assert ours(path, ARGUMENTS) == expected


def reason(path: str) -> str:
    """What our xacro raises, as `theirs` tells it of xacro itself."""
    files, packages = Files(), Packages(path, PackageIndex(str(Path(path).parent), environ={}))
    expander = Expander(files, packages, {}, strict=True)
    expander.install()
    module = expander.module
    module.init_stacks(path)
    try:
        module.process_doc(parse(files.read(path)), mappings={})
    except Exception as error:  # noqa: BLE001 (whatever xacro raises)
        return f"error: {error}".replace(module.__name__, "xacro")
    return "no error"


@pytest.mark.parametrize("name", FAILURES)
def test_where_xacro_fails_it_fails_for_the_same_reason(name: str, tmp_path: Path) -> None:
    path = laid_out(tmp_path, files_of(FAILURES[name]))
    expected = theirs(path)
    assert expected.startswith("error: ")
    assert reason(path) == expected


# -- problems, kept and gone past -------------------------------------------------------------------------------------


def problems(tmp_path: Path, body: str, others: Mapping[str, str] | None = None) -> list[str]:
    path = laid_out(tmp_path, {"r.xacro": robot(body), **(others or {})})
    return [said(problem) for problem in expanded(path).problems]


def left(tmp_path: Path, body: str, others: Mapping[str, str] | None = None) -> list[str]:
    """What an expansion leaves of a robot's body: its elements' names and attributes."""
    path = laid_out(tmp_path, {"r.xacro": robot(body), **(others or {})})
    document = expanded(path).document
    return [
        " ".join([e.tagName, *(f"{name}={value}" for name, value in e.attrs.items())]) for e in elements(document)[1:]
    ]


def test_several_problems_are_told_in_one_run(tmp_path: Path) -> None:
    body = """<a b="${x}"/>
<xacro:m/>
<link name="l"><c d="$(arg n)"/></link>
<a b="${1 +}"/>
<xacro:if value="maybe"><z/></xacro:if>"""
    known = "no <xacro:property>, parameter or argument has this name here"
    assert problems(tmp_path, body) == [
        f"r.xacro:2:7 UNDEFINED_NAME 'x' is not defined: {known}",
        "r.xacro:3:1 UNKNOWN_MACRO macro 'm' is called before it is defined",
        "r.xacro:4:22 UNDEFINED_ARGUMENT argument 'n' is not defined",
        "r.xacro:5:7 EXPRESSION '1 +' is not a valid expression: invalid syntax",
        "r.xacro:6:1 CONDITION condition 'maybe' evaluates to 'maybe', which is not a boolean",
    ]


def test_a_problem_costs_only_the_attribute_the_text_or_the_element_it_is_in(tmp_path: Path) -> None:
    body = """<link name="a" x="${x}" y="1"><in/></link><link name="b">${x}</link>
<xacro:m/><joint name="j"><xacro:if value="maybe"><z/></xacro:if><last/></joint>"""
    assert left(tmp_path, body) == [
        f"link name=a x={UNKNOWN} y=1",
        "in",
        "link name=b",
        "joint name=j",
        "last",
    ]
    path = laid_out(tmp_path, {"r.xacro": robot(body)})
    assert not expanded(path).complete


def test_what_is_evaluated_is_not_evaluated_again_after_a_problem(tmp_path: Path) -> None:
    body = """<a>$${x}</a><b c="1"/><!-- of the call --><xacro:m/><a>$${y}</a>text $${z}
<a d="${none}"/><xacro:k/><last/>"""
    assert len(problems(tmp_path, body)) == 3
    path = laid_out(tmp_path, {"r.xacro": robot(body)})
    document = expanded(path).document
    assert document is not None
    written = write(document).split("\n")[2:-2]
    assert [line.strip() for line in written if line.strip()] == [
        "<a>${x}</a>", '<b c="1"/>', "<!-- of the call -->",
        "<a>${y}</a>", "text ${z}", f'<a d="{UNKNOWN}"/>', "<last/>",
    ]  # fmt: skip


def test_a_failing_macro_costs_only_the_call_in_it(tmp_path: Path) -> None:
    body = """<xacro:macro name="m" params="n"><link name="${n}" mass="${n + 1}"/><joint name="${n}"/></xacro:macro>
<xacro:m n="1"/>
<xacro:m n="x"/>"""
    assert left(tmp_path, body) == ["link name=1 mass=2", "joint name=1", f"link name=x mass={UNKNOWN}", "joint name=x"]


def test_in_strict_mode_the_first_problem_ends_the_expansion(tmp_path: Path) -> None:
    path = laid_out(tmp_path, {"r.xacro": robot('<a b="${x}"/><xacro:m/>')})
    expansion = expanded(path, strict=True)
    assert expansion.document is None
    assert [problem.kind.name for problem in expansion.problems] == ["UNDEFINED_NAME"]


def test_what_a_missing_include_would_have_brought_is_not_missed_again(tmp_path: Path) -> None:
    body = """<xacro:include filename="$(find nowhere)/m.xacro"/>
<xacro:include filename="none.xacro"/>
<xacro:m n="${length}"/>
<a b="${length}"/>
<a b="${1 / 0}"/>"""
    assert problems(tmp_path, body) == [
        "r.xacro:2:1 PACKAGE_NOT_FOUND package 'nowhere' was not found in this workspace",
        f"r.xacro:3:1 FILE_NOT_FOUND file does not exist: '{tmp_path}/none.xacro'",
        "r.xacro:6:7 EXPRESSION '1 / 0' cannot be evaluated: ZeroDivisionError: division by zero",
    ]
    assert left(tmp_path, body) == [f"a b={UNKNOWN}", f"a b={UNKNOWN}"]


def test_a_problem_in_an_included_file_stands_in_that_file(tmp_path: Path) -> None:
    others = {
        "sub/i.xacro": f'<robot {NAMESPACE}>\n  <a/>\n  <b c="${{x}}"/>\n</robot>',
        "bad.xacro": "<robot>\n<a></robot>",
    }
    body = '<xacro:include filename="sub/i.xacro"/><xacro:include filename="bad.xacro"/><last/>'
    found = problems(tmp_path, body, others)
    assert [text.split(" ")[0] for text in found] == ["i.xacro:3:9", "bad.xacro:2:4"]
    assert left(tmp_path, body, others) == ["a", f"b c={UNKNOWN}", "last"]


def test_the_same_problem_seen_through_several_calls_is_told_once(tmp_path: Path) -> None:
    body = '<xacro:macro name="m"><a b="${x}"/></xacro:macro><xacro:m/><xacro:m/>'
    assert len(problems(tmp_path, body)) == 1


def test_warnings_of_xacro_are_told_where_they_arise(tmp_path: Path) -> None:
    body = """<xacro:property name="x" value="1" colour="red"/>
<a b="${xacro.warning('careful', 1)}" c="${xacro.message('heard by nobody')}"/>"""
    assert problems(tmp_path, body) == [
        "r.xacro:2:1 XACRO_WARNING xacro:property: unknown attribute(s): colour",
        "r.xacro:3:1 XACRO_WARNING careful 1",
    ]


def test_a_macro_of_a_name_that_another_file_has_taken_is_told(tmp_path: Path) -> None:
    other = {"i.xacro": f'<robot {NAMESPACE}><xacro:macro name="m"><a/></xacro:macro></robot>'}
    body = '<xacro:include filename="i.xacro"/>\n<xacro:macro name="m"><b/></xacro:macro>\n<xacro:m/>'
    assert problems(tmp_path, body, other) == [
        f"r.xacro:3:20 DUPLICATE_MACRO macro 'm' is defined again; it replaces the one at {tmp_path}/i.xacro:1"
    ]
    twice = '<xacro:include filename="i.xacro"/>' * 2 + "<xacro:m/>"
    assert problems(tmp_path, twice, other) == []
    copied = '<xacro:include filename="i.xacro"/>\n<xacro:macro  name="m"><a/></xacro:macro>\n<xacro:m/>'
    assert problems(tmp_path, copied, other) == []


MED = f'<robot {NAMESPACE}><xacro:macro name="iiwa_gazebo"><a/></xacro:macro></robot>'


def test_a_macro_that_bears_the_name_of_a_file_beside_its_own_is_told(tmp_path: Path) -> None:
    body = '<xacro:include filename="med.gazebo.xacro"/>'
    [told] = problems(tmp_path, body, {"med.gazebo.xacro": MED, "iiwa.gazebo.xacro": MED})
    assert told == (
        "med.gazebo.xacro:1:71 MACRO_OF_OTHER_FILE macro 'iiwa_gazebo' has the same name as a macro in "
        "'iiwa.gazebo.xacro'; the later definition is called"
    )


@pytest.mark.parametrize("name", ["arm.gazebo.xacro", "iiwa.robot.xacro", "gazebo.xacro"])
def test_a_macro_that_no_file_beside_its_own_defines_under_its_name_is_none_of_theirs(
    name: str, tmp_path: Path
) -> None:
    body = '<xacro:include filename="med.gazebo.xacro"/>'
    assert problems(tmp_path, body, {"med.gazebo.xacro": MED, name: MED}) == []
    other = MED.replace("iiwa_gazebo", "iiwa_gazebo_plugin")
    assert problems(tmp_path, body, {"med.gazebo.xacro": MED, "iiwa.gazebo.xacro": other}) == []


def test_a_file_beside_a_macro_that_may_not_be_read_tells_nothing_of_it(tmp_path: Path) -> None:
    (tmp_path / "elsewhere.xacro").write_text(MED)
    (tmp_path / "here").mkdir()
    (tmp_path / "here" / "iiwa.gazebo.xacro").symlink_to(tmp_path / "elsewhere.xacro")
    (tmp_path / "here" / "med.gazebo.xacro").write_text(MED)
    path = str(tmp_path / "here" / "med.gazebo.xacro")
    files = Files([str(tmp_path / "here")])
    expander = Expander(files, Packages(path, PackageIndex(str(tmp_path / "here"), environ={})), {})
    assert expander.expand(path, {}).problems == []


def test_an_attribute_that_xacro_cannot_write_is_told(tmp_path: Path) -> None:
    body = '<a><xacro:attribute name="b" value="${1 + 1}"/></a>\n<a><xacro:attribute name="b" value="${0}"/></a>'
    assert problems(tmp_path, body) == [
        "r.xacro:2:4 XACRO attribute 'b' becomes 2, which is not a string; xacro cannot write it",
        "r.xacro:3:37 XACRO_WARNING attribute 'b' becomes 0, which is not a string; xacro writes an empty attribute",
    ]


def test_files_that_include_each_other_without_end_are_cut_off(tmp_path: Path) -> None:
    others = {"i.xacro": f'<robot {NAMESPACE}><xacro:include filename="i.xacro"/></robot>'}
    (found,) = problems(tmp_path, '<xacro:include filename="i.xacro"/>', others)
    assert "BUDGET the description cannot be expanded: macros and includes are nested more than" in found


def test_macros_that_call_each_other_without_end_are_cut_off(tmp_path: Path) -> None:
    (found,) = problems(tmp_path, '<xacro:macro name="m"><xacro:m/></xacro:macro><xacro:m/>')
    assert " BUDGET the description cannot be expanded: " in found


def test_macros_that_double_their_calls_are_cut_off(tmp_path: Path) -> None:
    body = '<xacro:macro name="m0"><a/></xacro:macro>' + "".join(
        f'<xacro:macro name="m{n + 1}"><xacro:m{n}/><xacro:m{n}/></xacro:macro>' for n in range(22)
    )
    (found,) = problems(tmp_path, body + "<xacro:m22/>")
    assert found.endswith("more than 20000 macro calls, includes and inserted blocks")


def test_blocks_that_double_are_cut_off(tmp_path: Path) -> None:
    body = '<xacro:property name="p0"><a/></xacro:property>'
    for n in range(30):
        twice = f'<xacro:insert_block name="p{n}"/>' * 2
        body += f'<xacro:property name="p{n + 1}">{twice}</xacro:property>'
    (found,) = problems(tmp_path, body + '<xacro:insert_block name="p30"/>')
    assert " BUDGET the description cannot be expanded: more than 20000 " in found


def test_includes_that_double_are_cut_off(tmp_path: Path) -> None:
    others = {"i30.xacro": "<robot/>"}
    for n in range(30):
        twice = f'<xacro:include filename="i{n + 1}.xacro"/>' * 2
        others[f"i{n}.xacro"] = f"<robot {NAMESPACE}>{twice}</robot>"
    (found,) = problems(tmp_path, '<xacro:include filename="i0.xacro"/>', others)
    assert " BUDGET the description cannot be expanded: more than 20000 " in found


def test_a_robot_may_be_nested_as_deep_as_it_can_be_written(tmp_path: Path) -> None:
    def nested(calls: int) -> str:
        inner = '<xacro:if value="${n > 0}"><xacro:m n="${n - 1}"/></xacro:if>'
        macro = f'<xacro:macro name="m" params="n">{"<l>" * 20}{inner}{"</l>" * 20}</xacro:macro>'
        return ours(laid_out(tmp_path, {"r.xacro": robot(f'{macro}<xacro:m n="{calls}"/>')}))

    assert nested(90).count("<l") == 20 * 91
    assert nested(200) == "error: the description cannot be expanded: macros or expressions are nested too deeply"


# -- what a run is given ----------------------------------------------------------------------------------------------


def test_arguments_go_before_defaults(tmp_path: Path) -> None:
    path = laid_out(tmp_path, {"r.xacro": robot('<xacro:arg name="a" default="1"/><l a="$(arg a)" b="$(arg b)"/>')})
    given = {"a": "2", "b": "x"}
    (_, link) = elements(expanded(path, given).document)
    assert link.attrs == {"a": "2", "b": "x"}
    assert given == {"a": "2", "b": "x"}


def test_only_the_environment_that_is_passed_on_is_seen(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("SECRET", "s")
    path = laid_out(tmp_path, {"r.xacro": robot('<l a="$(env SECRET)"/><l a="$(optenv SECRET none)"/>')})
    expansion = expanded(path)
    assert [(p.kind.name, p.hint) for p in expansion.problems] == [("UNDEFINED_VARIABLE", "pass it with --env SECRET")]
    assert elements(expansion.document)[2].attrs == {"a": "none"}
    assert elements(expanded(path, environ={"SECRET": "x"}).document)[1].attrs == {"a": "x"}


def test_nothing_leaks_from_one_expansion_into_another(tmp_path: Path) -> None:
    one = laid_out(tmp_path, {"one.xacro": robot("""<xacro:arg name="a" default="1"/>
<xacro:property name="p" value="1"/>
<xacro:macro name="m"><one v="${p}" a="$(arg a)"/></xacro:macro><xacro:m/><y v="${xacro.load_yaml('y.yaml')}"/>"""),
        "y.yaml": "1"})  # fmt: skip
    two = laid_out(tmp_path, {"two.xacro": robot("""<xacro:arg name="a" default="2"/>
<xacro:property name="sin" value="2"/>
<xacro:macro name="k"><two v="${sin}" a="$(arg a)" p="${p}"/></xacro:macro><xacro:k/><xacro:m/>""")})  # fmt: skip
    first = [ours(one), [said(p) for p in expanded(two).problems]]
    for _ in range(3):
        assert [ours(one), [said(p) for p in expanded(two).problems]] == first


def test_two_expanders_made_before_either_runs_do_not_mix(tmp_path: Path) -> None:
    paths = [
        laid_out(tmp_path, {f"{n}.xacro": robot(f'<xacro:property name="p" value="{n}"/><a b="${{p}}"/>')})
        for n in "12"
    ]
    expanders = [Expander(Files(), Packages(path, PackageIndex(str(tmp_path), environ={})), {}) for path in paths]
    documents = [expander.expand(path, {}).document for expander, path in zip(expanders, paths, strict=True)]
    assert [elements(document)[1].attrs["b"] for document in documents] == ["1", "2"]


def python(code: str, *arguments: str, **environ: str) -> subprocess.CompletedProcess[str]:
    env = {**os.environ, **environ}
    return subprocess.run(
        [sys.executable, "-c", code, *arguments], capture_output=True, text=True, env=env, check=False
    )


EXPAND = """
import sys
from urdfctl.source.disk.files import Files
from urdfctl.source.workspaces.packages import PackageIndex, Packages
from urdfctl.source.xacro.expansion import Expander
from urdfctl.expand.xml_writer import write

def expand(path):
    return Expander(Files(), Packages(path, PackageIndex("/none", environ={})), {}, strict=True).expand(path, {})
"""


def test_an_expansion_leaves_no_module_behind_and_never_makes_one_called_xacro(tmp_path: Path) -> None:
    body = """<a b="$(find r)" c="$(arg x)" d="${xacro.load_yaml('y.yaml')}" e="$(eval 1 + 1)"/>"""
    path = laid_out(
        tmp_path, {"r.xacro": robot(body), "package.xml": "<package><name>r</name></package>", "y.yaml": "1"}
    )
    watching = f"""{EXPAND}
import importlib.abc
class Watch(importlib.abc.MetaPathFinder):
    def find_spec(self, name, path=None, target=None):
        assert name.partition(".")[0] != "xacro", name
sys.meta_path.insert(0, Watch())
expand(sys.argv[1]); before = set(sys.modules)
found = expand(sys.argv[1])
print(sorted(set(sys.modules) - before), [m for m in sys.modules if "xacro" in m and not m.startswith("urdfctl.")])
"""
    done = python(watching, path)
    assert (done.stdout, done.stderr) == ("[] []\n", "")


def test_an_older_xacro_that_a_ros_environment_puts_first_is_not_taken(tmp_path: Path) -> None:
    path = laid_out(tmp_path, {"r.xacro": robot('<a b="${1 + 1}"/>')})
    laid_out(tmp_path, {"ros/xacro/__init__.py": "raise SystemExit('the wrong xacro')", "ros/xacro/xmlutils.py": ""})
    code = f"{EXPAND}\nprint(write(expand(sys.argv[1]).document))"
    done = python(code, path, PYTHONPATH=str(tmp_path / "ros"))
    assert '<a b="2"/>' in done.stdout


def test_an_xacro_that_lacks_what_is_needed_is_named(tmp_path: Path) -> None:
    path = laid_out(tmp_path, {"r.xacro": robot("<a/>")})
    laid_out(tmp_path, {"old/xacro/__init__.py": "def eval_all(): pass", "old/xacro/xmlutils.py": ""})
    installed = f"sys.path.insert(0, {str(tmp_path / 'old')!r})"  # as if it were this installation's own
    code = f"""{EXPAND}
from urdfctl.errors import UserError
{installed}
try:
    expand(sys.argv[1])
except UserError as error:
    print(error)
"""
    done = python(code, path)
    assert done.stdout == (
        f"the package xacro at {tmp_path}/old/xacro is of an unknown version (no 'LEXER'); known are 2.1.0 and 2.1.1\n"
    )


def test_only_the_names_in_the_table_are_replaced_and_all_of_them(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    replaced: set[str] = set()
    for user in (expansion, safety, speed, without_ros):

        def note(owner: object, name: str, value: object, *, within: str = "") -> None:
            replaced.add(f"{within}.{name}" if within else name)
            replace(owner, name, value, within=within)

        monkeypatch.setattr(user, "replace", note)
    package = "<package><name>r</name></package>"
    path = laid_out(tmp_path, {"r.xacro": robot('<a b="$(find r)" d="$(eval 1 + 1)"/>'), "package.xml": package})
    expander = Expander(Files(), Packages(path, PackageIndex(str(tmp_path), environ={})), {})
    assert not expander.expand(path, {}).problems
    table = {entry.name for entry in REPLACEMENTS} - {"substitution_args._eval_dict"}  # changed in place
    assert replaced == table
    plain = private_module.load()
    own = {name: value for name, value in vars(expander.module).items() if isinstance(value, FunctionType | MethodType)}
    changed = {name for name, value in own.items() if value.__code__ != getattr(vars(plain)[name], "__code__", None)}
    assert changed <= table


def test_a_name_that_is_not_in_the_table_cannot_be_replaced() -> None:
    with pytest.raises(KeyError):
        replace(private_module, "eval_everything", None)


@pytest.mark.parametrize(
    "text",
    ["<robot name='r'><link name='base'/></robot>", robot("<link name='${1 + 1}'/>"), robot("<link name='${x}'/>")],
)
def test_nothing_of_xacro_stays_loaded_after_a_description_was_linted(text: str, tmp_path: Path) -> None:
    path = laid_out(tmp_path, {"r.urdf": text})
    before = set(sys.modules)
    findings(path)
    assert not [name for name in set(sys.modules) - before if "xacro" in name and not name.startswith("urdfctl.")]
