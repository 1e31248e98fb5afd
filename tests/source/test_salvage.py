"""A file that is not well-formed is read without its mistakes, to learn which files it names."""

from __future__ import annotations

import pytest

from urdfctl.source.span import SourceText
from urdfctl.source.xml.dom import Cloning, Element
from urdfctl.source.xml.salvage import salvaged


def elements(text: str) -> str | None:
    """What is read of a robot: `link(visual) joint`; None if nothing is."""
    document = salvaged(SourceText("robot.urdf", text.encode()), Cloning())
    root = document.documentElement if document else None
    return shape(root) if root is not None else None


def shape(element: Element) -> str:
    return " ".join(
        f"{one.tagName}({shape(one)})" if list(one.elements()) else one.tagName for one in element.elements()
    )


@pytest.mark.parametrize(
    ("body", "left"),
    [
        ('<arg name="sim" defaul\n<link name="a"/>', "link"),
        ('<link name=a><visual/></link><joint name="b"/>', "visual joint"),
        ('<link name="a" name="b"/><joint name="c"/>', "joint"),
        ('<link name="a"id="b"/><joint name="c"/>', "joint"),
        ('<link name="a"><visual></link><joint name="c"/>', "link joint"),
        ('<link name="a"><visual/></link></joint><joint name="c"/>', "link(visual) joint"),
        ('<link name="a & b"/><joint name="c"/>', "link joint"),
        ('<link name="a"/>&foot;<joint name="c"/>', "link joint"),
        ('<!-- a -- b --><joint name="c"/>', "joint"),
        ('<link name="a"><visual/><joint name="c"/>', "visual joint"),
        ('<link name="a"/><joint name="c"/></robot>and more <text', "link joint"),
    ],
    ids=[
        "a tag that does not end",
        "a value without quotes",
        "an attribute twice",
        "attributes without a blank",
        "an element without an end",
        "an end without a start",
        "a bare ampersand",
        "an unknown entity",
        "two dashes in a comment",
        "an outer element without an end",
        "text behind the root",
    ],
)
def test_all_is_read_but_what_is_not_well_formed(body: str, left: str) -> None:
    end = "" if "</robot>" in body else "</robot>"
    assert elements(f"<robot>{body}{end}") == left


def test_what_stands_behind_a_mistake_keeps_its_place() -> None:
    text = '<robot>\n  <arg name="sim" defaul\n  <link name="a"/>\n</robot>'
    source = SourceText("robot.urdf", text.encode())
    document = salvaged(source, Cloning())
    assert document is not None
    assert document.documentElement is not None
    (link,) = document.documentElement.elements()
    assert source.position(link.start).line == 3


def test_a_root_element_that_does_not_end_is_closed() -> None:
    assert elements('<robot><link name="a"/>') == "link"


@pytest.mark.parametrize(
    "text", ["", "<<<", "robot", "<model><link/>", "<robot name=x><link/></robot>", "<robot><a:b/>"]
)
def test_nothing_is_read_where_no_robot_is_left(text: str) -> None:
    assert elements(text) is None


def test_a_file_with_very_many_mistakes_is_given_up() -> None:
    assert elements("<robot>" + "<link name=a/>" * 500 + "</robot>") is None
