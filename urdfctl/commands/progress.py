"""A progress bar for long runs, on terminals only."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TypeVar

from urdfctl.output.printing import is_watched
from urdfctl.run.waiting import BAR_FROM

Result = TypeVar("Result")


def with_progress(results: Iterator[Result], total: int, doing: str = "linting") -> Iterator[Result]:
    """Yield the results; show a bar on standard error if that is a terminal and there are many."""
    if total < BAR_FROM or not is_watched():
        yield from results
        return
    from rich.console import Console
    from rich.progress import BarColumn, MofNCompleteColumn, Progress, TextColumn

    columns = TextColumn(doing), BarColumn(), MofNCompleteColumn()
    console = Console(stderr=True)
    # no refresh thread, because workers are forks; no redirection of what others print
    with Progress(
        *columns, console=console, transient=True, auto_refresh=False, redirect_stdout=False, redirect_stderr=False
    ) as bar:
        task = bar.add_task("", total=total)
        for result in results:
            bar.advance(task)
            bar.refresh()
            yield result
