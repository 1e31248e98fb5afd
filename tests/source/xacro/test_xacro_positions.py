"""Every expanded element and attribute knows where the user wrote it, and by which calls it came about."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path

from expansion import NAMESPACE, elements, expanded, laid_out, robot

from urdfctl.source.span import Place
from urdfctl.source.xml.dom import Element


def robot_of(tmp_path: Path, body: str, others: Mapping[str, str] | None = None) -> list[Element]:
    """The elements of an expanded robot, without its root."""
    path = laid_out(tmp_path, {"r.xacro": robot(body), **(others or {})})
    expansion = expanded(path)
    assert expansion.problems == []
    return elements(expansion.document)[1:]


def where(place: Place) -> str:
    """A place as `file:line:column text`."""
    position = place.source.position(place.span.start)
    return f"{Path(place.source.path).name}:{position.line}:{position.column} {place.span.text}"


def chain(element: Element) -> list[str]:
    """The calls that led to an element, innermost first."""
    calls = element.call.chain() if element.call else ()
    return [
        f"{call.kind} {Path(call.source.path).name}:{call.source.position(call.offset).line} {call.span.text}"
        for call in calls
    ]


def test_what_is_written_out_stands_where_it_is_written(tmp_path: Path) -> None:
    (link, mass) = robot_of(tmp_path, '  <link name="a">\n\t<mass value="${1 + 1}"/></link>')
    assert where(link.at) == 'r.xacro:2:3 <link name="a">'
    assert where(mass.at["value"]) == "r.xacro:3:15 ${1 + 1}"
    assert mass.attrs["value"] == "2"
    assert chain(mass) == []


def test_what_a_macro_brings_stands_in_the_macro_with_the_call_that_brought_it(tmp_path: Path) -> None:
    body = """<xacro:macro name="wheel" params="side">
  <link name="${side}_wheel"/>
</xacro:macro>
<xacro:wheel side="left"/>
<xacro:wheel side="right"/>"""
    left, right = robot_of(tmp_path, body)
    assert where(left.at) == where(right.at) == 'r.xacro:3:3 <link name="${side}_wheel"/>'
    assert where(right.at["name"]) == "r.xacro:3:15 ${side}_wheel"
    assert chain(left) == ['macro r.xacro:5 <xacro:wheel side="left"/>']
    assert chain(right) == ['macro r.xacro:6 <xacro:wheel side="right"/>']


def test_a_call_knows_the_definition_of_its_macro(tmp_path: Path) -> None:
    (link,) = robot_of(tmp_path, '<xacro:macro name="m"><link/></xacro:macro><xacro:m/>')
    assert link.call is not None
    assert link.call.definition is not None
    assert link.call.definition.text == '<xacro:macro name="m">'


def test_a_macro_called_in_a_macro_gives_a_chain_of_both(tmp_path: Path) -> None:
    body = """<xacro:macro name="inner"><link name="i"/></xacro:macro>
<xacro:macro name="outer"><xacro:inner/></xacro:macro>
<xacro:outer/>"""
    (link,) = robot_of(tmp_path, body)
    assert chain(link) == ["macro r.xacro:3 <xacro:inner/>", "macro r.xacro:4 <xacro:outer/>"]


def test_what_an_include_brings_stands_in_the_included_file(tmp_path: Path) -> None:
    others = {
        "sub/i.xacro": f'<robot {NAMESPACE}>\r\n<xacro:include filename="k.xacro"/>\r\n  <link name="i"/>\r\n</robot>',
        "sub/k.xacro": "\ufeff<robot><link name='k'/></robot>",
    }
    k, i = robot_of(tmp_path, '<xacro:include filename="sub/i.xacro"/>', others)
    assert where(i.at) == 'i.xacro:3:3 <link name="i"/>'
    assert where(k.at) == "k.xacro:1:8 <link name='k'/>"
    assert chain(i) == ['include r.xacro:2 <xacro:include filename="sub/i.xacro"/>']
    assert chain(k) == ['include i.xacro:2 <xacro:include filename="k.xacro"/>', *chain(i)]


def test_a_macro_of_an_included_file_is_blamed_on_its_call_not_on_the_include(tmp_path: Path) -> None:
    others = {"i.xacro": f'<robot {NAMESPACE}><xacro:macro name="m"><link/></xacro:macro></robot>'}
    (link,) = robot_of(tmp_path, '<xacro:include filename="i.xacro"/>\n<xacro:m/>', others)
    assert where(link.at) == "i.xacro:1:74 <link/>"
    assert chain(link) == ["macro r.xacro:3 <xacro:m/>"]


def test_a_macro_of_a_namespace_is_blamed_on_its_call(tmp_path: Path) -> None:
    others = {"i.xacro": f'<robot {NAMESPACE}><xacro:macro name="m"><link/></xacro:macro></robot>'}
    (link,) = robot_of(tmp_path, '<xacro:include filename="i.xacro" ns="n"/>\n<xacro:n.m/>', others)
    assert chain(link) == ["macro r.xacro:3 <xacro:n.m/>"]


def test_an_inserted_block_stands_where_it_is_written(tmp_path: Path) -> None:
    body = """<xacro:macro name="m" params="*origin">
  <joint><xacro:insert_block name="origin"/></joint>
</xacro:macro>
<xacro:m>
  <origin xyz="${1} 0 0"/>
</xacro:m>"""
    joint, origin = robot_of(tmp_path, body)
    assert where(origin.at) == 'r.xacro:6:3 <origin xyz="${1} 0 0"/>'
    assert where(origin.at["xyz"]) == "r.xacro:6:16 ${1} 0 0"
    assert chain(joint) == ["macro r.xacro:5 <xacro:m>"]
    assert chain(origin) == ['block r.xacro:3 <xacro:insert_block name="origin"/>']


def test_a_call_inside_a_block_belongs_to_who_wrote_the_block(tmp_path: Path) -> None:
    body = """<xacro:macro name="leaf"><l/></xacro:macro>
<xacro:macro name="wrap" params="**all"><w><xacro:insert_block name="all"/></w></xacro:macro>
<xacro:wrap><all><xacro:leaf/></all></xacro:wrap>"""
    wrap, leaf = robot_of(tmp_path, body)
    assert chain(wrap) == ["macro r.xacro:4 <xacro:wrap>"]
    assert chain(leaf) == [
        'block r.xacro:3 <xacro:insert_block name="all"/>',
        "macro r.xacro:4 <xacro:leaf/>",
    ]


def test_a_block_handed_on_by_a_macro_keeps_its_place(tmp_path: Path) -> None:
    body = """<xacro:macro name="inner" params="*o"><in><xacro:insert_block name="o"/></in></xacro:macro>
<xacro:macro name="outer" params="*o"><xacro:inner><xacro:insert_block name="o"/></xacro:inner></xacro:macro>
<xacro:outer><origin/></xacro:outer>"""
    inside, origin = robot_of(tmp_path, body)
    assert where(origin.at) == "r.xacro:4:14 <origin/>"
    assert chain(inside) == ["macro r.xacro:3 <xacro:inner>", "macro r.xacro:4 <xacro:outer>"]


def test_a_property_that_is_a_block_stands_where_it_is_written(tmp_path: Path) -> None:
    body = '<xacro:property name="p"><a b="1"/></xacro:property>\n<c><xacro:insert_block name="p"/></c>'
    _, inserted = robot_of(tmp_path, body)
    assert where(inserted.at["b"]) == "r.xacro:2:32 1"


def test_an_attribute_set_by_xacro_attribute_stands_there(tmp_path: Path) -> None:
    body = """<link a="1"><xacro:attribute name="b" value="2"/>
<xacro:attribute name="${'c'}" value="3"/></link>"""
    (link,) = robot_of(tmp_path, body)
    assert link.attrs == {"a": "1", "b": "2", "c": "3"}
    assert where(link.at["b"]) == 'r.xacro:2:13 <xacro:attribute name="b" value="2"/>'
    assert where(link.at["c"]) == 'r.xacro:3:1 <xacro:attribute name="${\'c\'}" value="3"/>'
    assert where(link.at["a"]) == "r.xacro:2:10 1"


def test_an_attribute_set_in_a_macro_is_kept_by_every_copy(tmp_path: Path) -> None:
    body = """<xacro:macro name="m"><link><xacro:attribute name="b" value="2"/></link></xacro:macro>
<xacro:m/><xacro:m/>"""
    one, two = robot_of(tmp_path, body)
    assert where(one.at["b"]) == where(two.at["b"]) == 'r.xacro:2:29 <xacro:attribute name="b" value="2"/>'


def test_an_attribute_that_is_not_written_has_the_place_of_its_element(tmp_path: Path) -> None:
    (link,) = robot_of(tmp_path, "<link/>")
    assert where(link.at["name"]) == "r.xacro:2:1 <link/>"


def test_an_element_named_by_xacro_element_stands_there(tmp_path: Path) -> None:
    (joint,) = robot_of(tmp_path, """<xacro:element xacro:name="${'joint'}" type="t"></xacro:element>""")
    assert joint.tagName == "joint"
    assert where(joint.at["type"]) == "r.xacro:2:46 t"


def test_what_a_condition_keeps_stands_where_it_is_written(tmp_path: Path) -> None:
    (link,) = robot_of(tmp_path, '<xacro:if value="1">\n <xacro:unless value="0"><link/></xacro:unless></xacro:if>')
    assert where(link.at) == "r.xacro:3:26 <link/>"
    assert chain(link) == []


def test_a_call_by_xacro_call_stands_there(tmp_path: Path) -> None:
    body = '<xacro:macro name="m" params="n"><link name="${n}"/></xacro:macro>\n<xacro:call macro="m" n="1"/>'
    (link,) = robot_of(tmp_path, body)
    assert chain(link) == ['macro r.xacro:3 <xacro:call macro="m" n="1"/>']


def test_the_content_of_an_element_stands_between_its_tags(tmp_path: Path) -> None:
    body = '<xacro:macro name="m" params="h"><i>\n  ${h}\n</i></xacro:macro><xacro:m h="effort"/>'
    (interface,) = robot_of(tmp_path, body)
    assert where(interface.at.content) == "r.xacro:3:3 ${h}"


def test_a_recursive_macro_gives_a_chain_as_long_as_its_recursion(tmp_path: Path) -> None:
    body = """<xacro:macro name="m" params="n"><link name="${n}"/>
<xacro:if value="${n > 0}"><xacro:m n="${n - 1}"/></xacro:if></xacro:macro>
<xacro:m n="2"/>"""
    assert [len(chain(link)) for link in robot_of(tmp_path, body)] == [1, 2, 3]


def problem_at(tmp_path: Path, body: str, others: Mapping[str, str] | None = None) -> tuple[str, list[str]]:
    path = laid_out(tmp_path, {"r.xacro": robot(body), **(others or {})})
    (problem,) = expanded(path).problems
    calls = problem.at.call.chain() if problem.at.call else ()
    return where(problem.at), [call.span.text for call in calls]


def test_a_problem_in_a_macro_stands_there_with_the_chain_of_its_calls(tmp_path: Path) -> None:
    body = """<xacro:macro name="k" params="a"><b c="${a + 1}"/></xacro:macro>
<xacro:macro name="m"><xacro:k a="x"/></xacro:macro>
<xacro:m/>"""
    assert problem_at(tmp_path, body) == ("r.xacro:2:40 ${a + 1}", ['<xacro:k a="x"/>', "<xacro:m/>"])


def test_a_wrong_parameter_is_blamed_on_the_attribute_of_the_call(tmp_path: Path) -> None:
    body = '<xacro:macro name="m" params="a"/>\n<xacro:m a="1" b="2"/>'
    assert problem_at(tmp_path, body) == ("r.xacro:3:19 2", [])


def test_a_problem_in_a_default_is_blamed_on_the_call_that_needs_it(tmp_path: Path) -> None:
    assert problem_at(tmp_path, '<xacro:macro name="m" params="a:=${x}"/>\n<xacro:m/>')[0] == "r.xacro:3:1 <xacro:m/>"


def test_a_problem_in_a_text_is_blamed_on_its_element(tmp_path: Path) -> None:
    assert problem_at(tmp_path, "<a>\n  ${x}\n</a>")[0] == "r.xacro:2:1 <a>"


def test_a_problem_in_a_block_is_blamed_on_who_wrote_it(tmp_path: Path) -> None:
    body = """<xacro:macro name="m" params="*o"><xacro:insert_block name="o"/></xacro:macro>
<xacro:m><o a="${x}"/></xacro:m>"""
    assert problem_at(tmp_path, body) == ("r.xacro:3:16 ${x}", [])
