"""Each request of an editor is answered once: what is wrong with an error, and only about files that it shows."""

from __future__ import annotations

import copy
import json
import os
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
from folder import Folder
from raw_editor import (
    ARM,
    INVALID_PARAMS,
    REQUESTS,
    Shared,
    asked,
    assert_well,
    code_of,
    names_in,
    raw_editor,
    shared_server,
    ws,
)

COMMANDS = [f"urdfctl.{name}" for name in ("graph", "view", "smoke", "moveit", "migrate", "chooseVariant")]
TOO_FAR = (-1, 2**31, 10**30)
WRONG: list[object] = [None, 1.5, *TOO_FAR, "a text", True, [], {}, [None], {"uri": 1}]


@pytest.fixture(scope="module")
def shared(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Shared]:
    with shared_server(tmp_path_factory.mktemp("shared")) as server:
        yield server


def places(value: object) -> Iterator[tuple[object, ...]]:
    """Yield the paths to all parts of some JSON."""
    yield ()
    parts = value.items() if isinstance(value, dict) else enumerate(value) if isinstance(value, list) else ()
    for key, part in parts:
        yield from ((key, *rest) for rest in places(part))


def with_other(value: Any, place: tuple[object, ...], other: object) -> Any:
    """Return some JSON in which one part is another."""
    if not place:
        return other
    changed = copy.copy(value)
    changed[place[0]] = with_other(changed[place[0]], place[1:], other)
    return changed


def without(value: Any, place: tuple[object, ...]) -> Any:
    """Return some JSON in which one part is missing."""
    changed = copy.copy(value)
    if len(place) > 1:
        changed[place[0]] = without(changed[place[0]], place[1:])
    else:
        del changed[place[0]]
    return changed


@pytest.mark.parametrize("method", REQUESTS)
def test_each_wrong_parameter_of_a_request_is_answered_with_an_error(shared: Shared, method: str) -> None:
    valid = asked(method, shared.uri)
    cases = [without(valid, place) for place in places(valid) if place]
    kinds = {place: type(part_of(valid, place)) for place in places(valid)}
    cases += [
        with_other(valid, place, other)
        for place, kind in kinds.items()
        for other in WRONG
        if type(other) is not kind or (kind is int and other in TOO_FAR)
    ]
    editor = shared.editor
    assert code_of(editor.ask(method, valid)) is None
    identities = [editor.begin(method, params) for params in cases]
    codes = [code_of(editor.answer(identity)) for identity in identities]
    wrong = [params for params, code in zip(cases, codes, strict=True) if code != INVALID_PARAMS]
    assert wrong == []
    assert_well(editor)


def part_of(value: Any, place: tuple[object, ...]) -> Any:
    """Return a part of some JSON."""
    return part_of(value[place[0]], place[1:]) if place else value


@pytest.mark.parametrize("method", REQUESTS)
def test_a_place_after_the_end_of_a_line_or_of_the_text_is_no_error(shared: Shared, method: str) -> None:
    far = [{"line": line, "character": sign} for line in (1, 5, 2**31 - 1) for sign in (0, 2**31 - 1)]
    editor = shared.editor
    for at in far:
        params = asked(method, shared.uri)
        params |= {key: at if key == "position" else {"start": at, "end": at} for key in params if key in PLACES}
        assert code_of(editor.ask(method, params)) in {None, INVALID_PARAMS if method.endswith("ename") else None}
    assert_well(editor)


PLACES = {"position", "range"}


def uris_of_no_file(folder: Path) -> dict[str, str]:
    """URIs that are well-formed, and name nothing that an editor may ask about."""
    (folder / "ws/inside").mkdir()
    (folder / "ws/out").symlink_to(folder / "out")
    (folder / "ws/link.urdf").symlink_to(folder / "out/secret.urdf")
    ws = (folder / "ws").as_uri()
    found = {
        "a folder": f"{ws}/inside",
        "the workspace": ws,
        "a missing file": f"{ws}/missing.urdf",
        "a file below a file": f"{ws}/arm.urdf/arm.urdf",
        "a file elsewhere": (folder / "out/secret.urdf").as_uri(),
        "a file above": f"{ws}/../out/secret.urdf",
        "an escaped file above": f"{ws}/%2e%2e/out%2Fsecret.urdf",
        "a link to a file elsewhere": f"{ws}/link.urdf",
        "a file in a link to a folder elsewhere": f"{ws}/out/secret.urdf",
        "a device": "file:///dev/zero",
        "a file of the system": "file:///proc/self/mem",
        "a share": "file://server/share/arm.urdf",
        "a share without a host": "file:////server/share/arm.urdf",
        "a long name": f"{ws}/{'a' * 300}.urdf",
        "a long path": f"{ws}/{'a/' * 5000}arm.urdf",
        "a loop": f"{ws}/loop/arm.urdf",
        "an unnamed text": "untitled:Untitled-1",
        "a revision": f"git:{folder}/ws/arm.urdf?HEAD",
        "another machine": f"vscode-remote://ssh{folder}/ws/arm.urdf",
        "a page": "http://127.0.0.1:1/arm.urdf",
        "bytes that are not UTF-8": f"{ws}/%ff.urdf",
    }
    (folder / "ws/loop").symlink_to(folder / "ws/loop")
    if hasattr(os, "mkfifo"):
        os.mkfifo(folder / "ws/pipe.urdf")
        found["a pipe"] = f"{ws}/pipe.urdf"
    return found


@pytest.mark.skipif(sys.platform == "win32", reason="links, pipes and devices are those of POSIX")
def test_nothing_is_told_about_what_is_not_a_file_of_the_workspace(folder: Folder) -> None:
    here = ws(folder)
    uris = uris_of_no_file(here.parent)
    with raw_editor() as editor:
        editor.start(here)
        editor.linted()
        for name, uri in uris.items():
            for method in REQUESTS:
                assert editor.ask(method, asked(method, uri)).get("result", "") is None, f"{method} of {name}"
            variants = editor.ask("urdfctl/variants", {"uri": uri})
            assert variants.get("result", variants["error"]["code"] if "error" in variants else 0) in (
                [],
                INVALID_PARAMS,
            )
            for command in COMMANDS:
                answer = editor.ask("workspace/executeCommand", {"command": command, "arguments": [uri, "jazzy"]})
                assert answer.get("result") is None, f"{command} of {name}"
        assert_well(editor)
        assert "hidden_link" not in json.dumps([editor.answers, editor.said], default=str)


BROKEN = ["", "arm.urdf", "file:", "file://", "file:arm.urdf", "file:///%00", "file:///a%00.urdf", "file://[", "\ud800"]
BROKEN += ["file:///\ud83d.urdf", "file:///a\nb.urdf", "file://[::1", "::", "file:///\x00", "file:%2fetc%2fpasswd\x00"]


@pytest.mark.parametrize("uri", BROKEN)
def test_what_is_not_a_uri_of_a_file_is_refused_or_no_file(shared: Shared, uri: str) -> None:
    editor = shared.editor
    editor.open(uri, ARM)
    change = {"textDocument": {"uri": uri, "version": 2}, "contentChanges": [{"text": ARM}]}
    editor.tell("textDocument/didChange", change)
    editor.tell("workspace/didChangeWatchedFiles", {"changes": [{"uri": uri, "type": 2}]})
    for method in REQUESTS:
        answer = editor.ask(method, asked(method, uri))
        assert code_of(answer) == INVALID_PARAMS or answer["result"] is None
    for command in COMMANDS:
        assert code_of(editor.ask("workspace/executeCommand", {"command": command, "arguments": [uri]}))
    editor.tell("textDocument/didClose", {"textDocument": {"uri": uri}})
    assert code_of(editor.ask("textDocument/hover", asked("textDocument/hover", "file:///%00"))) == INVALID_PARAMS
    assert_well(editor)


@pytest.mark.parametrize(
    "params",
    [
        *({"command": command, "arguments": [one]} for command in COMMANDS for one in (None, 1, [], {}, True)),
        {"command": "urdfctl.explain"},
        {"command": "urdfctl.explain", "arguments": []},
        {"command": "urdfctl.explain", "arguments": ["UC201", "UC202"]},
        {"command": "urdfctl.explain", "arguments": [{}]},
        {"command": "urdfctl.explain", "arguments": ["UC999"]},
        {"command": "urdfctl.none", "arguments": []},
        {"command": 1},
        {"command": "urdfctl.graph", "arguments": "file:///arm.urdf"},
        {},
        [],
        None,
    ],
    ids=str,
)
def test_a_command_that_cannot_be_understood_is_an_error(shared: Shared, params: object) -> None:
    editor = shared.editor
    assert code_of(editor.ask("workspace/executeCommand", params)) == INVALID_PARAMS
    assert_well(editor)


def test_a_request_for_variants_without_a_uri_is_an_error(shared: Shared) -> None:
    editor = shared.editor
    for params in (None, [], {}, {"uri": 1}, {"type_name": 1}, {"uri": "file:///%00"}, "file:///arm.urdf"):
        assert code_of(editor.ask("urdfctl/variants", params)) == INVALID_PARAMS
    assert_well(editor)


def test_an_open_text_is_answered_wherever_its_file_is_until_it_is_closed(folder: Folder) -> None:
    here = ws(folder)
    secret = (here.parent / "out/secret.urdf").as_uri()
    with raw_editor() as editor:
        editor.start(here)
        editor.open(secret, ARM.replace("base", "typed_link"))
        editor.linted(changes=1)
        assert "typed_link" in names_in(editor, secret)
        editor.tell("textDocument/didClose", {"textDocument": {"uri": secret}})
        closed = editor.ask("textDocument/documentSymbol", asked("textDocument/documentSymbol", secret))
        assert closed["result"] is None
        assert_well(editor)


INCLUDING = """<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">
  <xacro:include filename="FILE"/><link name="tip"/>
  <joint name="j" type="fixed"><parent link="base"/><child link="tip"/></joint>
</robot>
"""


def test_an_open_text_outside_of_the_folders_includes_nothing_from_outside_of_its_own(folder: Folder) -> None:
    here = ws(folder)
    folder.write({"out/base.urdf": ARM, "alone/.git/HEAD": "", "alone/beside.xacro": ARM})
    alone = here.parent / "alone/robot.xacro"
    alone.write_text("<robot/>", encoding="utf-8")
    found = {}
    with raw_editor() as editor:
        editor.start(here)
        included_files = ("beside.xacro", "../out/base.urdf", str(here.parent / "out/base.urdf"))
        for number, included in enumerate(included_files, start=1):
            editor.open(alone.as_uri(), INCLUDING.replace("FILE", included))
            editor.linted(changes=number)
            place = {"textDocument": {"uri": alone.as_uri()}, "position": {"line": 2, "character": 46}}
            found[included] = [one["uri"] for one in editor.ask("textDocument/definition", place)["result"]]
        assert_well(editor)
    assert [*found.values()] == [[(alone.parent / "beside.xacro").as_uri()], [], []]


def test_a_link_to_a_file_of_the_workspace_is_that_file(folder: Folder) -> None:
    here = ws(folder)
    (here / "same.urdf").symlink_to(here / "arm.urdf")
    with raw_editor() as editor:
        editor.start(here)
        for name in ("arm.urdf", "same.urdf"):
            answer = editor.ask("textDocument/hover", asked("textDocument/hover", (here / name).as_uri()))
            assert "base" in json.dumps(answer["result"])
        assert_well(editor)


def test_the_name_of_an_argument_is_no_option_of_the_smoke_test(folder: Folder) -> None:
    here = ws(folder)
    config = '[[robot]]\npath = "arm.urdf"\nargs = { "--report=REPORT" = "x" }\n'
    folder.write({"ws/urdfctl.toml": config.replace("REPORT", str(here.parent / "out/report.html"))})
    with raw_editor() as editor:
        editor.start(here)
        editor.linted()
        params = {"command": "urdfctl.smoke", "arguments": [(here / "arm.urdf").as_uri()]}
        assert editor.ask("workspace/executeCommand", params)["result"]["summary"].startswith("there are no")
        assert_well(editor)
    assert os.listdir(here.parent / "out") == ["secret.urdf"]
