"""Hostile expressions: nothing in them runs, nothing outside is read, and each costs little work."""

from __future__ import annotations

import warnings
from pathlib import Path

import pytest
from expansion import NAMESPACE, expanded, laid_out, robot
from hostile.expressions import ESCAPES, OUTSIDE
from hostile.yaml_files import REFUSED_YAML
from work import assert_linear, work

from urdfctl.source.problem import Problem, ProblemKind

REFUSED = {
    ProblemKind.FORBIDDEN_EXPRESSION,
    ProblemKind.EXPRESSION,
    ProblemKind.UNDEFINED_NAME,
    ProblemKind.BUDGET,
    ProblemKind.OUTSIDE_WORKSPACE,
    ProblemKind.XACRO,
}
MOST_CALLS = 50_000
"""The costliest of them, a long chain of powers, takes half as many calls to be parsed and refused."""


def problems(tmp_path: Path, body: str, **files: str) -> list[Problem]:
    """Return the problems of a robot, which must cost little work and run nothing."""
    path = laid_out(tmp_path, {"r.xacro": robot(body), **files})
    found: list[Problem] = []
    calls = work(lambda: found.extend(expanded(path).problems))
    assert calls < MOST_CALLS
    assert not (tmp_path / "marker").exists()
    return [problem for problem in found if problem.kind is not ProblemKind.XACRO_WARNING]


def escaped(text: str) -> str:
    return text.replace("&", "&amp;").replace("<", "&lt;").replace('"', "&quot;")


def is_refused(found: list[Problem]) -> bool:
    return bool(found) and all(problem.kind in REFUSED for problem in found)


@pytest.mark.parametrize("name", ESCAPES)
def test_an_expression_in_braces_is_refused(name: str, tmp_path: Path) -> None:
    payload = escaped(ESCAPES[name].replace("MARKER", str(tmp_path / "marker")))
    assert is_refused(problems(tmp_path, f'<a b="${{{payload}}}"/>'))


@pytest.mark.parametrize("name", ESCAPES)
def test_an_expression_that_comes_in_by_an_argument_is_refused(name: str, tmp_path: Path) -> None:
    # an argument may hold braces and brackets, which cannot be written inside ${...} or $(...)
    payload = escaped(ESCAPES[name].replace("MARKER", str(tmp_path / "marker")))
    assert is_refused(problems(tmp_path, f'<xacro:arg name="x" default="{payload}"/><a b="${{$(arg x)}}"/>'))


@pytest.mark.parametrize("name", ESCAPES)
def test_an_expression_in_eval_is_refused(name: str, tmp_path: Path) -> None:
    payload = escaped(ESCAPES[name].replace("MARKER", str(tmp_path / "marker")))
    assert is_refused(problems(tmp_path, f'<xacro:property name="x" value="{payload}"/><a b="$(eval ${{x}})"/>'))


@pytest.mark.parametrize("name", ESCAPES)
def test_an_expression_that_a_property_brings_later_is_refused(name: str, tmp_path: Path) -> None:
    payload = escaped(ESCAPES[name].replace("MARKER", str(tmp_path / "marker")))
    body = f"""<xacro:property name="text" value="{payload}"/>
<xacro:macro name="m" params="t"><xacro:arg name="x" default="${{t}}"/>
<xacro:if value="${{$(arg x)}}"><a/></xacro:if></xacro:macro>
<xacro:m t="${{text}}"/>"""
    assert is_refused(problems(tmp_path, body))


@pytest.mark.parametrize("name", REFUSED_YAML)
def test_a_hostile_yaml_file_is_refused(name: str, tmp_path: Path) -> None:
    found = problems(
        tmp_path,
        "<a b=\"${xacro.load_yaml('p.yaml')}\"/>",
        **{"p.yaml": REFUSED_YAML[name].replace("MARKER", str(tmp_path / "marker"))},
    )
    assert is_refused(found)


@pytest.mark.parametrize("body", OUTSIDE)
def test_nothing_outside_the_workspace_is_read(body: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (tmp_path / "link").symlink_to("/etc")
    (found,) = problems(tmp_path, body)
    assert found.kind in {
        ProblemKind.OUTSIDE_WORKSPACE,
        ProblemKind.PACKAGE_NOT_FOUND,
        ProblemKind.UNDEFINED_ARGUMENT,
        ProblemKind.UNDEFINED_VARIABLE,
    }


def test_a_pattern_of_an_include_looks_nowhere_else(tmp_path: Path) -> None:
    path = laid_out(
        tmp_path / "w", {"r.xacro": robot('<xacro:include filename="../*.xacro"/><xacro:include filename="/*/*/*"/>')}
    )
    laid_out(tmp_path, {"secret.xacro": f"<robot {NAMESPACE}><secret/></robot>"})
    found = expanded(path)
    assert [problem.message.partition(" matched")[2] for problem in found.problems] == [" no files."] * 2


def test_texts_that_double_from_property_to_property_are_cut_off(tmp_path: Path) -> None:
    doubling = "".join(f'<xacro:property name="p{n + 1}" value="${{p{n}}}${{p{n}}}"/>' for n in range(60))
    assert is_refused(problems(tmp_path, f'<xacro:property name="p0" value="xxxx"/>{doubling}<a b="${{p60}}"/>'))
    adding = doubling.replace("}${", " + ")
    assert is_refused(problems(tmp_path, f'<xacro:property name="p0" value="xxxx"/>{adding}<a b="${{p60}}"/>'))


def test_an_unbalanced_quote_in_the_params_of_a_macro_takes_no_time(tmp_path: Path) -> None:
    body = f'<xacro:macro name="m" params="a:={"x" * 5000}\' b"><a/></xacro:macro><last/>'
    problems(tmp_path, body)
    quotes = "'a" * 4001
    problems(tmp_path, f'<xacro:macro name="m" params="a:={quotes}&quot; b"><a/></xacro:macro>')


def test_params_without_end_are_refused(tmp_path: Path) -> None:
    (found,) = problems(tmp_path, f'<xacro:macro name="m" params="{"a " * 20_000}"><a/></xacro:macro>')
    assert found.kind is ProblemKind.FORBIDDEN_EXPRESSION


def test_a_text_of_many_dollars_takes_work_in_proportion_to_its_length(tmp_path: Path) -> None:
    def expand(dollars: int) -> None:
        assert expanded(laid_out(tmp_path, {"r.xacro": robot(f"<a>{'$a' * dollars}</a>")})).problems == []

    assert_linear(expand, 2000)


@pytest.mark.parametrize("expression", ["'%.3f' % 1.[2]", "1['a']", "(1)(2)", "'a' is 'a'"])
def test_python_warns_of_no_expression_of_a_robot(expression: str, tmp_path: Path) -> None:
    with warnings.catch_warnings(record=True) as said:
        warnings.simplefilter("always")
        expanded(laid_out(tmp_path, {"r.xacro": robot(f'<link name="${{{expression}}}"/>')}))
    assert said == []
