"""Install the files of a package that its migrated launch files use and that lint does not find installed."""

from __future__ import annotations

import os
import re
from collections.abc import Callable, Iterator

from urdfctl.diagnostic import Diagnostic, Edit
from urdfctl.migrate.options import Part
from urdfctl.migrate.packages import Linted, MigratedPackages
from urdfctl.migrate.shared.install_rules import in_setup, install_rule
from urdfctl.migrate.step import EntryKind, Proposal, ReportEntry, Step
from urdfctl.source.disk.gate import is_file, is_folder
from urdfctl.source.span import SourceSpan, SourceText
from urdfctl.source.workspaces.packages import package_name

_CODE = "UC615"
_AUTHORITY = "ament_index_python get_package_share_directory(): only what install() lists is there"
_END = b"ament_package("


def installs_for_launch_files(lint: Callable[[], Linted], is_new: Callable[[Diagnostic], bool]) -> Step:
    """Return the step. lint, is_new: as in `fixes_of_lint`."""

    def propose(packages: MigratedPackages) -> Iterator[Proposal]:
        missing: dict[str, dict[str, None]] = {}
        for _, result in lint():
            for finding in result.outcome.diagnostics:
                if finding.code == _CODE and is_new(finding):
                    for build_file, name in _missing(finding):
                        missing.setdefault(build_file, {})[name] = None
        for build_file, names in missing.items():
            edit = _edit(packages.read(build_file), list(names))
            if edit is None:
                continue
            message = f"{', '.join(names)}: installed, because launch files use it"
            yield Proposal(
                (edit,), entries=(ReportEntry(EntryKind.DONE, message, file=build_file, authority=_AUTHORITY),)
            )

    return Step("installed-files", Part.MANIFEST, "Install rules for what launch files use", propose)


def _missing(finding: Diagnostic) -> Iterator[tuple[str, str]]:
    """Yield the build file, and the folder or the file in its folder that it does not install; for a setup.py the
    file."""
    manifest = next((note.at.file for note in finding.notes if note.at), "")
    named = re.match(r"'([^']+)'", finding.message)
    for name in ("CMakeLists.txt", "setup.py") if named and manifest else ():
        build_file = os.path.join(os.path.dirname(manifest), name)
        if named and is_file(build_file):
            yield build_file, named[1].partition("/")[0] if name == "CMakeLists.txt" else named[1]
            return


def _edit(source: SourceText, names: list[str]) -> Edit | None:
    folder = os.path.dirname(source.path)
    if os.path.basename(source.path) == "setup.py":
        package = package_name(os.path.join(folder, "package.xml"))
        return in_setup(source, package, names) if package else None
    return Edit(_end(source), _rules(folder, names))


def _end(source: SourceText) -> SourceSpan:
    """The place before `ament_package()`, which must be the last call, or the end of the file."""
    at = source.data.rfind(_END)
    at = source.data.rfind(b"\n", 0, at) + 1 if at >= 0 else len(source.data)
    return SourceSpan(source, at, at)


def _rules(folder: str, names: list[str]) -> str:
    folders = [name for name in names if is_folder(os.path.join(folder, name))]
    files = [name for name in names if name not in folders]
    rules = [install_rule(*folders)] if folders else []
    rules += [f"install(FILES {' '.join(files)}\n  DESTINATION share/${{PROJECT_NAME}}\n)\n"] if files else []
    return "".join(f"{rule}\n" for rule in rules)
