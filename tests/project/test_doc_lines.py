"""Every command line of README.md and docs/ can be pasted, and prints what the page shows."""

from __future__ import annotations

from pathlib import Path

import pytest
from doc_lines import Line, copied_samples, lines_of, pages, printed_by, steady
from folder import CHECKOUT


def _name(page: Path) -> str:
    return page.relative_to(CHECKOUT).as_posix()


@pytest.mark.parametrize("page", pages(), ids=_name)
def test_every_command_line_of_a_page_runs_and_prints_what_the_page_shows(page: Path) -> None:
    lines = [line for line in lines_of(page) if line.why_not is None]
    with copied_samples() as root:
        for line in lines:
            status, printed = printed_by(line, root)
            assert status == line.status, f"{line.text}\n{printed}"
            if line.output is not None:
                assert steady(printed) == steady(line.output), f"{line.text}: python tests/helpers/doc_lines.py"


@pytest.mark.parametrize("page", pages(), ids=_name)
def test_what_is_not_run_says_why(page: Path) -> None:
    reasons = [line.why_not for line in lines_of(page) if line.why_not is not None]
    assert all(len(reason.split()) > 1 for reason in reasons)


def test_a_page_is_read_with_its_comments(tmp_path: Path) -> None:
    page = tmp_path / "page.md"
    page.write_text(
        "```\nurdfctl lint   what is wrong\n```\n"
        "<!-- in samples -->\n<!-- status 1 -->\n```\n$ urdfctl show\nnothing\n```\n"
        "<!-- not run: it needs ROS -->\n```\nros2 run a b\n```\n```yaml\na: 1\n```\n"
    )
    assert list(lines_of(page)) == [
        Line("urdfctl lint", None, Path("samples/picker"), 0, None),
        Line("urdfctl show", "nothing\n", Path("samples"), 1, None),
        Line("ros2 run a b", None, Path("samples"), 0, "it needs ROS"),
    ]
