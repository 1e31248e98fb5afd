"""The texts of an editor are changed as the protocol says, and are those of their files."""

from __future__ import annotations

import os

import pytest
from folder import Folder
from raw_editor import ARM, Message, assert_well, names_in, raw_editor, ws


def change(start: tuple[int, int], end: tuple[int, int], text: str) -> Message:
    both = {name: {"line": line, "character": sign} for name, (line, sign) in (("start", start), ("end", end))}
    return {"range": both, "text": text}


END = 2**31 - 1


@pytest.mark.parametrize(
    ("before", "changes", "after"),
    [
        ("ab", [change((0, END), (0, END), "c")], "abc"),
        ("ab\ncd", [change((0, END), (0, END), "x")], "abx\ncd"),
        ("ab\ncd", [change((9, 9), (END, END), "x")], "ab\ncdx"),
        ("ab\n", [change((1, 5), (7, 0), "x")], "ab\nx"),
        ("", [change((3, 3), (4, 4), "x")], "x"),
        ("abcd", [change((0, 3), (0, 1), "x")], "axd"),
        ("a\x0cb\u2028c\x85d\ne", [change((1, 0), (1, 1), "x")], "a\x0cb\u2028c\x85d\nx"),
        ("a\rb\r\nc\n", [change((2, 0), (2, 1), "x")], "a\rb\r\nx\n"),
        ("a🤖b", [change((0, 3), (0, 4), "x")], "a🤖x"),
        ("a🤖b", [change((0, 1), (0, 3), "x")], "axb"),
        ("a🤖b", [change((0, 2), (0, 3), "\udd17")], "a🤗b"),
        ("a", [change((0, 1), (0, 1), "\ud83e"), change((0, 2), (0, 2), "\udd16")], "a🤖"),
        ("a", [{"text": "b"}, change((0, 0), (0, 1), "c")], "c"),
    ],
)
def test_a_text_is_changed_as_the_protocol_says(
    folder: Folder, before: str, changes: list[Message], after: str
) -> None:
    from lsprotocol import types
    from pygls.protocol import default_converter
    from pygls.workspace import PositionCodec

    from urdfctl.server.protocol.positions import Units
    from urdfctl.server.protocol.texts import changed

    converter = default_converter()
    params = {"textDocument": {"uri": "a", "version": 2}, "contentChanges": changes}
    made = converter.structure(params, types.DidChangeTextDocumentParams)
    assert changed(before, made.content_changes, Units(PositionCodec())) == after


def test_a_change_of_one_line_among_unusual_line_ends_gives_the_findings_of_the_whole_text(folder: Folder) -> None:
    here = ws(folder)
    uri = (here / "arm.urdf").as_uri()
    text = ARM.replace("<link", "<!-- \u2028 \x85 --><link", 1)
    with raw_editor() as editor:
        editor.start(here)
        editor.open(uri, text)
        params = {"textDocument": {"uri": uri, "version": 2}}
        editor.tell("textDocument/didChange", {**params, "contentChanges": [change((2, 14), (2, 18), "tip")]})
        editor.linted(changes=2)
        assert names_in(editor, uri) == ["base", "tip", "elbow"]
        assert_well(editor)


def test_a_file_that_is_open_by_two_names_stays_open_until_both_are_closed(folder: Folder) -> None:
    here = ws(folder)
    (here / "same.urdf").symlink_to(here / "arm.urdf")
    both = [(here / name).as_uri() for name in ("arm.urdf", "same.urdf")]

    with raw_editor() as editor:
        editor.start(here)
        for uri in both:
            editor.open(uri, ARM.replace("base", "typed_link"))
        editor.open(both[1], ARM.replace("base", "typed_again"))
        editor.linted(changes=3)
        assert "typed_again" in names_in(editor, both[0])
        editor.tell("textDocument/didClose", {"textDocument": {"uri": both[1]}})
        editor.linted(changes=4)
        assert "typed_link" in names_in(editor, both[0])
        editor.tell("textDocument/didClose", {"textDocument": {"uri": both[0]}})
        editor.linted(changes=5)
        assert "base" in names_in(editor, both[0])
        assert_well(editor)


def test_a_file_whose_name_is_not_utf_8_has_its_findings_and_hides_no_others(folder: Folder) -> None:
    here = ws(folder)
    faulty = ARM.replace('"fore"/></joint>', '"four"/></joint>')
    name = os.fsdecode(b"a\xff.urdf")
    try:
        (here / name).write_text(faulty, encoding="utf-8")
    except OSError:
        pytest.skip("this file system has only names in UTF-8")
    (here / "zzz.urdf").write_text(faulty, encoding="utf-8")
    with raw_editor() as editor:
        editor.start(here)
        editor.linted()
        told = [one["params"] for one in editor.said if one["method"] == "textDocument/publishDiagnostics"]
        assert {one["uri"] for one in told if one["diagnostics"]} == {
            f"{here.as_uri()}/{end}" for end in ("a%FF.urdf", "zzz.urdf")
        }
        uri = f"{here.as_uri()}/a%ff.urdf"
        assert "fore" in names_in(editor, uri)
        assert_well(editor)
