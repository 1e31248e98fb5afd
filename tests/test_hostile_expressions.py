"""Hostile expressions: nothing in them runs, nothing outside is read, and each costs little work."""

from __future__ import annotations

from pathlib import Path

import pytest
from expansion import NAMESPACE, expanded, laid_out, robot
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
TOUCH = "open('MARKER','w')"
IMPORT = "['_'+'_import_'+'_']('os').system('touch MARKER')"
BASE = "().__class__.__base__.__subclasses__()"

ESCAPES = {
    # known of xacro's own sandbox
    "a lambda hides the names": f"(lambda: {BASE})()",
    "a comprehension hides the names": f"[c for c in {BASE}]",
    "a generator hides the names": f"list(c for c in {BASE})",
    "a set comprehension": f"{{c for c in {BASE}}}",
    "a lambda's globals": "(lambda f: f.__globals__)(xacro.load_yaml)",
    "the builtins of a module": f"(lambda f: f.__globals__['__builtins__']{IMPORT})(xacro.load_yaml)",
    "a format that walks attributes": "'{0.__class__}'.format(1)",
    "a format that walks items": "'{0[__class__]}'.format(xacro)",
    "a format that walks globals": "'{0.load_yaml.__globals__}'.format(xacro)",
    "a computed format": "('{0.' + '_'*2 + 'class' + '_'*2 + '}').format(1)",
    "str.format unbound": "str.format('{0.__class__}', 1)",
    "map of str.format": "list(map(str.format, ['{0.__class__}'], [1]))",
    "format_map": "'{x.__class__}'.format_map(dict(x=1))",
    "format taken without a call": "(lambda f: f(1))('{0.real}'.format)",
    "an f-string": "f'{().__class__}'",
    "a walrus": "(x := ().__class__)",
    "vars": "python.vars(python.vars(python)['x'])",
    # ways into the interpreter
    "vars by item": "python['vars'](python['type'](1))",
    "vars by computed item": "python['va' + 'rs'](int)",
    "vars by get": "python.get('vars')(int)",
    "vars by values": "[f(int) for f in python.values() if 'vars' in str(f)]",
    "the type of a type": "python.type(int)('X', (), dict())",
    "a class made by type": "python.type('X', (), dict())",
    "a class made by the item type": "python['type']('X', (object,), dict())",
    "the type of a function": "python.type(lambda: 0)",
    "the type of a function of ours": "python.type(xacro.load_yaml)",
    "the bases of a class": "int.mro()",
    "a generator's frame": "(i for i in [1]).gi_frame.f_back.f_globals",
    "a generator's code": "(i for i in [1]).gi_code.co_consts",
    "what a function of ours is made of": "xacro.load_yaml.args[0].module.os.system('touch MARKER')",
    "what another function is made of": "xacro.load_yaml.func",
    "what a method is bound to": "xacro.items.im_self",
    "a public attribute of a function": "xacro.warning.cache_info",
    "an exposed class of ours": "xacro.dotify.wrap.func_globals",
    "a hidden name": "__import__('os').system('touch MARKER')",
    "a hidden name as an item": f"xacro['__builtins__']{IMPORT}",
    "a hidden name as a parameter": "(lambda __builtins__: 1)(2)",
    "a hidden name computed": f"xacro['_'*2 + 'builtins' + '_'*2]{IMPORT}",
    "a hidden name in a lambda": "(lambda: __builtins__)()",
    "the builtins by name": TOUCH,
    "eval": f"eval(\"{TOUCH}\")",
    "exec": f"exec(\"{TOUCH}\")",
    "compile": "compile(\"1\", 'x', 'eval')",
    "getattr": "getattr(1, 'real')",
    "getattr of python": "python.getattr(1, 'real')",
    "open of python": "python.open('/etc/hostname')",
    "globals": "globals()",
    "an import": "import os",
    "an assignment": "a = 1",
    "two statements": f"1; {TOUCH}",
    "yield": "(lambda: (yield))()",
    "await": "await x",
    "a string of dunder in a call": "map('__class__', [1])",
    "an underscore of a namespace": "python._resolve_('vars')",
    "the hidden half of a dictionary": "dict.__getattribute__(dict(), '__class__')",
    "a file of the system": "xacro.load_yaml('/etc/hostname')",
    "a file of the system from below": "xacro.load_yaml('../../../../../../../../../etc/hostname')",
    # what has no end
    "a tower of exponents": "9**9**8",
    "a tower in steps": "(lambda n: n**n**n)(99)",
    "a tower of floats": "10.0**10.0**10.0",
    "a huge text": "'a'*10**9",
    "a huge text in steps": "'a'*1000*1000*1000*1000",
    "a huge text the other way round": "10**9*'a'",
    "a huge list": "[0]*10**9",
    "a huge shift": "1 << 10**10",
    "a huge shift in steps": "1 << 65000 << 65000",
    "a huge product": "(2**60000)*(2**60000)",
    "a huge range": "list(python.range(10**10))",
    "a huge range by its old name": "sum(range(10**10))",
    "a huge range in a comprehension": "[i for i in range(10**9)]",
    "a huge range backwards": "python.sum(python.range(10**9, 0, -1))",
    "a huge factorial": "math.factorial(10**7)",
    "a huge binomial": "math.comb(10**7, 10**6)",
    "huge permutations": "perm(10**7, 10**6)",
    "a huge product of many": "math.prod([2**60000]*100000)",
    "a wide number": "'%1000000000d' % 1",
    "a computed width": "'%*d' % (10**9, 1)",
    "a precise number": "'%.1000000000f' % 1",
    "a wide format": "'{:1000000000}'.format(1)",
    "a computed format width": "'{:{}}'.format(1, 10**9)",
    "a wide f-string": "f'{1:1000000000}'",
    "a computed f-string width": "f'{1:{10**9}}'",
    "a padded text": "'x'.ljust(10**9)",
    "a centred text": "'x'.center(1000000000)",
    "zeros": "'x'.zfill(10**9)",
    "padding that is mapped": "list(map('x'.ljust, [10**9]))",
    "tabs": "'\\t'.expandtabs(tabsize=10**9)",
    "digits to round to": "round(1, -10**9)",
    "a list that grows while it is walked through": "(lambda l: [l.append(1) for x in l])([1])",
    "a list that grows while it is mapped": "(lambda l: list(map(l.append, l)))([1])",
    "a pattern of separators": "xacro.tokenize('a'*40 + '!', sep='x](a+)+$[x')",
    "a lambda that calls itself": "(lambda f: f(f))(lambda f: f(f))",
    "many brackets": "(" * 3000 + "1" + ")" * 3000,
    "many signs": "-" * 9000 + "1",
    "many attributes": "xacro" + ".x" * 4000,
    "many powers": "**".join("9" * 2000),
    "a long expression": "1+" * 6000 + "1",
}  # fmt: skip


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


@pytest.mark.parametrize(
    "text",
    [
        "!!python/object/apply:os.system ['touch MARKER']",
        "!!python/object/new:os.system ['touch MARKER']",
        "!!python/name:os.system ''",
        "!!python/module:os ''",
        "a: !degrees \"__import__('os').system('touch MARKER')\"",
        "a: !degrees \"(lambda: ().__class__.__base__.__subclasses__())()\"",
        "a: !meters 9**9**8",
        "[" * 30_000,
        "- " * 30_000,
        "{a: " * 30_000,
        "a: &a [" + "x, " * 9 + "x]\n" + "".join(
            f"{n}: &{n} [" + f"*{p}, " * 9 + f"*{p}]\n" for p, n in zip("abcdefgh", "bcdefghi", strict=True)
        ),
        "a: &a " + "x" * 100_000 + "\nb: [" + "*a, " * 1000 + "]",
    ],
    ids=lambda text: text[:40],
)  # fmt: skip
def test_a_hostile_yaml_file_is_refused(text: str, tmp_path: Path) -> None:
    found = problems(
        tmp_path,
        "<a b=\"${xacro.load_yaml('p.yaml')}\"/>",
        **{"p.yaml": text.replace("MARKER", str(tmp_path / "marker"))},
    )
    assert is_refused(found)


@pytest.mark.parametrize(
    "body",
    [
        '<xacro:include filename="/etc/passwd"/>',
        '<xacro:include filename="../../../../../../../../etc/passwd"/>',
        '<xacro:include filename="link/passwd"/>',
        '<xacro:include filename="$(find ../../../../../../etc)/passwd"/>',
        '<xacro:include filename="$(find /etc)/passwd"/>',
        '<xacro:include filename="$(find ..)/x"/>',
        "<a b=\"${xacro.load_yaml('/etc/passwd')}\"/>",
        "<a b=\"${xacro.load_yaml('link/passwd')}\"/>",
        '<a b="$(env HOME)"/>',
    ],
)
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
