"""Comments that silence findings: which ones, on which lines, and whether they had anything to silence."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st
from work import assert_few_steps, assert_linear

from urdfctl.source.span import Call, Place, SourceSpan, SourceText
from urdfctl.source.suppressions import Reach, Suppressed, suppressions
from urdfctl.source.xml.parsing import parse


def source(text: str) -> SourceText:
    return SourceText("a.urdf", text.encode())


def silenced_lines(text: str, code: str = "UC201") -> list[int]:
    """The lines on which a text silences a code."""
    read = source(text)
    found = suppressions(read)
    return [line for line in range(len(read.line_starts()) + 3) if any(s.silences(code, line) for s in found)]


@pytest.mark.parametrize(
    ("text", "lines"),
    [
        ("<a/> <!-- urdfctl: ignore[UC201] known -->\n<b/>\n<c/>", [1, 2]),
        ("\n\n<!-- urdfctl: ignore[UC201] -->\n<b/>\n<c/>", [3, 4]),
        ("<!-- urdfctl: ignore[UC201]\n a reason\n of three lines -->\n<b/>\n<c/>", [3, 4]),
        ("<!--\n  urdfctl: ignore[UC201]\n-->\n<b/>", [3, 4]),
        ("<!-- urdfctl:ignore[UC201] -->\r\n<b/>\r\n", [1, 2]),
        ("joint: 1  # urdfctl: ignore[UC201] why\nb: 2\nc: 3", [1, 2]),
        ("# urdfctl: ignore[UC201]\nb: 2 # -->\nc: 3", [1, 2]),
        ("<!-- done --> x urdfctl: ignore[UC201]\n<!-- other -->", [1, 2]),
        ("urdfctl: ignore[UC201]\n\n\n<!-- other -->", [1, 2]),
        ("<!-- urdfctl: ignore[UC201", []),
        ("<!-- urdfctl: ignore UC201 -->", []),
        ("<!-- urdfctl: ignore[] -->", []),
        ("<a/>", []),
    ],
)
def test_a_comment_silences_its_own_line_and_the_next(text: str, lines: list[int]) -> None:
    assert silenced_lines(text) == lines


@pytest.mark.parametrize(
    ("codes", "code", "is_silenced"),
    [
        ("UC201", "UC201", True),
        ("UC201", "UC202", False),
        ("UC202, UC201", "UC201", True),
        (" uc201 ,UC3", "UC201", True),
        ("UC2", "UC201", True),
        ("UC2", "UC301", False),
        ("UC", "UC301", True),
        ("UC2011", "UC201", False),
        (",", "UC201", False),
    ],
)
def test_a_comment_may_name_several_codes_or_their_beginnings(codes: str, code: str, is_silenced: bool) -> None:
    assert bool(silenced_lines(f"<!-- urdfctl: ignore[{codes}] -->", code)) is is_silenced


@given(st.text(st.sampled_from("<!-> urdfctl:ignore[UC2,]\n"), max_size=60))
def test_any_text_is_searched_without_a_crash(text: str) -> None:
    for found in suppressions(source(text)):
        assert found.span.text.startswith("urdfctl:")


@pytest.mark.parametrize("text", ["urdfctl: ignore[UC2]\n", "<!-- urdfctl: ignore[UC2]\n", "-->urdfctl: ignore[UC2]\n"])
def test_many_comments_take_work_in_proportion_to_their_number(text: str) -> None:
    def search(comments: int) -> None:
        assert len(suppressions(source(text * comments))) == comments

    assert_linear(search, 500)


ROBOT = """<robot>
<!-- urdfctl: ignore[UC201] at the definition -->
<xacro:macro name="m">
  <joint/>
</xacro:macro>
<xacro:m/>
<!-- urdfctl: ignore[UC202] at the call -->
<xacro:m/>
<link/>
</robot>
"""


def place_of(read: SourceText, text: str, call: Call | None = None) -> Place:
    return Place(read, read.data.index(text.encode()), call)


def call_at(read: SourceText, line: int) -> Call:
    call = Call("macro", "m", read, read.offset(line), None)
    start = read.data.index(b"<xacro:macro")
    call.definition = SourceSpan(read, start, start + 5)
    return call


def test_a_finding_in_a_macro_is_silenced_at_its_definition_and_at_the_call(monkeypatch: pytest.MonkeyPatch) -> None:
    read = source(ROBOT)
    suppressed = Suppressed([read])
    first, second = (place_of(read, "<joint/>", call_at(read, line)) for line in (6, 8))
    assert suppressed.covers("UC201", first)
    assert suppressed.covers("UC201", second)
    assert not suppressed.covers("UC202", first)
    assert suppressed.covers("UC202", second)
    assert not suppressed.covers("UC203", second)
    assert suppressed.used == {0, 1}


def test_a_comment_that_silences_nothing_stays_unused() -> None:
    read = source(ROBOT)
    suppressed = Suppressed([read])
    assert not suppressed.covers("UC201", place_of(read, "<link/>"))
    assert [item.codes for item in suppressed.all] == [("UC201",), ("UC202",)]
    assert suppressed.used == set()


def test_a_comment_speaks_of_its_own_file_only() -> None:
    read, other = source(ROBOT), SourceText("b.urdf", ROBOT.encode())
    suppressed = Suppressed([other])
    assert not suppressed.covers("UC201", place_of(read, "<xacro:macro"))
    assert not Suppressed([]).covers("UC201", place_of(read, "<xacro:macro"))


@pytest.mark.parametrize(
    ("line", "is_in_use"),
    [("<!-- of the macro -->", False), ("<!-- of the condition -->", False), ("<!-- of the robot -->", True)],
)
def test_a_comment_in_a_macro_that_is_not_called_is_not_reached(line: str, is_in_use: bool) -> None:
    read = source("""<robot xmlns:xacro="x">
<xacro:macro name="m"><!-- of the macro --><a/></xacro:macro>
<xacro:if value="0"><!-- of the condition --><b/></xacro:if>
<!-- of the robot -->
<c/>
</robot>""")
    root = parse(source('<robot xmlns:xacro="x">\n\n\n\n<c/>\n</robot>')).documentElement
    assert root is not None
    start = read.data.index(line.encode())
    assert Reach(root).contains(SourceSpan(read, start, start + len(line))) is is_in_use


def test_the_innermost_macro_or_condition_decides_whether_a_comment_is_reached() -> None:
    text = """<robot xmlns:xacro="x">
<xacro:macro name="m"><a/><xacro:if value="0"><!-- inner --><b/></xacro:if><!-- outer --></xacro:macro><!-- after -->
<xacro:unless value="1"><xacro:if value="0"/></xacro:unless><xacro:if value="1">
</robot>"""
    read = source(text)
    root = parse(source(text.replace('<xacro:if value="1">', ""))).documentElement
    assert root is not None
    for element in list(root.walk()):
        if element.tagName == "b" and element.parentNode is not None:
            element.parentNode.removeChild(element)
    reach = Reach(root)
    found = {
        text: reach.contains(SourceSpan(read, read.data.index(text), read.data.index(text) + 1))
        for text in (b"<!-- inner", b"<!-- outer", b"<!-- after", b'<xacro:if value="0"/>', b"</robot>")
    }
    assert list(found.values()) == [False, True, True, True, True]


def test_many_comments_are_told_apart_in_few_steps() -> None:
    def judge(comments: int) -> None:
        pair = '<xacro:if value="1"><!-- urdfctl: ignore[UC201, UC2, UC301] --><a/>\n</xacro:if>'
        read = source(f'<robot xmlns:xacro="x">{pair * comments}</robot>')
        root = parse(read).documentElement
        assert root is not None
        reach, suppressed = Reach(root), Suppressed([read])
        assert all(suppressed.covers("UC201", element.at) for element in root.walk() if element.tagName == "a")
        assert not suppressed.covers("UC401", root.at)
        assert all(reach.contains(item.span) for item in suppressed.all)
        assert len(suppressed.used) == comments

    assert_few_steps(judge, 200)


def test_many_comments_on_one_line_cover_many_findings_in_few_steps() -> None:
    def judge(comments: int) -> None:
        read = source(f"<robot>{'<!-- urdfctl: ignore[UC201] -->' * comments}{'<a/>' * comments}</robot>")
        root = parse(read).documentElement
        assert root is not None
        suppressed = Suppressed([read])
        assert all(suppressed.covers("UC201", element.at) for element in root.walk())
        assert len(suppressed.used) == comments

    assert_few_steps(judge, 200)


def test_a_comment_with_many_codes_is_compared_in_few_steps() -> None:
    def judge(codes: int) -> None:
        listed = ",".join(f"UC{number}" for number in range(1000, 1000 + codes))
        read = source(f"<robot><!-- urdfctl: ignore[{listed}] -->{'<a/>' * codes}</robot>")
        root = parse(read).documentElement
        assert root is not None
        suppressed = Suppressed([read])
        assert not any(suppressed.covers("UC201", element.at) for element in root.walk())

    assert_few_steps(judge, 200)
