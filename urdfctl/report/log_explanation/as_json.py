"""The JSON explanation of a log's messages."""

from __future__ import annotations

import json
from typing import Any

from urdfctl import __version__
from urdfctl.logs.digest import Digest, KnownMessage, Unknown
from urdfctl.logs.evidence import CheckedFolder, FoundCause
from urdfctl.report.log_explanation.next_commands import next_commands
from urdfctl.rules import fault_of


def render_log_json(digest: Digest, *, complete: bool, files: CheckedFolder | None = None) -> str:
    """Return the explanation as JSON, version 1.

    complete: whether the whole log was read. files: the folder in which the causes were searched.
    """
    plain = {
        "version": 1,
        "tool": {"name": "urdfctl", "version": __version__},
        "lines": digest.lines,
        "complete": complete,
        "distro": digest.distro or None,
        "folder": files._asdict() if files else None,
        "messages": [_message(known) for known in digest.known],
        "unknown": [_unknown(unknown) for unknown in digest.unknown],
        "next": [command.text for command in next_commands(digest.known, files)],
    }
    return json.dumps(plain, indent=1, ensure_ascii=True) + "\n"


def _message(known: KnownMessage) -> dict[str, Any]:
    message, reading = known.message, known.reading
    return {
        "id": message.id,
        "kind": known.kind,
        "line": known.line,
        "count": known.times,
        "text": known.text,
        "values": list(known.values),
        "printed_by": message.by,
        "distros": list(message.distros),
        "settled_in_line": known.settled or None,
        "meaning": reading.meaning,
        "causes": [
            {
                "cause": cause.text,
                "rules": [{"code": code, "name": fault_of(code).name} for code in cause.rules],
                "found": [_found(place) for place in cause.found],
            }
            for cause in reading.causes
        ],
        "fix": reading.best_fix,
        "authority": message.authority,
    }


def _unknown(unknown: Unknown) -> dict[str, Any]:
    nearest = unknown.nearest
    return {
        "line": unknown.line,
        "count": unknown.times,
        "text": unknown.text,
        "level": unknown.level or None,
        "nearest": {"id": nearest.message.id, "text": nearest.pattern.shown} if nearest else None,
    }


def _found(found: FoundCause) -> dict[str, object]:
    return {**found._asdict(), "related": [place._asdict() for place in found.related]}
