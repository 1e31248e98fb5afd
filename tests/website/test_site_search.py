"""The search of the site: a line that was printed is searched for by the rare words of its message."""

from __future__ import annotations

import json
import subprocess
import sys
from functools import cache

import pytest
from folder import CHECKOUT
from pages import NODE, needs_node

sys.path.append(str(CHECKOUT / "docs" / "site"))

from messages import message_pages
from search import words_of_messages

SCRIPT = CHECKOUT / "docs" / "site" / "search" / "lines.mjs"
ASK = """
import {{ searcher }} from {script};
const {{ lines, messages }} = {data};
console.log(JSON.stringify(lines.map(searcher(messages))));
"""
PRINTED = {
    "[ERROR] [1699999999.123456, 12.3]: No p gain specified for pid.  Namespace: /gazebo_ros_control/pid_gains/j1": (
        "pid-gains-absent"
    ),
    "[ros2_control_node-1] [ERROR] [1712345678.9] [controller_manager]: Could not load controller 'arm_controller' "
    "because the type was not specified. Did you load the controller configuration yaml?": (
        "controller-type-not-specified"
    ),
    "[spawner-4] [FATAL] [1700.1] [spawner_head]: Failed loading controller head_controller": "spawner-failed",
}
AS_TYPED = ("UC201", "pid gains", "how do I lint a package in a GitHub workflow", "[1700.1] [node-3]: 17 of 20")


@cache
def searched(*lines: str) -> dict[str, str]:
    """Return what the page searches for in place of each line."""
    data = json.dumps({"lines": lines, "messages": words_of_messages()})
    script = ASK.format(script=json.dumps(SCRIPT.as_uri()), data=data)
    done = subprocess.run(
        [str(NODE), "--input-type=module", "-"], input=script, capture_output=True, text=True, check=True
    )
    return dict(zip(lines, json.loads(done.stdout), strict=True))


@needs_node
def test_the_words_of_a_printed_line_are_all_on_the_page_of_its_message() -> None:
    found = searched(*PRINTED, *AS_TYPED)
    pages = message_pages()
    for line, name in PRINTED.items():
        words = found[line].split()
        assert 1 < len(words) <= 6
        assert [word for word in words if word not in pages[f"messages/{name}.md"].lower()] == []


@needs_node
@pytest.mark.parametrize("line", AS_TYPED)
def test_what_is_no_message_is_searched_for_as_it_is_typed(line: str) -> None:
    assert searched(*PRINTED, *AS_TYPED)[line] == line


def test_pages_from_a_search_engine_say_where_to_try_and_how_to_install() -> None:
    page = message_pages()["messages/pid-gains-absent.md"]
    assert "](../playground/index.md)" in page
    assert "](../index.md#install)" in page
