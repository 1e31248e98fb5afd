"""YAML is read with the place of every key and value, within limits, and typed as ROS's readers type it."""

from __future__ import annotations

import math

import pytest
import yaml as pyyaml
from corpus import CORPUS, needs_corpus
from folder import Folder
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from sampling import sample
from work import work

from urdfctl.source.problem import ProblemKind
from urdfctl.source.span import SourceText
from urdfctl.source.yaml import tree as reader
from urdfctl.source.yaml.kinds import ValueKind
from urdfctl.source.yaml.tree import Mapping, Node, Scalar, Sequence, YamlFile, read_yaml
from urdfctl.source.yaml.types import typed_by_pyyaml, typed_by_rcl


@pytest.fixture(params=["C", "Python"], autouse=True)
def parser(request: pytest.FixtureRequest, monkeypatch: pytest.MonkeyPatch) -> None:
    """Both of PyYAML's parsers."""
    loader = pyyaml.SafeLoader if request.param == "Python" else pyyaml.CSafeLoader
    monkeypatch.setattr(reader, "SAFE_LOADER", loader)


def read(text: str | bytes) -> YamlFile:
    return read_yaml(SourceText("/c.yaml", text if isinstance(text, bytes) else text.encode()))


def texts(node: Node) -> list[tuple[str, str]]:
    """Each scalar, and what its span cuts out of the file."""
    if isinstance(node, Scalar):
        return [(node.text, node.at.span.text)]
    if isinstance(node, Sequence):
        return [pair for item in node.items for pair in texts(item)]
    return [pair for entry in node.entries for part in (entry.key, entry.value) for pair in texts(part)]


def problem(text: str | bytes) -> tuple[ProblemKind, int, int, str]:
    file = read(text)
    assert not file.readable
    assert file.documents == ()
    (found,) = file.problems
    position = found.at.source.position(found.at.start)
    return found.kind, position.line, position.column, found.message


@pytest.mark.parametrize(
    "text",
    [
        "arm:\n  joints: [a, 'b', \"c\"]\n  list:\n  - d\n  -   e # no\n",
        "\ufeffarm:\r\n  joints: [ä, 'ö']\r\n  ü: é # ß\r\n",
        "ключ: {значение: [один, 'два']}\nafter: x\n",
    ],
)
def test_every_key_and_value_knows_its_bytes(text: str) -> None:
    (document,) = read(text).documents
    pairs = texts(document)
    assert len(pairs) >= 6
    assert [text for text, _ in pairs] == [cut.strip("'\"") for _, cut in pairs]


def test_lists_and_maps_reach_from_their_first_to_their_last_byte() -> None:
    (document,) = read("a:\n  b: [1, 2]\n  c:\n  - {x: 1}\n\nd: 2\n").documents
    assert isinstance(document, Mapping)
    inner = document.entries[0].value
    assert inner.at.span.text == "b: [1, 2]\n  c:\n  - {x: 1}"


def test_keys_given_twice_are_kept_and_told_where_the_second_stands() -> None:
    file = read("a: 1\nb: 2\na: 3\n")
    (document,) = file.documents
    assert isinstance(document, Mapping)
    assert [entry.key.text for entry in document.entries] == ["a", "b", "a"]
    last = document.get("a")
    assert isinstance(last, Scalar)
    assert last.text == "3"
    (found,) = file.problems
    assert (found.kind, found.at.start, found.subject) == (ProblemKind.YAML_DUPLICATE_KEY, 10, "a")
    assert "first in line 1" in found.message


def test_of_two_maps_of_one_name_python_takes_the_last(folder: Folder) -> None:
    (found,) = read("a: {x: 1}\na: {y: 2}\n").problems
    assert (found.kind, found.at.start) == (ProblemKind.YAML_DUPLICATE_MAP, 10)
    folder.write(
        {"c.yaml": "a: {ros__parameters: {x: 1}}\na: {ros__parameters: {y: 2}}\n", "d.yaml": "a: {x: 1}\na: {}\n"}
    )
    for words, severity in ((["c.yaml"], "info"), (["d.yaml", "--distro", "noetic"], "warning")):
        assert f"{severity} UC025" in folder.run("lint", *words, "--format", "concise", "--select", "UC0").stdout


def test_an_alias_is_what_it_stands_for_and_its_place_is_kept() -> None:
    file = read("a: &x [1, 2]\nb: *x\n")
    (document,) = file.documents
    assert isinstance(document, Mapping)
    assert document.get("b") is document.get("a")
    assert [at.span.text for at in file.aliases] == ["*x"]


def test_several_documents_are_all_kept() -> None:
    assert len(read("a: 1\n---\nb: 2\n...\n---\nc: 3\n").documents) == 3


@pytest.mark.parametrize("text", ["", "# nothing\n", "\ufeff", "---\n...\n"])
def test_an_empty_file_is_no_problem(text: str) -> None:
    file = read(text)
    assert file.readable
    assert file.problems == ()


@pytest.mark.parametrize(
    ("text", "kind", "line", "column"),
    [
        ("a:\n\tb: 1\n", ProblemKind.YAML_TAB, 2, 1),
        ("a:\n  b: 1\n\tc: 1\n", ProblemKind.YAML_TAB, 3, 1),
        ("a: 1\nb: [1, 2\nc: 3\n", ProblemKind.YAML_SYNTAX, 2, 4),
        ("a: 'x\n", ProblemKind.YAML_SYNTAX, 1, 4),
        ("foo: a: b\n", ProblemKind.YAML_SYNTAX, 1, 7),
        ("é: @x\n", ProblemKind.YAML_SYNTAX, 1, 4),
        ("a: *x\n", ProblemKind.YAML_SYNTAX, 1, 4),
        ("a: &a [*a]\n", ProblemKind.YAML_SYNTAX, 1, 8),
        ("? [a]\n: b\n", ProblemKind.YAML_SYNTAX, 1, 3),
        ("a: {{ x }}\n", ProblemKind.YAML_SYNTAX, 1, 5),
        ("é: \x00\n", ProblemKind.YAML_SYNTAX, 1, 4),
        (b"a: \xe4\n", ProblemKind.YAML_SYNTAX, 1, 4),
        ("a: 1\n".encode("utf-16"), ProblemKind.YAML_SYNTAX, 1, 1),
        ("%YAML:1.0\n---\na: 1\n", ProblemKind.YAML_SYNTAX, 1, 6),
        ("a: " + "[" * 100_000, ProblemKind.BUDGET, 1, 67),
    ],
)
def test_what_is_no_yaml_is_one_problem_at_its_place(
    text: str | bytes, kind: ProblemKind, line: int, column: int
) -> None:
    assert problem(text)[:3] == (kind, line, column)


def test_a_tab_that_libyaml_allows_is_no_problem(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(reader, "SAFE_LOADER", pyyaml.CSafeLoader)
    assert read("a:\t1\t# one\nb: [1,\n\t2]\n").readable


MOST_CALLS = 1_000_000


def test_aliases_of_aliases_cost_little_work() -> None:
    levels = "".join(f"l{n}: &l{n} [{', '.join([f'*l{n - 1}'] * 10)}]\n" for n in range(1, 30))
    problems: list[tuple[ProblemKind, int, int, str]] = []
    calls = work(lambda: problems.append(problem(f"l0: &l0 [x]\n{levels}")))
    [(kind, *_, message)] = problems
    assert kind is ProblemKind.BUDGET
    assert "200000" in message
    assert calls < MOST_CALLS


def test_aliases_cannot_nest_deeper_than_brackets() -> None:
    levels = "".join(f"l{n}: &l{n} [[[[[*l{n - 1}]]]]]\n" for n in range(1, 50))
    assert problem(f"l0: &l0 [x]\n{levels}")[0] is ProblemKind.BUDGET


SCALARS = [  # what PyYAML 6 and rcl_yaml_param_parser make of a plain text
    ("1", ValueKind.INT, 1, ValueKind.INT, 1),
    ("-5", ValueKind.INT, -5, ValueKind.INT, -5),
    ("0x64", ValueKind.INT, 100, ValueKind.INT, 100),
    ("0144", ValueKind.INT, 100, ValueKind.INT, 100),
    ("1_000", ValueKind.INT, 1000, ValueKind.STRING, "1_000"),
    ("12:30", ValueKind.INT, 750, ValueKind.STRING, "12:30"),
    ("99999999999", ValueKind.INT, 99999999999, ValueKind.INT, 99999999999),
    ("99999999999999999999", ValueKind.INT, 99999999999999999999, ValueKind.FLOAT, 1e20),
    ("1e3", ValueKind.STRING, "1e3", ValueKind.FLOAT, 1000.0),
    ("1.0e3", ValueKind.STRING, "1.0e3", ValueKind.FLOAT, 1000.0),
    ("1.0e+3", ValueKind.FLOAT, 1000.0, ValueKind.FLOAT, 1000.0),
    (".5", ValueKind.FLOAT, 0.5, ValueKind.FLOAT, 0.5),
    ("5.", ValueKind.FLOAT, 5.0, ValueKind.FLOAT, 5.0),
    (".inf", ValueKind.FLOAT, math.inf, ValueKind.FLOAT, math.inf),
    ("-.inf", ValueKind.FLOAT, -math.inf, ValueKind.FLOAT, -math.inf),
    ("inf", ValueKind.STRING, "inf", ValueKind.FLOAT, math.inf),
    ("1e999", ValueKind.STRING, "1e999", ValueKind.STRING, "1e999"),
    ("2_0.0", ValueKind.FLOAT, 20.0, ValueKind.STRING, "2_0.0"),
    ("40.0/2", ValueKind.STRING, "40.0/2", ValueKind.STRING, "40.0/2"),
    ("yes", ValueKind.BOOL, True, ValueKind.BOOL, True),
    ("Off", ValueKind.BOOL, False, ValueKind.BOOL, False),
    ("y", ValueKind.STRING, "y", ValueKind.BOOL, True),
    ("t", ValueKind.STRING, "t", ValueKind.STRING, "t"),
    ("null", ValueKind.NULL, None, ValueKind.STRING, "null"),
    ("~", ValueKind.NULL, None, ValueKind.STRING, "~"),
    ("2024-01-01", ValueKind.OTHER, None, ValueKind.STRING, "2024-01-01"),
    ("deg(90)", ValueKind.FLOAT, math.pi / 2, ValueKind.STRING, "deg(90)"),
    ("rad(pi/2)", ValueKind.FLOAT, math.pi / 2, ValueKind.STRING, "rad(pi/2)"),
    ("!degrees 180", ValueKind.FLOAT, math.pi, ValueKind.INT, 180),
    ("!!str 5", ValueKind.STRING, "5", ValueKind.STRING, "5"),
    ("!mine 5", ValueKind.OTHER, None, ValueKind.INT, 5),
    ("'5'", ValueKind.STRING, "5", ValueKind.STRING, "5"),
    ('"true"', ValueKind.STRING, "true", ValueKind.STRING, "true"),
    ("|-\n  5", ValueKind.STRING, "5", ValueKind.INT, 5),
    ("", ValueKind.NULL, None, ValueKind.NULL, None),
    ("$(var rate)", ValueKind.UNKNOWN, None, ValueKind.UNKNOWN, None),
    ("'${prefix}arm'", ValueKind.UNKNOWN, None, ValueKind.UNKNOWN, None),
    ("<%= rate %>", ValueKind.UNKNOWN, None, ValueKind.UNKNOWN, None),
]


@pytest.mark.parametrize(("text", "kind1", "value1", "kind2", "value2"), SCALARS, ids=[case[0] for case in SCALARS])
def test_a_scalar_is_typed_as_its_reader_types_it(
    text: str, kind1: ValueKind, value1: object, kind2: ValueKind, value2: object
) -> None:
    (document,) = read(f"a: {text}\n").documents
    assert isinstance(document, Mapping)
    scalar = document.entries[0].value
    assert isinstance(scalar, Scalar)
    by_pyyaml, by_rcl = typed_by_pyyaml(scalar), typed_by_rcl(scalar)
    assert (by_pyyaml.kind, by_rcl.kind) == (kind1, kind2)
    assert by_pyyaml.value == (pytest.approx(value1) if isinstance(value1, float) else value1)
    assert by_rcl.value == value2


def test_plain_scalars_are_what_pyyaml_itself_makes_of_them() -> None:
    for text, kind, value, *_ in SCALARS:
        if kind in (ValueKind.INT, ValueKind.FLOAT, ValueKind.BOOL, ValueKind.STRING) and not text.startswith(
            ("deg", "rad", "!deg")
        ):
            assert pyyaml.safe_load(f"a: {text}\n")["a"] == value


PIECES = [
    "a: ",
    "- ",
    "\n",
    "  ",
    "[",
    "]",
    "{",
    "}",
    "x",
    "'",
    '"',
    "&a ",
    "*a",
    "<<: ",
    "!t ",
    "|\n",
    "# ",
    "\t",
    "é",
    "\x00",
    "? ",
    "---\n",
]


@settings(suppress_health_check=[HealthCheck.function_scoped_fixture])
@given(st.lists(st.sampled_from(PIECES), max_size=40).map("".join))
def test_whatever_a_file_holds_places_lie_within_it_and_nothing_is_raised(text: str) -> None:
    data = text.encode()
    file = read(data)
    for place in (*(problem.at for problem in file.problems), *file.aliases):
        assert 0 <= place.span.start <= place.span.end <= len(data)
    for document in file.documents:
        for _ in texts(document):
            pass
    assert file.readable or len(file.problems) == 1


@needs_corpus
def test_every_plain_scalar_of_the_corpus_is_what_its_span_cuts_out() -> None:
    files = [path for path in sorted(CORPUS.glob("**/*.y*ml")) if path.is_file()]
    assert len(files) > 1000
    for path in sample(files, 40):
        for document in read(path.read_bytes()).documents:
            for text, cut in texts(document):
                if cut[:1] not in ("'", '"', "|", ">", "!", "&", "*"):
                    assert text.split() == cut.split()
