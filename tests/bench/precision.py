"""Write docs/precision.md: how much of what lint calls an error is true, in whole public repositories.

    python tests/bench/precision.py --trees DIR --verdicts FILE.yaml > docs/precision.md

DIR has a folder OWNER__NAME for each repository. The file lists `errors`, each with repo, code, file, line and verdict:
true, false, debatable or artefact (only because the copy lacks files), judged by people. The page has names, counts and
verdicts, nothing of the repositories' content. Lint runs in the root of each, without options, as a stranger would.
The section on other tools is that of rivals.py.
"""

from __future__ import annotations

import argparse
import json
import resource
import statistics
import subprocess
import sys
from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path
from typing import NamedTuple

import yaml
from rivals import section

_HEAD = """\
# Precision

What `urdfctl lint` says of whole public repositories: each is laid out as its users have it, and linted in its root
without options. People judged the errors: *true* (its team would mend it), *false* (it works), *debatable* (true to the
letter, but no error to a user). Errors that nobody has judged yet are counted as such. Only names, counts and verdicts
stand here.
This page is written by `python tests/bench/precision.py --trees DIR --verdicts FILE.yaml`.
"""
_COLUMNS = (
    "| repository | errors | true | false | debatable | not judged | warnings | s |\n|---|--:|--:|--:|--:|--:|--:|--:|"
)
Key = tuple[str, str, str, int]


class Judged(NamedTuple):
    """What lint says of a repository. seconds: of processor time."""

    name: str
    verdicts: Counter[str]
    warnings: int
    seconds: float

    @property
    def errors(self) -> int:
        """How many errors it reports."""
        return self.verdicts.total()


def main() -> int:
    """Print the page, and return the exit status."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--trees", type=Path, required=True)
    parser.add_argument("--verdicts", type=Path, required=True)
    options = parser.parse_args()
    known = verdicts_in(options.verdicts)
    folders = sorted(folder for folder in options.trees.iterdir() if folder.is_dir())
    sys.stdout.write(f"{page([judged(folder, known) for folder in folders])}\n{section()}")
    return 0


def verdicts_in(file: Path) -> dict[Key, str]:
    """Return the verdicts of a file by repository, code, file and line."""
    listed = yaml.safe_load(file.read_text("utf-8"))["errors"]
    return {(one["repo"], one["code"], one["file"], one["line"]): str(one["verdict"]).lower() for one in listed}


def judged(folder: Path, known: Mapping[Key, str]) -> Judged:
    """Lint a repository, and return what is known of its errors."""
    start = _seconds()
    command = [sys.executable, "-m", "urdfctl", "lint", "--format", "json", "--exit-zero", "--no-cache"]
    done = subprocess.run(command, cwd=folder, capture_output=True, text=True, check=False)
    findings = json.loads(done.stdout)["findings"] if done.stdout else []
    errors = [one for one in findings if one["severity"] == "error"]
    verdicts = Counter(known.get((folder.name, one["code"], one["file"], one["line"]), "not judged") for one in errors)
    return Judged(
        folder.name.replace("__", "/"),
        verdicts,
        sum(one["severity"] == "warning" for one in findings),
        _seconds() - start,
    )


def page(found: Sequence[Judged]) -> str:
    """Return the page as Markdown."""
    return "\n".join([_HEAD, _COLUMNS, *(_row(one) for one in found), "", *_summary(found), ""])


def _row(one: Judged) -> str:
    counts = (one.verdicts[key] for key in ("true", "false", "debatable", "not judged"))
    return f"| {one.name} | {one.errors} | {' | '.join(map(str, counts))} | {one.warnings} | {one.seconds:.1f} |"


def _summary(found: Sequence[Judged]) -> Iterator[str]:
    total: Counter[str] = sum((one.verdicts for one in found), Counter())
    told = total["true"] + total["false"] + total["debatable"]
    if told:
        share, wrong = total["true"] / told, total["false"] / told
        yield f"Of {told} errors that were judged {total['true']} are true ({share:.0%}) and"
        yield f"{total['false']} false ({wrong:.0%})."
    yield (
        f"The median repository has {statistics.median(one.warnings for one in found):.0f} warnings and takes "
        f"{statistics.median(one.seconds for one in found):.1f} s of processor time."
    )


def _seconds() -> float:
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


if __name__ == "__main__":
    raise SystemExit(main())
