"""The located tree: what is parsed, how it is edited as minidom would, and what is written again."""

from __future__ import annotations

import re
from typing import Any
from xml.dom import minidom

import pytest
import xacro  # noqa: F401 (puts its own writexml into minidom)
from expansion import elements
from folder import Folder
from hypothesis import given
from hypothesis import strategies as st

from urdfctl.expand.xml_writer import write
from urdfctl.source.problem import Problem, ProblemKind, ReadError
from urdfctl.source.span import SourceText
from urdfctl.source.xacro.private.stand_ins import NotFoundErr
from urdfctl.source.xml.dom import Cloning, Element, XmlText
from urdfctl.source.xml.parsing import parse


def tree(text: str | bytes) -> Element:
    root = parse(SourceText("a.urdf", text if isinstance(text, bytes) else text.encode())).documentElement
    assert root is not None
    return root


def problem(text: str | bytes) -> Problem:
    with pytest.raises(ReadError) as raised:
        tree(text)
    return raised.value.problem


def told(text: str | bytes) -> str:
    found = problem(text)
    return "{}:{} {}".format(*found.at.source.position(found.at.span.start), found.message)


# -- places -----------------------------------------------------------------------------------------------------------


def test_an_element_stands_where_its_start_tag_does() -> None:
    root = tree("<?xml version='1.0'?>\n<robot>\n\t<link name='\U0001f916'/><joint\r\n  name='j'>\r\n</joint></robot>")
    places = [(e.tagName, *e.at.source.position(e.start), e.at.span.text) for e in elements(root)]
    assert places == [
        ("robot", 2, 1, "<robot>"),
        ("link", 3, 2, "<link name='\U0001f916'/>"),
        ("joint", 3, 18, "<joint\r\n  name='j'>"),
    ]


def test_an_element_remembers_where_its_end_tag_stands() -> None:
    text = "<a><b> x </b><c/></a>"
    root = tree(text)
    b, _ = root.elements()
    assert text[b.close or 0 :].startswith("</b>")
    assert b.at.content.span.text == "x"
    assert text[root.close or 0 :] == "</a>"


def test_a_byte_order_mark_shifts_no_column() -> None:
    root = tree(b"\xef\xbb\xbf<robot><link/></robot>")
    assert [e.at.source.position(e.start) for e in elements(root)] == [(1, 1), (1, 8)]


# -- what cannot be parsed --------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("text", "said"),
    [
        (b"", "1:1 the file is empty"),
        (b" \n\n", "1:1 the file is empty"),
        (b"\xef\xbb\xbf", "1:1 the file is empty"),
        (
            b"<a>\n  <b>\n</a>",
            "3:1 <b> in line 2 is not closed: expected </b>, found </a>",
        ),
        (b"<a></a>\n<b/>", "2:1 text after the end of the root element"),
        (b"<a/>\ntext", "2:1 text after the end of the root element"),
        (b"\n<?xml version='1.0'?><a/>", "2:1 the XML declaration <?xml ...?> is not at the start of the file"),
        (b"  <?xml version='1.0'?><a/>", "1:3 the XML declaration <?xml ...?> is not at the start of the file"),
        (b"<a><xacro:b/></a>", "1:1 prefix 'xacro:' is not declared in the root element"),
        (b"<a><b x:y='1'/></a>", "1:1 prefix 'x:' is not declared in the root element"),
        (b"<a><b>", "1:7 <b> in line 1 has no end tag"),
        (b"<a>\n<b", "2:1 <a> in line 1 has no end tag"),
        (b"<a x='1 & 2'/>", "1:9 a bare '&' is not valid XML"),
        (b"<a>&</a>", "1:4 a bare '&' is not valid XML"),
        (b"<a>x &y z</a>", "1:6 a bare '&' is not valid XML"),
        (b"<a>\n <b\n <c/></a>", "2:2 tag <b is not closed before the next '<'"),
        (b"<a>&nbsp;</a>", "1:4 not well-formed XML: undefined entity"),
        (b"<a b='1' b='2'/>", "1:10 not well-formed XML: duplicate attribute"),
        (b"<a b='\xff'/>", "1:7 byte 0xff is not valid UTF-8"),
        (b"<a>\x00</a>", "1:4 the file is binary, not XML"),
        (b"\x7fELF\x00\x01", "1:5 the file is binary, not XML"),
        ("<a/>".encode("utf-16"), "1:1 the file is UTF-16; xacro and urdfdom read UTF-8"),
        (b"just text", "1:1 not XML: an XML file starts with a tag"),
        (b"<a b=1/>", "1:6 the value of attribute 'b' has no quotes"),
        (b"<a b=1'/>", "1:6 the value of attribute 'b' has no quotes"),
        (b"<a b='1 c='2'/>", "1:6 the value of attribute 'b' has no closing quote"),
        (b"<a b='1>\n<c/></a>", "1:4 the value of attribute 'b' has no closing quote"),
        (b"<a b=''1/>", "1:8 part of the value of attribute 'b' is outside its quotes"),
        (b"<a b='$'{c} d='2'/>", "1:9 part of the value of attribute 'b' is outside its quotes"),
        (b"<a b='0' 0 1 c='2'/>", "1:10 part of the value of attribute 'b' is outside its quotes"),
        (b"<a b='0''/>", "1:9 part of the value of attribute 'b' is outside its quotes"),
        (b"<a b='0'c='2'/>", "1:9 there is no blank between attribute 'b' and attribute 'c'"),
        (b"<a b='0' c'2'/>", "1:11 there is no '=' between attribute 'c' and its value"),
        (b"<a b='1 < 2'/>", "1:9 '<' is not allowed in the value of an attribute"),
        (b"<a b='${x && y}'/>", "1:11 '&&' is not valid in XML, nor in an expression of xacro"),
        (b"<a>\n<!-- x -- y --></a>", "2:8 '--' in the comment that begins in line 2; XML does not allow it inside a comment"),  # noqa: E501
        (b"<a><!-- x --- y --></a>", "1:12 '--' in the comment that begins in line 1; XML does not allow it inside a comment"),  # noqa: E501
        (b"<a><!-- x\n<!-- y --> --></a>", "2:1 a comment inside the comment that begins in line 1; XML comments cannot be nested"),  # noqa: E501
        (b"<a><!-- x --><!-- y -- --></a>", "1:21 '--' in the comment that begins in line 1; XML does not allow it inside a comment"),  # noqa: E501
        (b"<a></a></b>", "1:8 end tag </b> has no matching start tag"),
        (b"<a></a>\n\t</b >", "2:2 end tag </b> has no matching start tag"),
        (b"<?xml version='1.0'?>", "1:22 not well-formed XML: no element found"),
    ],
)  # fmt: skip
def test_what_is_no_xml_is_told_where_and_why(text: bytes, said: str) -> None:
    assert told(text) == said
    assert problem(text).kind is ProblemKind.XML_SYNTAX


def test_the_way_out_is_named_where_there_is_one() -> None:
    assert problem(b"<a><xacro:b/></a>").hint == ('add xmlns:xacro="http://www.ros.org/wiki/xacro" to the root element')
    assert problem(b"<a>&</a>").hint == "write &amp;"


def test_a_declared_encoding_is_passed_over_as_xacro_and_urdfdom_do() -> None:
    root = tree("<?xml version='1.0' encoding='ISO-8859-1'?><a b='\xe9'/>")
    assert root.getAttribute("b") == "\xe9"
    assert told(b"<?xml version='1.0' encoding='ISO-8859-1'?><a b='\xe9'/>") == "1:50 byte 0xe9 is not valid UTF-8"


def test_a_doctype_that_declares_something_is_refused() -> None:
    bomb = '<?xml version="1.0"?>\n<!DOCTYPE a [<!ENTITY x "xxxxxxxx"><!ENTITY y "&x;&x;&x;">]><a>&y;</a>'
    found = problem(bomb)
    assert found.kind is ProblemKind.DOCTYPE
    assert (found.at.source.position(found.at.start), found.at.span.text) == ((2, 1), "<!DOCTYPE")


def test_a_trusted_doctype_brings_its_entities() -> None:
    source = SourceText("a", b'<!DOCTYPE a [<!ENTITY x "12">]><a>&x;</a>')
    root = parse(source, declarations=True).documentElement
    assert root is not None
    assert isinstance(root.firstChild, XmlText)
    assert root.firstChild.data == "12"


def test_an_external_entity_reads_no_file() -> None:
    source = SourceText("a", b'<!DOCTYPE a [<!ENTITY x SYSTEM "/etc/hostname">]><a>[&x;]</a>')
    root = parse(source, declarations=True).documentElement
    assert root is not None
    assert "".join(t.data for t in root.children() if isinstance(t, XmlText)) == "[]"


def test_elements_nest_two_hundred_deep_and_no_deeper() -> None:
    assert len(elements(tree("<a>" * 200 + "</a>" * 200))) == 200
    found = problem("<a>" * 100_000)
    assert found.kind is ProblemKind.BUDGET
    assert found.at.start == 600


@given(st.text(st.sampled_from("<>/ab ='\"&;!-[]?x:\n\xe9"), max_size=30))
def test_what_minidom_refuses_is_a_problem_inside_the_file_and_the_rest_is_read(text: str) -> None:
    try:
        minidom.parseString(text.encode())
    except Exception:  # noqa: BLE001 (expat's errors, and minidom's own)
        found = problem(text)
        assert 0 <= found.at.span.start <= found.at.span.end <= len(text.encode())
    else:
        assert tree(text).source.data == text.encode()


# -- edited as minidom's tree -----------------------------------------------------------------------------------------


def shape(node: Any) -> list[object]:
    """A tree as plain lists, from either kind of node, and whether its links fit together."""
    children = list(node.childNodes)
    for before, after in zip([None, *children], [*children, None], strict=True):
        assert before is None or before.nextSibling is after
        assert after is None or (after.previousSibling is before and after.parentNode is node)
    assert node.firstChild is (children[0] if children else None)
    assert node.lastChild is (children[-1] if children else None)
    return [node.nodeType, getattr(node, "tagName", None), *(shape(child) for child in children)]


OPERATIONS = st.lists(
    st.tuples(st.sampled_from(["append", "insert", "remove", "clone"]), st.integers(0, 5), st.integers(0, 5)),
    max_size=12,
)


def edited(root: Any, operations: list[tuple[str, int, int]]) -> list[object]:
    nodes = list(root.childNodes)
    for operation, first, second in operations:
        node, other = nodes[first % len(nodes)], nodes[second % len(nodes)]
        if operation == "append":
            root.appendChild(node)
        elif operation == "clone":
            root.appendChild(node.cloneNode(True))
        elif operation == "remove" and node.parentNode is root:
            root.removeChild(node)
        elif operation == "insert" and other.parentNode is root and other is not node:
            root.insertBefore(node, other)
    return shape(root)


@given(OPERATIONS)
def test_nodes_move_as_in_minidom(operations: list[tuple[str, int, int]]) -> None:
    text = "<r><a><i/>t</a><b/>text<c x='1'/><!-- n --></r>"
    assert edited(tree(text), operations) == edited(minidom.parseString(text).documentElement, operations)


def test_a_node_that_is_no_child_is_neither_removed_nor_inserted_before() -> None:
    root = tree("<r><a><b/></a></r>")
    inner = elements(root)[2]
    with pytest.raises(NotFoundErr):
        root.removeChild(inner)
    with pytest.raises(NotFoundErr):
        root.insertBefore(XmlText("x"), inner)
    with pytest.raises(NotFoundErr):
        root.removeAttribute("none")


def test_attributes_read_as_in_minidom() -> None:
    text = "<r b='1' a='2'/>"
    ours, theirs = tree(text), minidom.parseString(text).documentElement
    for element in (ours, theirs):
        element.setAttribute("c", "3")
        element.removeAttribute("b")
    assert ours.attributes.items() == theirs.attributes.items()
    assert ours.attributes.keys() == list(theirs.attributes.keys())
    assert len(ours.attributes) == len(theirs.attributes)
    assert ours.hasAttribute("a")
    assert not ours.hasAttribute("b")
    assert ours.getAttribute("b") == theirs.getAttribute("b")
    assert ours.getAttributeNode("b") is theirs.getAttributeNode("b") is None
    found = ours.getAttributeNode("a")
    assert found is not None
    assert found.value == theirs.getAttributeNode("a").value


def test_a_copy_stands_where_its_original_does_and_shares_no_attribute() -> None:
    root = tree("<r><a x='1'>t<?p i?><!--c--><![CDATA[d]]></a></r>")
    (original,) = root.elements()
    copy = original.cloneNode(deep=True)
    copy.setAttribute("x", "2")
    assert original.getAttribute("x") == "1"
    assert copy.at.span == original.at.span
    assert copy.at.content.span == original.at.content.span
    assert shape(copy) == shape(original)
    assert copy.parentNode is None


def test_elements_and_their_copies_are_counted() -> None:
    cloning = Cloning()
    root = parse(SourceText("a", b"<r><a><b/></a></r>"), cloning).documentElement
    assert root is not None
    root.cloneNode(deep=True)
    assert cloning.count == 6


# -- written again ----------------------------------------------------------------------------------------------------


def rewritten(text: str) -> str:
    return write(parse(SourceText("a.urdf", text.encode())))


def rewritten_by_minidom(text: str) -> str:
    return str(minidom.parseString(text.encode()).toprettyxml(indent="  "))


@pytest.mark.parametrize(
    "text",
    [
        "<a/>",
        "<a></a>",
        "<a> </a>",
        "<a>text</a>",
        "<a>\n  text\n</a>",
        "<a>text<b/>more</a>",
        "<a>\n\n<b/>\n\n</a>",
        "<a z='1' b='2' a:c='3' xmlns:a='u' xmlns='v'/>",
        "<a b='&lt;&gt;&amp;&quot;&apos;'>&lt;&gt;&amp;&quot;&apos;</a>",
        "<a b='1&#10;2&#9;3&#13;4'>1&#13;2</a>",
        "<a b='1\n2\t3'/>",
        "<a><![CDATA[x < y]]></a>",
        "<a>x<![CDATA[y]]>z</a>",
        "<a><![CDATA[]]></a>",
        "<a><![CDATA[x]]><![CDATA[y]]></a>",
        "<a><b/><![CDATA[x]]><c/></a>",
        "<!-- before --><a><!-- in --><b/><!-- - --></a><!-- after -->",
        "<?xml version='1.0' encoding='utf-8'?>\n<?p some thing?><a><?q?></a>",
        "<!DOCTYPE a><a/>",
        "<!DOCTYPE a SYSTEM 'a.dtd'><a/>",
        "<!DOCTYPE a PUBLIC '-//A//B' 'a.dtd'><a/>",
        "<a>\r\n<b/>\r\n</a>",
        "<a>\xe9\U0001f916<b c='\xe9'/></a>",
        "<a>\xa0</a>",
        "<a>\xa0<b/></a>",
        "<x:a xmlns:x='u' xmlns:y='u' y:b='1'/>",
        "<a xmlns='u'><b xmlns=''/></a>",
        "<a><b> x </b><b>\n</b></a>",
    ],
)
def test_a_document_is_written_as_minidom_writes_it(text: str) -> None:
    assert rewritten(text) == rewritten_by_minidom(text)


TEXTS = st.text(st.sampled_from("ab <>&\"'\n\t\xe9"), max_size=6)


@st.composite
def documents(draw: st.DrawFn, depth: int = 3) -> str:
    """Literal XML with all kinds of nodes."""
    escape = {"<": "&lt;", "&": "&amp;", '"': "&quot;", ">": "&gt;"}
    name = draw(st.sampled_from(["a", "b", "link"]))
    values = draw(st.dictionaries(st.sampled_from(["x", "y", "name"]), TEXTS, max_size=2))
    attributes = "".join(f' {k}="{"".join(escape.get(c, c) for c in v)}"' for k, v in values.items())
    pieces = []
    for _ in range(draw(st.integers(0, 3)) if depth else 0):
        kind = draw(st.sampled_from(["element", "text", "comment", "cdata", "instruction"]))
        text = draw(TEXTS)
        if kind == "element":
            pieces.append(draw(documents(depth - 1)))
        elif kind == "text":
            pieces.append("".join(escape.get(c, c) for c in text))
        elif kind == "comment":
            pieces.append(f"<!--{text}-->")
        elif kind == "cdata":
            pieces.append(f"<![CDATA[{text}]]>")
        else:
            pieces.append(f"<?p {text.strip()}?>")
    return f"<{name}{attributes}>{''.join(pieces)}</{name}>"


@given(documents())
def test_any_document_is_written_as_minidom_writes_it(text: str) -> None:
    assert rewritten(text) == rewritten_by_minidom(text)


def test_the_banner_names_the_file_without_double_dashes() -> None:
    document = parse(SourceText("a", b"<a/>"))
    assert re.findall(r"autogenerated by xacro from (\S+)", write(document, "/x/a--b.xacro")) == ["/x/a-b.xacro"]


@pytest.mark.parametrize(("name", "severity"), [("robot.urdf", "warning"), ("robot.xacro", "error")])
def test_blanks_before_the_declaration_are_refused_where_xacro_reads(folder: Folder, name: str, severity: str) -> None:
    folder.write({name: '\n<?xml version="1.0"?>\n<robot name="r"><link name="a"/></robot>\n'})
    ran = folder.run("lint", name, "--format", "concise")
    assert ran.stdout.startswith(f"{name}:2:1: {severity} UC001 the XML declaration"), ran.stdout
    assert ran.returncode == (severity == "error")
