"""The last step of a migration: the safe fixes of lint for what only the distro to migrate to objects to."""

from __future__ import annotations

from collections.abc import Callable, Iterator

from urdfctl.diagnostic import Diagnostic, Edit
from urdfctl.fix.trial import splices_of
from urdfctl.migrate.options import Part
from urdfctl.migrate.packages import Linted, MigratedPackages
from urdfctl.migrate.step import EntryKind, Proposal, ReportEntry, Step
from urdfctl.rules import fault_of
from urdfctl.source.span import Place, SourceSpan


def fixes_of_lint(lint: Callable[[], Linted], is_new: Callable[[Diagnostic], bool]) -> Step:
    """Return the step.

    lint: lints the packages as they are now for the distro to migrate to.
    is_new: returns whether a finding was none before the migration.
    """

    def propose(packages: MigratedPackages) -> Iterator[Proposal]:
        found = (finding for _, result in lint() for finding in result.outcome.diagnostics)
        wanted = (finding for finding in found if finding.fix and finding.fix.safe and is_new(finding))
        yield from {splices_of(finding): _proposal(packages, finding) for finding in wanted}.values()

    return Step("fixes-of-lint", Part.URDF, "What lint fixes", propose)


def _proposal(packages: MigratedPackages, finding: Diagnostic) -> Proposal:
    edits = tuple(
        Edit(SourceSpan(packages.read(splice.file), splice.start, splice.end), splice.text)
        for splice in splices_of(finding)
    )
    at = Place(packages.read(finding.at.file), finding.at.start, end=finding.at.end)
    message = f"fixed {finding.code}: {finding.message}"
    return Proposal(
        edits, entries=(ReportEntry(EntryKind.DONE, message, at, authority=fault_of(finding.code).authority),)
    )
