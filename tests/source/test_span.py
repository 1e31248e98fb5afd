"""Positions, start tags and spans, read from the bytes of a file."""

from __future__ import annotations

import pytest
from hypothesis import assume, given
from hypothesis import strategies as st
from work import assert_little_time

from urdfctl.source.span import Call, Place, SourceSpan, SourceText

BOM = b"\xef\xbb\xbf"
TEXTS = st.text(st.sampled_from("ab \t<>=\"'/\r\n\xe9\u2028\ufeff\U0001f916"), max_size=40)


def source(text: str | bytes) -> SourceText:
    return SourceText("a.urdf", text if isinstance(text, bytes) else text.encode())


@pytest.mark.parametrize(
    ("text", "offset", "position"),
    [
        (b"ab\ncd", 4, (2, 2)),
        (b"ab\r\ncd", 5, (2, 2)),
        (b"ab\rcd", 4, (2, 2)),
        (b"a\n\n\nb", 4, (4, 1)),
        (b"a\r\r\nb", 4, (3, 1)),
        (b"\tx", 1, (1, 2)),
        (BOM + b"ab", 4, (1, 2)),
        (BOM + b"a\nb", 5, (2, 1)),
        ("\xe9x".encode(), 2, (1, 2)),
        ("\U0001f916x".encode(), 4, (1, 2)),
        ("a\u2028b".encode(), 4, (1, 3)),
        (b"ab", 2, (1, 3)),
        (b"ab\n", 3, (2, 1)),
        (b"", 0, (1, 1)),
    ],
)
def test_a_column_counts_code_points_of_its_line_without_a_byte_order_mark(
    text: bytes, offset: int, position: tuple[int, int]
) -> None:
    assert source(text).position(offset) == position


@given(TEXTS, st.booleans())
def test_an_offset_leads_back_from_its_position(text: str, has_bom: bool) -> None:
    data = BOM * has_bom + text.encode()
    read = source(data)
    assume(has_bom or not text.startswith("\ufeff"))
    offset = len(BOM) * has_bom
    for before, character in zip(" " + text, text, strict=False):
        if before + character != "\r\n":
            assert read.offset(*read.position(offset)) == offset
        offset += len(character.encode())
    assert read.position(offset).line == len(read.line_starts())


@given(TEXTS, st.booleans())
def test_lines_are_those_between_lf_crlf_and_cr(text: str, has_bom: bool) -> None:
    read = source(BOM * has_bom + text.encode())
    lines = text.replace("\r\n", "\n").replace("\r", "\n").split("\n")
    lines[0] = lines[0] if has_bom else lines[0].removeprefix("\ufeff")
    assert [read.line(number + 1) for number in range(len(lines))] == lines
    assert len(read.line_starts()) == len(lines)
    assert read.line(0) == read.line(len(lines) + 1) == ""


def test_an_offset_past_a_line_or_the_file_is_cut_to_what_is_there() -> None:
    read = source("ab\r\ncd")
    assert read.offset(1, 99) == 2
    assert read.offset(99) == 6


def attributes(text: str) -> dict[str, str]:
    read = source(text)
    tag = read.start_tag(read.data.index(b"<"))
    assert tag is not None
    return {name: SourceSpan(read, start, end).text for name, (start, end) in tag.attributes.items()}


@pytest.mark.parametrize(
    ("text", "found"),
    [
        ('<a b="1" c="2">', {"b": "1", "c": "2"}),
        ("<a b='1'/>", {"b": "1"}),
        ("<a b='say \"x\"'/>", {"b": 'say "x"'}),
        ('<a b="x > y" c="z"/>', {"b": "x > y", "c": "z"}),
        ('<a b="${1 > 2}"/>', {"b": "${1 > 2}"}),
        ('<a\n  b = "1"\r\n\tc\n=\n"2"\n>', {"b": "1", "c": "2"}),
        ('<a b=""/>', {"b": ""}),
        ('<a b="1&#10;&amp;2"/>', {"b": "1&#10;&amp;2"}),
        ('<xacro:m xmlns:xacro="u" xacro:n="\xe9"/>', {"xmlns:xacro": "u", "xacro:n": "\xe9"}),
        ("<a.b-c_d \xe9t\xe9='1'>", {"\xe9t\xe9": "1"}),
        ("<a/>", {}),
        ("<a>", {}),
    ],
)
def test_a_start_tag_knows_where_each_attributes_value_stands(text: str, found: dict[str, str]) -> None:
    assert attributes(text) == found


@pytest.mark.parametrize(
    ("text", "cut", "self_closed"),
    [
        ('x <a b="1"> y', '<a b="1">', False),
        ('x <a b="1"/> y', '<a b="1"/>', True),
        ('<a\n b=">"\n/>', '<a\n b=">"\n/>', True),
        ("<a b='/>'>t</a>", "<a b='/>'>", False),
        ("<a>", "<a>", False),
    ],
)
def test_a_start_tag_ends_at_its_own_bracket(text: str, cut: str, self_closed: bool) -> None:
    read = source(text)
    start = text.index("<")
    tag = read.start_tag(start)
    assert tag is not None
    assert Place(read, start).span.text == cut
    assert tag.self_closed is self_closed


def test_where_no_tag_stands_there_is_none_and_its_place_is_empty() -> None:
    read = source("no tag")
    assert read.start_tag(2) is None
    assert Place(read, 2).span.text == ""
    assert Place(read, 2)["name"].span.text == ""
    assert Place(read, 2).content.span.text == ""


NAMES = st.from_regex(r"[a-z_][a-z0-9_.-]{0,5}(:[a-z]{1,3})?", fullmatch=True)
VALUES = st.text(st.characters(blacklist_characters="\"'<&\r\n\t", blacklist_categories=("Cs", "Cc")), max_size=8)
BLANKS = st.sampled_from([" ", "\n", "\r\n  ", "\t"])


@given(NAMES, st.dictionaries(NAMES, VALUES, max_size=4), BLANKS, st.sampled_from("'\""), st.sampled_from(["", " "]))
def test_every_attribute_of_a_tag_is_cut_out_as_it_was_written(
    name: str, values: dict[str, str], blank: str, quote: str, around: str
) -> None:
    written = "".join(f"{blank}{key}{around}={around}{quote}{value}{quote}" for key, value in values.items())
    text = f"\xe9<{name}{written}{around}/>"
    assert attributes(text) == values
    assert Place(source(text), 2).span.text == text[1:]


@pytest.mark.parametrize(
    ("text", "content"),
    [
        ("<a>  effort\n</a>", "effort"),
        ("<a>\n  <b/> c\n</a>", "<b/> c"),
        ("<a><!-- x --></a>", "<!-- x -->"),
        ("<a>  \n </a>", "<a>"),
        ("<a></a>", "<a>"),
    ],
)
def test_the_content_of_an_element_stands_between_its_tags(text: str, content: str) -> None:
    assert Place(source(text), 0, close=text.rindex("</")).content.span.text == content


def test_an_element_that_closes_itself_has_its_tag_for_content() -> None:
    place = Place(source("<a/>"), 0, close=0)
    assert place.content is place
    assert Place(source("<a>x</a>"), 0).content.span.text == "<a>"


def test_the_place_of_an_attribute_is_its_value_and_the_elements_own_where_it_has_none() -> None:
    place = Place(source('<a b="12"/>'), 0)
    assert place["b"].span.text == "12"
    assert place["c"].span.text == '<a b="12"/>'


def test_an_attribute_that_came_from_elsewhere_has_its_place_there() -> None:
    read = source('<a><xacro:attribute name="b" value="1"/></a>')
    place = Place(read, 0, attributes={"b": (read, 3)})
    assert place["b"].span.text == '<xacro:attribute name="b" value="1"/>'


def test_a_chain_tells_the_innermost_call_first() -> None:
    read = source("<xacro:include filename='x'/><xacro:m/>")
    outer = Call("include", "x", read, 0, None)
    inner = Call("macro", "m", read, 29, outer)
    assert [(call.kind, call.span.text) for call in inner.chain()] == [
        ("macro", "<xacro:m/>"),
        ("include", "<xacro:include filename='x'/>"),
    ]


LONG = st.lists(
    st.tuples(st.text(st.sampled_from("ab\xe9\u2028\U0001f916"), min_size=1, max_size=3), st.integers(1, 900))
)


@given(LONG, st.booleans(), st.data())
def test_a_column_in_a_long_line_is_counted_as_in_a_short_one(
    pieces: list[tuple[str, int]], has_bom: bool, data: st.DataObject
) -> None:
    line = "".join(text * times for text, times in pieces)
    read = source(BOM * has_bom + f"{line}\n{line}".encode())
    column = data.draw(st.integers(0, len(line)))
    before = len(line[:column].encode())
    second = len(BOM) * has_bom + len(line.encode()) + 1
    assert read.position(len(BOM) * has_bom + before) == (1, column + 1)
    assert read.position(second + before) == (2, column + 1)


@given(LONG, st.data())
def test_an_excerpt_of_a_long_line_surrounds_its_place(pieces: list[tuple[str, int]], data: st.DataObject) -> None:
    line = "".join(text * times for text, times in pieces)
    read = source(f"first\n{line}\r\nlast")
    column = data.draw(st.integers(0, len(line)))
    start = max(0, column - 20) if len(line) > 40 else 0
    shown = read.excerpt(len("first\n") + len(line[:column].encode()), 40)
    assert shown == (line[start : start + 40], start + 1)


def test_the_places_in_one_long_line_are_found_in_little_time() -> None:
    def locate(places: int) -> None:
        read = source("\xe9" + "<a/>" * places)
        for place in range(places):
            read.position(2 + 4 * place)
            read.excerpt(2 + 4 * place, 400)

    assert_little_time(locate, 3000)


@pytest.mark.parametrize(
    ("path", "text", "expected"),
    [
        ("arm.urdf", "<robot/>", False),
        ("arm.xacro.urdf", "<robot/>", True),
        ("arm.urdf", '<robot xmlns:xacro="x"/>', True),
        ("arm.urdf", '<!-- autogenerated by xacro --><robot xmlns:xacro="x"><xacro:unknown/></robot>', False),
        ("arm.urdf", '<!-- autogenerated by xacro --><robot xmlns:xacro="x"><xacro:arg name="a"/></robot>', True),
        ("arm.urdf", '<!-- autogenerated by xacro --><robot xmlns:xacro="x"><link name="${a}"/></robot>', True),
        ("arm.urdf", '<!-- autogenerated by xacro --><robot xmlns:xacro="x"><!-- <xacro:arg --></robot>', False),
    ],
)
def test_what_xacro_wrote_is_for_xacro_only_if_it_was_given_something_for_it(
    path: str, text: str, expected: bool
) -> None:
    assert SourceText(path, text.encode()).is_xacro is expected
