"""Take a line of a log apart, however it was pasted: colour remains, quotes of web pages, prefixes, joined lines."""

from __future__ import annotations

import re

from urdfctl.startup.records import NamedTuple

_MOST_PREFIXES = 12
"""Prefixes removed from a line."""
_QUOTES = str.maketrans("‘’‚‛`´′“”„‟″«»", "'''''''\"\"\"\"\"\"\"")  # noqa: RUF001 (web pages replace straight quotes)
_COLOUR = re.compile(
    r"(?:\^\[|\\(?:x1[bB]|033|e|u001[bB])|#033|\u241b)\[[\d;]*m"  # an escape character that was made visible
    r"|\[(?:0|1|[349]\d|10\d|0?\d(?:;\d{1,3})+)m(?![\],])"  # one that was lost
)
_LEVELS = {
    "error": "ERROR Error error Err FATAL Fatal fatal critical CRITICAL",
    "warning": "WARN WARNING Warning warning warn Wrn",
    "info": "INFO DEBUG Info Debug Msg Dbg info debug TRACE",
}
_LEVEL_OF = {word: level for level, words in _LEVELS.items() for word in words.split()}
_LEVEL = rf"\[\s*(?P<level>{'|'.join(_LEVEL_OF)})(?:\s+[\d.:]+)?\s*\]"
_PROCESS = r"(?:\d+:\ )?\[(?P<process>[A-Za-z][\w.+$()/\ -]*-\d+)\ *\]"
_PREFIX = re.compile(
    rf"""(?: {_PROCESS}:?                                              # [controller_manager-1], 2: [node-2]
          | {_LEVEL}:?                                                # [ERROR], [Err], [ERROR 1623.45]
          | \[[\d.,:/\ T+-]+\]:? | \[WallTime:[^\]]*\]:?              # [1623.45, 0.2]
          | \[[\w/.~-]+(?:\ [\d.]+)?\]: | \[/[\w/.-]+\] | \[[\w./-]+:\d+\]   # [controller_manager]:, [file.cc:12]
          | \(?\d{{4}}-\d\d-\d\d[T ][\d:.,]+Z?\)? | : )\s*""",
    re.VERBOSE,
)
PROCESS = re.compile(rf"{_PROCESS}:?\ ?", re.VERBOSE)
"""The name of a process, which a launch file puts before each line of its output."""
_INNER_PROCESS = re.compile(r"(?:^|(?<=\s))(?:\d+: )?\[[a-z][\w.+-]*-\d+\](?!:) ?")
_RECORD = re.compile(
    r"(?<=\s)(?=(?:\[[A-Za-z][\w.+$()/ -]*-\d+\] ?)?\[ *(?:ERROR|WARN|INFO|FATAL|DEBUG) *(?:[\d.]+ *)?\]:? ?\[)"
)
_RECORD_LEVELS = ("INFO", "WARN", "ERROR", "FATAL", "DEBUG")
_ERROR = re.compile(r"\b(?:ERROR|Error|FATAL)\b\s*:|what\(\):|\b[A-Z]\w+(?:Error|Exception)\b")
_WARNING = re.compile(r"\b(?:WARN|WARNING|Warning|warning|error)\b\s*:|\b[Ee]xception\b")


class LogLine(NamedTuple):
    """A record of a log.

    text: the record with its prefixes. level: "error", "warning", "info", or "" if it has none.
    process: the name that a launch file puts before the output of a process, such as spawner-3, or "".
    """

    text: str
    level: str = ""
    process: str = ""


def records(line: str) -> list[LogLine]:
    """Return the records in a line: usually one, several if lines were joined."""
    text = cleaned(line)
    levels = sum(map(text.count, _RECORD_LEVELS))
    return [_record(part) for part in (_joined(text) if levels > 1 else [text])]


def cleaned(line: str) -> str:
    """Return a line without the remains of colour codes, and with the quotes of programs instead of those of pages."""
    if "`" in line or not line.isascii():
        line = line.translate(_QUOTES)
    return _COLOUR.sub("", line) if "m" in line and "[" in line else line


def plain(line: str) -> str:
    """Return a line without the prefixes of its message: times, levels, names of nodes and files."""
    text = " ".join(line.split())
    return text[_behind_prefixes(text)[0] :]


def _joined(text: str) -> list[str]:
    """The parts of a line that each begin with prefixes."""
    parts, start = [], 0
    for record in _RECORD.finditer(text):
        part = text[start : record.start()].strip()
        if _behind_prefixes(part)[0] < len(part):
            parts.append(part)
            start = record.start()
    return [*parts, text[start:]]


def _record(text: str) -> LogLine:
    if "[" not in text:
        return LogLine(text, _spoken(text))
    text = text.strip()
    end, level, process = _behind_prefixes(text)
    if "[" in text[end:]:
        text = text[:end] + _INNER_PROCESS.sub("", text[end:])
    if process:
        text = PROCESS.sub("", text, count=1)
    return LogLine(text, level or _spoken(text), process)


def _behind_prefixes(text: str) -> tuple[int, str, str]:
    """The end of the prefixes of a text, and its level and process."""
    at, level, process = 0, "", ""
    for _ in range(_MOST_PREFIXES):
        prefix = _PREFIX.match(text, at)
        if prefix is None:
            break
        at = prefix.end()
        level = _LEVEL_OF[prefix["level"]] if prefix["level"] else level
        process = process or prefix["process"] or ""
    return at, level, process


def _spoken(text: str) -> str:
    """The level of a text without a level in brackets, from its words."""
    if _ERROR.search(text):
        return "error"
    return "warning" if _WARNING.search(text) else ""
