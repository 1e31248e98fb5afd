"""A robot with controllers: a second process loads what judges controllers while the first one expands the robot.

It is a worker with the limits of any other. From the first worker it gets the project, pickled, and tells its findings
as JSON. What it does not live to tell, the first one finds for itself.
"""

from __future__ import annotations

import os
import signal
import sys
from collections.abc import Callable, Sequence

from urdfctl.hints import Any
from urdfctl.lint import Outcome, Selection
from urdfctl.model.project import Project
from urdfctl.rules import FAMILIES
from urdfctl.sharing.part import Part
from urdfctl.source.span import SourceSpan, SourceText
from urdfctl.source.suppressions import Suppressed
from urdfctl.worker import Limits, restrict, start_clock

if sys.platform == "win32":
    raise NotImplementedError

_ITS_OWN = tuple(number for number, family in enumerate(FAMILIES) if family.prefix in ("UC4", "UC7"))
_OTHERS = tuple(number for number in range(len(FAMILIES)) if number not in _ITS_OWN)


class Assistant:
    """The process, and the pipes to it and from it. They are there before it is, for the first worker to know them."""

    def __init__(self, limits: Limits) -> None:
        self._limits = limits
        waiting, self.asking = os.pipe()
        self.hearing, telling = os.pipe()
        self._of_answering: tuple[int, ...] = (waiting, telling)
        self.pid: int | None = None

    def start(self) -> None:
        """Let it get ready and wait for a project; where none can be made, who asks hears of nobody."""
        try:
            self.pid = os.fork()
        except OSError:
            self.leave_answering()
            return
        if self.pid == 0:  # pragma: no cover (in the other process; `assist` is tested here)
            try:
                self.leave_asking()
                restrict(self._limits)
                start_clock(self._limits)
                assist(*self._of_answering)
            finally:
                os._exit(0)
        self.leave_answering()

    def leave_asking(self) -> None:
        """Close the ends of who asks: a pipe comes to its end when nobody else holds it open."""
        os.close(self.asking)
        os.close(self.hearing)

    def leave_answering(self) -> None:
        """Close the ends of who answers, if that is not done."""
        for end in self._of_answering:
            os.close(end)
        self._of_answering = ()

    def dismiss(self) -> None:
        """End it, whatever it does."""
        if self.pid is not None:
            os.kill(self.pid, signal.SIGKILL)
            os.waitpid(self.pid, 0)
        self.leave_answering()
        self.leave_asking()


def assist(waiting: int, telling: int) -> None:
    """Get ready; then judge the controllers of the project that comes, and tell of it."""
    from _pickle import loads

    get_ready()
    with os.fdopen(waiting, "rb") as asked, os.fdopen(telling, "wb") as answer:
        size = int(asked.readline())
        project, sources, selection = loads(asked.read(size))
        part = Part(project, Suppressed(sources), selection)
        part.work(_ITS_OWN)
        answer.write(part.told())


def get_ready() -> None:
    """Load what will be needed."""
    import urdfctl.pairing  # noqa: F401
    from urdfctl.catalog.store import prepare

    for number in _ITS_OWN:
        FAMILIES[number].load()
    prepare()


def lint_assisted(
    assistant: Assistant,
    project: Project,
    sources: Sequence[SourceText],
    selection: Selection,
    reached: Callable[[SourceSpan], bool],
) -> Outcome:
    """What `lint` gives, with an assistant's help."""
    assistant.leave_answering()
    part = Part(project, Suppressed(list(sources)), selection)
    asked = _ask(assistant, (project, list(sources), selection))
    part.work(_OTHERS)
    if asked:
        with os.fdopen(assistant.hearing, "rb", closefd=False) as answer:
            part.learn(answer.read())
    part.work_on_what_is_left()
    return part.outcome(reached)


def _ask(assistant: Assistant, what: Any) -> bool:
    """Whether the assistant could be told what to do: it may be gone, and a tree may be too deep to be pickled."""
    from _pickle import dumps

    try:
        text = dumps(what, 5)
        with os.fdopen(assistant.asking, "wb", closefd=False) as asking:
            asking.write(b"%d\n%b" % (len(text), text))
    except (RecursionError, OSError):
        return False
    return True
