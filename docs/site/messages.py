"""Pages of the messages that `urdfctl explain` knows, each with the literal message as its title."""

from __future__ import annotations

from collections.abc import Iterator

from texts import Pages, front_matter, how_to_try, one_line, quoted

from urdfctl.catalog.distros import in_words
from urdfctl.catalog.log_messages import Cause, LogMessage, log_messages
from urdfctl.logs.printed import with_capitals
from urdfctl.rules import all_faults
from urdfctl.rules.prose import as_markdown


def message_pages() -> Pages:
    """Return a page for each message and the list of them, by path."""
    pages = {f"messages/{message.id}.md": "\n".join(_page(message)) for message in log_messages()}
    return {**pages, "messages/index.md": "\n".join(_index())}


def _page(message: LogMessage) -> Iterator[str]:
    title, *others = dict.fromkeys(map(with_capitals, message.patterns))
    said = message.meaning or " ".join(cause.text for cause in message.causes[:1]) or f"A message of {message.by}."
    yield front_matter(title, one_line(with_capitals(said)))
    yield f"# {quoted(title)}\n"
    yield f"Printed by {as_markdown(message.by)} ({in_words(message.distros)}). {_prose(message.meaning)}\n"
    if message.causes:
        yield "## Causes, most likely first\n"
        yield from (f"{number}. {_cause(cause)}" for number, cause in enumerate(message.causes, 1))
        yield ""
    if message.fix:
        yield f"## Solution\n\n{_prose(message.fix)}\n"
    if message.rules:
        yield "## Find it in your files\n"
        yield f"```sh\nurdfctl lint --select {','.join(message.rules)}\n```\n"
    yield "## In your log\n"
    yield "`urdfctl explain` reads one line or a whole log, and says which cause your files really have:\n"
    yield "```sh\nurdfctl explain robot.log --in src/my_robot\n```\n"
    yield how_to_try(f"messages/{message.id}.md")
    if others:
        yield "## Also printed as\n"
        yield from (f"- {quoted(other)}" for other in others)
        yield ""
    yield f"## Authority\n\n{as_markdown(message.authority)}"


def _cause(cause: Cause) -> str:
    names = {fault.code: fault.name for fault in all_faults()}
    links = ", ".join(f"[{code} {names[code]}](../rules/{code}.md)" for code in cause.rules)
    text = f"{_prose(cause.text)} ({links})" if links else _prose(cause.text)
    return f"{text}. {_prose(cause.fix)}" if cause.fix else text


def _prose(text: str) -> str:
    return as_markdown(with_capitals(text))


def _index() -> Iterator[str]:
    yield front_matter("Error messages of ROS, Gazebo and MoveIt", "What each message means, its causes, what to do")
    yield "# Error messages of ROS, Gazebo and MoveIt\n"
    yield "What each message means, what causes it, and what to do. Names in CAPITALS stand for those of your robot."
    by: dict[str, list[LogMessage]] = {}
    for message in log_messages():
        by.setdefault(message.by, []).append(message)
    for name, messages in sorted(by.items(), key=lambda item: item[0].lower()):
        yield f"\n## Printed by {as_markdown(name)}\n"
        yield from (f"- [{quoted(with_capitals(one.patterns[0]))}]({one.id}.md)" for one in messages)
