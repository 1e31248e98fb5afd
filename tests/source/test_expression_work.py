"""Expressions that would take much time or memory are refused before they take it; those of robots are not."""

from __future__ import annotations

import os
import re
import sys
from collections.abc import Iterator
from pathlib import Path

import pytest
import xacro
from expansion import expanded, laid_out, robot
from sampling import sample

from urdfctl.source.problem import Problem, ProblemKind
from urdfctl.source.xacro.expressions import meter
from urdfctl.source.xacro.expressions.meter import MOST_OF_EXPRESSION

ONCE = "(lambda f: f(f, 40))"
P = "('x' * 1000000)"
N = "(2 ** 60000)"
L = "([0] * 250000)"

ENDLESS = {
    # loops
    "a loop in a loop": "[1 for a in range(999999) for b in range(999999)]",
    "loops in a condition": "[1 for a in range(9999) if [1 for b in range(9999)]]",
    "loops of a set": "{a * b for a in range(9999) for b in range(9999)}",
    "loops of a dict": "{a: b for a in range(9999) for b in range(9999)}",
    "loops of a generator": "len(list(a for a in range(9999) for b in range(9999)))",
    "loops of sums": "[sum(range(9999)) for a in range(9999)]",
    "loops of loops in functions": "list(map(lambda a: list(map(lambda b: b, range(9999))), range(9999)))",
    "a loop that only looks": "any(a < 0 for a in range(9999) for b in range(9999))",
    "a loop over characters": f"[1 for a in {P} for b in {P}]",
    "many sorted lists": "[sorted(range(9999)) for a in range(9999)]",
    "a function that another one calls": "list(map(list, [range(999999)] * 9999))",
    "a key that another one calls": "max([range(999999)] * 9999, key=list)",
    "a key of a method": "([range(999999)] * 9999).sort(key=list)",
    "a filter of lists": "list(filter(list, [range(999999)] * 9999))",
    "a pair of endless lists": "list(zip(*[range(999999)] * 9999))",
    "a search in each": "[a for a in range(9999) if a in list(range(9999))]",
    "a search in an iterator": "[a for a in range(9999) if -1 in map(float, range(9999))]",
    "a search in a text": f"[a for a in range(99999) if 'y' in {P}]",
    "comparisons": f"[{L} == {L} for a in range(9999)]",
    "a lambda that calls itself twice": f"{ONCE}(lambda f, n: n and f(f, n - 1) + f(f, n - 1))",
    "a lambda of a lambda": "(lambda f: f(f(f(f(f(9))))))(lambda n: n ** 9 % 7 + sum(range(999999)))",
    # texts
    "a list of texts": f"[{P} for a in range(9999)]",
    "a list of other texts": f"[{P}[1:] for a in range(9999)]",
    "a list of changed texts": f"[{P}.upper() for a in range(9999)]",
    "texts that are added": f"[{P} + str(a) for a in range(9999)]",
    "a text that doubles": f"{ONCE}(lambda f, n: 'x' if n == 0 else f(f, n - 1) * 2)",
    "a text that is added to itself": f"{ONCE}(lambda f, n: 'x' if n == 0 else (lambda t: t + t)(f(f, n - 1)))",
    "a replacement": f"{P}.replace('x', {P})",
    "a replacement of nothing": f"{P}.replace('', {P})",
    "a replacement by an unbound method": f"str.replace({P}, 'x', {P})",
    "a replacement that is mapped": f"list(map(str.replace, [{P}], ['x'], [{P}]))",
    "a joint text": f"{P}.join(map(str, range(99999)))",
    "a joint text of one": f"{P}.join({P})",
    "a joint text that is mapped": f"list(map(','.join, [[{P}] * 9999]))",
    "a translation": f"{P}.translate({{120: {P}}})",
    "a filled text": f"('%s' * 9999) % ({P},) * 1",
    "a text filled by name": f"('%(a)s' * 9999) % dict(a={P})",
    "a text that is formatted": "'" + "{0}" * 3000 + f"'.format({P})",
    "a text in an f-string": "f'" + '{"x" * 1000000}' * 500 + "'",
    "a padded text that is mapped": "list(map('x'.center, [10 ** 9]))",
    "a padded text by an unbound method": "list(map(str.center, ['x'], [10 ** 9]))",
    "the text of lists of lists": f"str({ONCE}(lambda f, n: [] if n == 0 else [f(f, n - 1)] * 2))",
    "bytes of a number": "(1).to_bytes(10 ** 9, 'big')",
    # lists and numbers
    "a list of lists": f"[{L} for a in range(9999)]",
    "a list that is taken apart": f"[{', '.join(['*' + L] * 400)}]",
    "a list of parts": f"[{', '.join([L + '[1:]'] * 400)}]",
    "a sum of lists": f"sum([{L}] * 9999, [])",
    "a sum of many lists": "+".join([L] * 400),
    "sets": f"[{', '.join(['set(range(99999)) | set()'] * 300)}]",
    "sets without a part": f"[{', '.join(['set(range(99999)) - set()'] * 300)}]",
    "a list of large numbers": f"[{N} for a in range(99999)]",
    "a list of other large numbers": f"[{N} - a for a in range(99999)]",
    "a mapped list of large numbers": f"list(map(lambda a: {N} - a, range(99999)))",
    "lists by a lambda": f"list(map(lambda a: [{', '.join('a' * 900)}], range(99999)))",
    "pairs of pairs": f"{ONCE}(lambda f, n: 0 if n == 0 else (lambda t: (t, t))(f(f, n - 1)))",
    "a hash of pairs of pairs": f"hash({ONCE}(lambda f, n: 0 if n == 0 else (lambda t: (t, t))(f(f, n - 1))))",
}  # fmt: skip
_OF_PYTHON = r"(?<![.\w])(any|filter|hash|set|sorted|sum|zip)(?=\()"
"""What xacro offers to `${...}` only below `python`, and to `$(eval ...)` not at all there."""
MOST_MEMORY = 256 << 20
"""Bytes that an expansion may take: a list of as many items as are allowed, and what is copied of it."""


def escaped(text: str) -> str:
    return text.replace("&", "&amp;").replace("<", "&lt;").replace('"', "&quot;")


def problems(tmp_path: Path, body: str) -> list[Problem]:
    found = expanded(laid_out(tmp_path, {"r.xacro": robot(body)})).problems
    return [problem for problem in found if problem.kind is not ProblemKind.XACRO_WARNING]


@pytest.fixture
def _little_memory() -> Iterator[None]:
    """Let this process take only little more memory than it has."""
    if sys.platform != "linux":
        yield
        return
    import resource

    before = resource.getrlimit(resource.RLIMIT_AS)
    has = int(Path("/proc/self/statm").read_text().split()[0]) * os.sysconf("SC_PAGE_SIZE")
    resource.setrlimit(resource.RLIMIT_AS, (has + MOST_MEMORY, before[1]))
    yield
    resource.setrlimit(resource.RLIMIT_AS, before)


@pytest.mark.usefixtures("_little_memory")
@pytest.mark.parametrize("name", [name for name, expression in ENDLESS.items() if "}" not in expression])
def test_an_endless_expression_is_refused_before_it_takes_memory(name: str, tmp_path: Path) -> None:
    expression = re.sub(_OF_PYTHON, r"python.\1", ENDLESS[name])
    (found,) = problems(tmp_path, f'<a b="${{{escaped(expression)}}}"/>')
    assert found.kind is ProblemKind.FORBIDDEN_EXPRESSION


@pytest.mark.usefixtures("_little_memory")
@pytest.mark.parametrize("name", sample(ENDLESS, 3))
def test_an_endless_expression_in_eval_is_refused_before_it_takes_memory(name: str, tmp_path: Path) -> None:
    body = f'<xacro:property name="x" value="{escaped(ENDLESS[name])}"/><a b="$(eval ${{x}})"/>'
    (found,) = problems(tmp_path, body)
    assert found.kind is ProblemKind.FORBIDDEN_EXPRESSION


@pytest.mark.usefixtures("_little_memory")
@pytest.mark.parametrize(
    "attribute",
    ["python.type('x'.encode())(10 ** 9)", "(lambda t: t('x'.encode()))(python.type)(10 ** 9)"],
)
def test_there_are_no_bytes_of_any_length(attribute: str, tmp_path: Path) -> None:
    (found,) = problems(tmp_path, f'<a b="${{{attribute}}}"/>')
    assert found.kind is ProblemKind.FORBIDDEN_EXPRESSION


SANE = {
    "[a * b for a in range(3) for b in range(3) if a != b]": "[0, 0, 0, 2, 0, 2]",
    "list(map(str, range(3)))": "['0', '1', '2']",
    "list(map(lambda a: a * 2, [1, 2]))": "[2, 4]",
    "python.sorted(['b', 'a', 'C'], key=str.lower)": "['a', 'b', 'C']",
    "max([1, 2], [3], key=len)": "[1, 2]",
    "max(1, 2.5) + min([4, 3])": "5.5",
    "python.list(python.filter(None, [0, 1]))": "[1]",
    "python.sum([[1], [2, 3]], [])": "[1, 2, 3]",
    "python.sum([1, 2.5])": "3.5",
    "python.sum(a * a for a in [1, 2, 3])": "14",
    "python.dict(python.zip('ab', [1, 2]))": "{'a': 1, 'b': 2}",
    "python.isinstance([], list) and python.isinstance('a', (int, str))": "True",
    "','.join(str(a) for a in [1, 2])": "1,2",
    "'%s-%d' % ('a', 2)": "a-2",
    "'a b'.replace(' ', '_').upper()": "A_B",
    "str.upper('a')": "A",
    "'x' in ['x', 'y'] and 1 not in (2, 3)": "True",
    "[*[1, 2], *(3,)]": "[1, 2, 3]",
    "len([c for c in 'abc'])": "3",
    "[1, 2, 3, 4][1:-1]": "[2, 3]",
    "python.list(python.reversed([1, 2]))": "[2, 1]",
    "python.list(python.enumerate('ab'))": "[(0, 'a'), (1, 'b')]",
    "python.len(python.set([1, 1]) | python.set([2]))": "2",
    "1 + 2 - 3 + 4 - 5 + 6 - 7 + 8 - 9 + 10 - 11 + 12 - pi + pi": "8.0",
    "(lambda f: f(f, 5))(lambda f, n: 1 if n == 0 else n * f(f, n - 1))": "120",
    "xacro.tokenize('a b')": "['a', 'b']",
    "radians(180) == pi and math.floor(1.5)": "1",
}


@pytest.mark.parametrize("expression", SANE)
def test_a_sane_expression_gives_what_xacro_gives(expression: str, tmp_path: Path) -> None:
    found = expanded(laid_out(tmp_path, {"r.xacro": robot(f'<a b="${{{escaped(expression)}}}"/>')}))
    assert {problem.kind for problem in found.problems} <= {ProblemKind.XACRO_WARNING}
    assert found.document is not None
    assert found.document.documentElement is not None
    (element,) = found.document.documentElement.elements()
    assert element.attrs["b"] == SANE[expression]


@pytest.mark.parametrize("expression", SANE)
def test_xacro_itself_gives_the_same(expression: str) -> None:
    symbols = xacro.create_global_symbols()
    xacro.init_stacks("r.xacro")
    assert str(xacro.safe_eval(expression, symbols)) == SANE[expression]


def test_many_costly_expressions_end_the_expansion_once(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(meter, "MOST_OF_EXPANSION", 2 * MOST_OF_EXPRESSION)
    costly = f"<a b='${{len([1 for a in range({MOST_OF_EXPRESSION // 3})])}}'/>"
    found = problems(tmp_path, costly * 8)
    assert [(problem.kind, problem.message) for problem in found] == [
        (
            ProblemKind.BUDGET,
            "the description cannot be expanded: its expressions need more work than one robot may take",
        )
    ]


def test_texts_that_double_from_argument_to_argument_are_cut_off(tmp_path: Path) -> None:
    doubling = "".join(f'<xacro:arg name="a{n + 1}" default="$(arg a{n})$(arg a{n})"/>' for n in range(60))
    found = problems(tmp_path, f'<xacro:arg name="a0" default="xxxx"/>{doubling}<a b="$(arg a60)"/>')
    assert found[0].kind is ProblemKind.FORBIDDEN_EXPRESSION
    assert found[0].message == "the value of the expression is too large"
