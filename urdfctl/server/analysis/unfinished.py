"""A line of YAML as it will be once it is finished: a list or a quote that is open at the place is closed there."""

from __future__ import annotations

import re

from urdfctl.server.analysis.question import Question
from urdfctl.source.disk.files import is_yaml
from urdfctl.source.span import SourceText

_CLOSERS = {"[": "]", "{": "}"}
_QUOTES = "\"'"


def finished(question: Question) -> Question:
    """Return the question with the text in which the line of the place is finished; the place stays the same."""
    if not is_yaml(question.file):
        return question
    line = question.source.line(question.line)
    closers = closers_of(line).encode()
    if not closers:
        return question
    word = re.match(r"[\w./-]*", line[question.column - 1 :])
    data, end = question.source.data, question.offset + len(word[0].encode() if word else b"")
    return question._replace(source=SourceText(question.file, data[:end] + closers + data[end:]))


def closers_of(line: str) -> str:
    """Return what closes a line of YAML: the quote, and the lists and maps in brackets, that it leaves open."""
    quote, closers = "", ""
    for index, letter in enumerate(line):
        if quote:
            quote = "" if letter == quote else quote
        elif letter == "#" and line[index - 1 : index].isspace():
            break
        elif letter in _QUOTES and not line[index - 1 : index].isalnum():
            quote = letter
        elif letter in _CLOSERS:
            closers = _CLOSERS[letter] + closers
        elif closers.startswith(letter):
            closers = closers[1:]
    return quote + closers
