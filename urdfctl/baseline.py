"""The findings that a project has known for long: a file of them, which hides them until they are mended."""

from __future__ import annotations

import json
import os
from collections import Counter
from collections.abc import Callable, Iterable, Sequence

from urdfctl.diagnostic import Diagnostic
from urdfctl.errors import UserError
from urdfctl.fingerprint import mark, message_from, path_from
from urdfctl.hints import Any
from urdfctl.record import NamedTuple
from urdfctl.source.files import first_bytes

_VERSION = 1
_OURS = "UC000"
_MOST_BYTES = 64 << 20
_TEXTS = ("code", "file", "message", "mark")


class Known(NamedTuple):
    """A finding as the file has it, and how many times; its path counts from the folder of the file."""

    code: str
    file: str
    message: str
    mark: str
    times: int


class Compared(NamedTuple):
    """The findings that are new, how many are known, and those of the file that are gone, as often as they are."""

    new: list[Diagnostic]
    known: int
    gone: list[Known]


def read_baseline(path: str) -> list[Known]:
    """What a file knows. UserError where it is none."""
    try:
        text = first_bytes(path, _MOST_BYTES + 1)
    except FileNotFoundError:
        raise UserError(f"no such file: '{path}'; --write-baseline {path} makes it") from None
    except OSError as error:
        raise UserError(f"'{path}' cannot be read: {error.strerror}") from None
    if len(text) > _MOST_BYTES:
        raise UserError(f"'{path}' is no baseline: larger than {_MOST_BYTES >> 20} MiB")
    try:
        whole = json.loads(text)
    except (ValueError, RecursionError) as error:
        raise UserError(f"'{path}' is no baseline: no good JSON: {error}") from None
    version = whole.get("version") if isinstance(whole, dict) else None
    if version != _VERSION or not isinstance(whole.get("findings"), list):
        told = f"its version is {version}, not {_VERSION}" if isinstance(version, int) else "it holds something else"
        raise UserError(f"'{path}' is no baseline that this urdfctl reads: {told}")
    return [_known(entry, number, path) for number, entry in enumerate(whole["findings"], 1)]


def _known(entry: Any, number: int, path: str) -> Known:
    sound = isinstance(entry, dict) and all(isinstance(entry.get(name), str) for name in _TEXTS)
    times = entry.get("times", 1) if sound else 0
    if type(times) is not int or times < 1:
        raise UserError(f"'{path}' is no baseline: its finding {number} lacks a part, or has one that is no good")
    return Known(entry["code"], entry["file"], entry["message"], entry["mark"], times)


def written(findings: Iterable[Diagnostic], path: str) -> str:
    """The file at a path that knows some findings; our own faults are not to be known."""
    folder = _folder(path)
    counts: Counter[Known] = Counter()
    for one in findings:
        if one.code != _OURS:
            inside = path_from(one.at.file, folder)
            counts[Known(one.code, inside, message_from(one, folder), mark(one, folder), 0)] += 1
    entries = [known._replace(times=count)._asdict() for known, count in sorted(counts.items(), key=_by_file)]
    lines = ",\n".join(f"  {json.dumps(entry)}" for entry in entries)
    return f'{{"version": {_VERSION}, "tool": "urdfctl", "findings": [\n{lines}\n]}}\n'


def _by_file(counted: tuple[Known, int]) -> tuple[str, str, str, str]:
    known = counted[0]
    return known.file, known.code, known.message, known.mark


def compared(
    findings: Sequence[Diagnostic], known: Iterable[Known], path: str, looked_at: Callable[[str, str], bool]
) -> Compared:
    """The findings held against what the file at a path knows. `looked_at` tells whether this run could have found what
    a rule, told by its code, says of a file."""
    folder = _folder(path)
    left: Counter[str] = Counter()
    entries = list(known)
    for entry in entries:
        left[entry.mark] += entry.times
    new: list[Diagnostic] = []
    for one in findings:
        its = mark(one, folder)
        if left[its] and one.code != _OURS:
            left[its] -= 1
        else:
            new.append(one)
    gone = []
    for entry in entries:
        times = min(left[entry.mark], entry.times)
        left[entry.mark] -= times
        if times and looked_at(entry.code, os.path.normpath(os.path.join(folder, entry.file))):
            gone.append(entry._replace(times=times))
    return Compared(new, len(findings) - len(new), gone)


def _folder(path: str) -> str:
    return os.path.dirname(os.path.abspath(path))
