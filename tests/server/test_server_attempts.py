"""Items are tried out before they are offered: what causes a finding is left out, while there is time for it."""

from __future__ import annotations

import os
from collections import Counter
from collections.abc import Mapping

import pytest

pytest.importorskip("pygls", reason="pygls is not installed")

from folder import Folder

from urdfctl.diagnostic import Diagnostic, Location, Severity
from urdfctl.server.analysis.attempts import Attempts, harmless
from urdfctl.server.analysis.items import OfferedItem
from urdfctl.server.analysis.question import Question
from urdfctl.server.analysis.workspace import EditorSettings, Workspace
from urdfctl.server.features.completion import items_at
from urdfctl.source.span import SourceText

TEXT = "<a link='w'/>"
"""The place is after the letter w, which is the whole word."""
LEFT, RIGHT, TOP = (OfferedItem(name, "link", replaces=1) for name in ("left", "right", "top"))


def found(code: str, start: int = 0, end: int = 2) -> Diagnostic:
    return Diagnostic(code, "wrong", Severity.ERROR, "wrong", Location("f", 1, 1, 1, 1, start, end))


def kept(
    found_with: Mapping[str, list[Diagnostic] | None],
    *items: OfferedItem,
    saved: tuple[str, ...] = (),
    on_disk: bytes | None = None,
) -> list[OfferedItem]:
    """The items that are kept. found_with: what is found in a text that has a word; None if there is no time."""

    def lint(_: int, text: bytes, __: float) -> list[Diagnostic] | None:
        return next((found for word, found in found_with.items() if f"'{word}'".encode() in text), [])

    question = Question([], SourceText("f", TEXT.encode()), 1, TEXT.index("w") + 2)
    usual = Counter(("f", code) for code in saved)
    return harmless(question, items, Attempts(lint, 1, lambda _: usual, on_disk))


def test_an_item_that_causes_a_finding_is_left_out() -> None:
    assert kept({"right": [found("UC116")]}, LEFT, RIGHT, TOP) == [LEFT, TOP]


def test_what_comes_with_all_items_is_caused_by_what_is_around_the_place() -> None:
    unfinished = found("UC105")
    with_both = {"left": [unfinished], "right": [unfinished, found("UC116")], "top": [unfinished]}
    assert kept(with_both, LEFT, RIGHT, TOP) == [LEFT, TOP]


@pytest.mark.parametrize(("on_disk", "is_offered"), [(b"<a link='old'/>", False), (b"<b>\n<a link='old'/>", True)])
def test_what_comes_with_all_items_is_caused_by_them_if_all_other_lines_are_saved(
    on_disk: bytes, is_offered: bool
) -> None:
    with_both = {"left": [found("UC160")], "right": [found("UC160")]}
    assert kept(with_both, LEFT, RIGHT, on_disk=on_disk) == ([LEFT, RIGHT] if is_offered else [])


@pytest.mark.parametrize("saved", [("UC116",), ()])
def test_what_was_found_when_all_was_saved_is_not_new(saved: tuple[str, ...]) -> None:
    assert kept({"right": [found("UC116")]}, LEFT, RIGHT, saved=saved) == ([LEFT, RIGHT] if saved else [LEFT])


def test_a_finding_about_the_word_that_is_typed_excuses_none_about_the_item() -> None:
    at = TEXT.index("w")
    with_each = {"w": [found("UC116", at, at + 1)], "right": [found("UC116", at, at + 5)]}
    assert kept(with_each, LEFT, RIGHT) == [LEFT]


def test_an_item_is_kept_for_which_there_is_no_time_unless_it_is_doubtful() -> None:
    assert kept({"right": None}, LEFT, RIGHT, TOP._replace(is_doubtful=True)) == [LEFT, RIGHT]


def test_a_type_that_needs_parameters_is_offered_after_those_that_need_none() -> None:
    needy, plain = OfferedItem("pid", "type", replaces=1), OfferedItem("broadcaster", "type", replaces=1)
    assert kept({"pid": [found("UC431")]}, needy, plain) == [plain, needy]


ROBOT = """<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">
  <xacro:arg name="is_arm" default="false"/>
  <xacro:arg name="has_base" default="true"/>
  <link name="tip"/>
  <xacro:if value="$(arg |)"><link name="base"/></xacro:if>
  <joint name="j" type="fixed"><parent link="base"/><child link="tip"/></joint>
  <xacro:if value="$(arg is_arm)"><link name="no"/></xacro:if>
</robot>
"""


def test_an_argument_with_which_a_link_is_missing_is_left_out(folder: Folder) -> None:
    text = ROBOT.replace("|", "")
    folder.write({".git/HEAD": "", "r.urdf.xacro": ROBOT.replace("|", "has_base")})
    workspace, path = Workspace(str(folder.path), EditorSettings()), os.path.realpath(folder.path / "r.urdf.xacro")
    workspace.check()
    workspace.changed(path, text.encode())
    workspace.check()
    line = ROBOT[: ROBOT.index("|")].count("\n") + 1
    source = SourceText(path, text.encode())
    asked = Question(workspace.robots_with(path), source, line, ROBOT.splitlines()[line - 1].index("|") + 1)
    assert [item.text for item in items_at(asked)] == ["is_arm", "has_base"]
    assert [item.text for item in items_at(asked, workspace.attempts(path))] == ["has_base"]
