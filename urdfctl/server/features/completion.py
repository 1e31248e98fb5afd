"""What can be written at a place: names that exist, types of this distro, parameters with a value of their type."""

from __future__ import annotations

from urdfctl.server.analysis.attempts import Attempts, harmless
from urdfctl.server.analysis.items import OfferedItem
from urdfctl.server.analysis.question import Question
from urdfctl.server.features.completion_xml import in_xml
from urdfctl.server.features.completion_yaml import in_yaml
from urdfctl.server.features.spawning import in_python
from urdfctl.source.disk.files import is_yaml


def items_at(question: Question, attempts: Attempts | None = None) -> list[OfferedItem]:
    """Return what can be written at a place, without repeats.

    attempts: lints the robots with each item; what causes a finding is left out.
    """
    if not question.robots:
        return []
    if question.file.endswith(".py"):
        found = in_python(question)
    else:
        found = in_yaml(question) if is_yaml(question.file) else in_xml(question)
    unique: dict[str, OfferedItem] = {}
    for item in found:
        unique.setdefault(item.text, item)
    items = list(unique.values())
    return harmless(question, items, attempts) if attempts else items
