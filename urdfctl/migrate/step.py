"""What a migration consists of: steps, and what they propose."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from enum import Enum
from typing import TYPE_CHECKING

from urdfctl.diagnostic import Edit
from urdfctl.fault import Example, Written, example_of
from urdfctl.migrate.options import Part
from urdfctl.source.span import Place
from urdfctl.startup.records import NamedTuple

if TYPE_CHECKING:
    from urdfctl.migrate.packages import MigratedPackages


class EntryKind(Enum):
    """The list of the report that an entry belongs to."""

    DONE = "done"
    DECIDED = "decided"
    FOR_YOU = "for you"


class ReportEntry(NamedTuple):
    """A line of the report.

    at: the place that it is about, as the step found it; None for a file that the step writes, or for the package.
    file: the file that it is about, if there is no place.
    authority: the upstream source that makes the change right.
    option: the option for the alternative, of a decision.
    """

    kind: EntryKind
    message: str
    at: Place | None = None
    file: str = ""
    authority: str = ""
    option: str = ""


class Proposal(NamedTuple):
    """A change that is made as a whole or not at all.

    edits: replacements in existing files.
    created: new files: path and text. A file that exists is replaced only if `deleted` names it too.
    deleted: files to delete.
    entries: the lines of the report about it. A proposal of entries alone changes nothing, but is reported.
    fixes: the codes of the findings that must be gone from the edited files for the target.
    moves: the links and joints whose kinematics it changes. The entries say how.
    """

    edits: tuple[Edit, ...] = ()
    created: tuple[tuple[str, str], ...] = ()
    deleted: tuple[str, ...] = ()
    entries: tuple[ReportEntry, ...] = ()
    fixes: tuple[str, ...] = ()
    moves: frozenset[str] = frozenset()

    @property
    def files(self) -> set[str]:
        """The files that it changes, creates or deletes."""
        return {*(edit.span.file for edit in self.edits), *(path for path, _ in self.created), *self.deleted}


class Row(NamedTuple):
    """A line of the table that `--list` prints.

    old, new: what is replaced, and by what; `new` is empty if it is dropped.
    since: the first distro that needs the new form; empty for every migration from ROS 1.
    authority: the upstream source.
    """

    old: str
    new: str
    since: str
    authority: str


class Step(NamedTuple):
    """One kind of change.

    name: in kebab case; the report and error messages name it.
    summary: a noun phrase for the table of changes.
    propose: yields what to change in the packages as they are now. It is called again after its proposals were applied,
        until it proposes no more changes; so a proposal must not be made again once it is applied.
    rows: what it replaces, for `--list` and docs/migrating.md.
    generation: 1 if it is only for packages that are for ROS 1, wholly or in part.
    is_needed: whether the target cannot read a file without it. What lint finds in the new form is then reported, and
        is no reason to keep the old one.
    before: the smallest packages that it changes, in the form of the examples of a rule: files by name, and under
        `options` the options of `urdfctl migrate`; `--to=jazzy` without. A package.xml that is not there is added.
    after: for each of these the files that are different then. One that is deleted is empty.
    """

    name: str
    part: Part
    summary: str
    propose: Callable[[MigratedPackages], Iterator[Proposal]]
    rows: tuple[Row, ...] = ()
    generation: int = 2
    is_needed: bool = False
    before: Sequence[Written] = ()
    after: Sequence[Mapping[str, str]] = ()

    @property
    def examples(self) -> list[tuple[Example, dict[str, str]]]:
        """The packages before, each with the files that are different after it."""
        options = ("--from=noetic", "--to=jazzy") if self.generation == 1 else ("--to=jazzy",)
        pairs = zip(self.before, self.after, strict=True)
        return [(example_of(before, options), example_of(after).files) for before, after in pairs]
