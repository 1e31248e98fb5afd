"""A small arm to be linted with parts that are put into it."""

from __future__ import annotations

from pathlib import Path

from urdfctl.diagnostic import Diagnostic
from urdfctl.lint import Selection, joined
from urdfctl.load import Loader, Target
from urdfctl.rules.examples import completed
from urdfctl.settings import Settings


class Robot:
    """An arm of two joints, shoulder and elbow, in a folder of its own."""

    def __init__(self, folder: Path) -> None:
        self.folder = folder

    def lint(
        self, part: str, *, distro: str | None = None, simulator: str | None = None, name: str = "robot.urdf"
    ) -> list[Diagnostic]:
        path = self.folder / name
        whole = part if part.startswith("<robot") else completed(name, "PART\n").replace("PART", part)
        path.write_text(whole, encoding="utf-8")
        settings = Settings(distro=distro, simulator=simulator, workspace=str(self.folder))
        return joined([Loader(settings, Selection()).lint(Target(str(path))).outcome], Selection())

    def says(self, part: str, **options: str) -> list[str]:
        return [f"{found.severity.value} {found.code}" for found in self.lint(part, **options)]

    def only(self, code: str, part: str, **options: str) -> Diagnostic:
        [found] = [found for found in self.lint(part, **options) if found.code == code]
        return found

    def fixed(self, found: Diagnostic) -> str:
        """The excerpt of a finding with its fix's edits made in it."""
        assert found.fix is not None
        data = bytearray((self.folder / "robot.urdf").read_bytes())
        for edit in sorted(found.fix.edits, key=lambda edit: edit.start, reverse=True):
            data[edit.start : edit.end] = edit.text.encode()
        return data.decode().splitlines()[found.at.line - 1].strip()


def notes(found: Diagnostic) -> str:
    return "\n".join(note.message for note in found.notes)
