"""Changes to a file's bytes, such as hands, merges, editors and malice make them."""

from __future__ import annotations

import re
from collections.abc import Callable, Sequence
from random import Random

_TOKEN = re.compile(rb"[A-Za-z_][A-Za-z0-9_:./-]*|-?\d+(?:\.\d+)?|[<>\"'{}\[\]()=:,#$&*|!-]|\n *")

NASTY = [
    *[b"", b"\0", b"\xff\xfe", b"\xef\xbb\xbf", b"\r", b"\r\n", b"\t", b"\x1b[31m", b"\xed\xa0\x80", b"\xc2\x85"],
    *["\u2028".encode(), "\u202e".encode(), "ä".encode(), "🤖".encode(), b"\x0c", b"\x0b"],
    *[b"nan", b"inf", b"-inf", b"1e999", b"-0", b"1e-400", b"9" * 400, b"0x7f", b"1_000", b"0o17", b"1:30", b"~"],
    *[
        b"true",
        b"no",
        b"null",
        b"!!python/object:os.system",
        b"!!binary x",
        b"!degrees 90",
        b"!x",
        b"&a",
        b"*a",
        b"<<:",
    ],
    *[b"2001-01-01", b"2001-99-99", b"---", b"...", b"? ", b"- ", b"{", b"}", b"[", b"]", b"|", b">", b"%YAML 9.9"],
    *[
        b"<",
        b">",
        b"</",
        b"/>",
        b"<!--",
        b"-->",
        b"<![CDATA[",
        b"]]>",
        b"<?xml?>",
        b"&",
        b"&#0;",
        b"&#x110000;",
        b"&lt;",
    ],
    *[b"<!DOCTYPE r [<!ENTITY a 'b'>]>", b"xmlns:x=''", b"xmlns=''", b"xacro:", b"<xacro:if value='${", b"{}"],
    *[
        b"${",
        b"$(",
        b"$${",
        b"$(arg x)",
        b"$(find x)",
        b"$(env X)",
        b"$(eval 1)",
        b"${1/0}",
        b"${[]}",
        b"${{}}",
        b"${x}",
    ],
    *[b"$(var x)", b"$(find-pkg-share x)", b"$(command 'x')", b"$(dirname)", b"$(anon x)", b"${None}", b"${1,}"],
    *[
        b"${'a'*9}",
        b"${xacro.load_yaml('')}",
        b"${radians('x')}",
        b"${10**400}",
        b"${1e308*10}",
        b"'",
        b'"',
        b"\\",
        b"\\x",
    ],
    *[b"/", b"//", b"..", b"../..", b".", b"~", b"package://", b"package://x", b"file://", b"file:///", b"model://"],
    *[b"lambda: x", b"def f(): return f()", b"f'{x!r:{y}}'", b"*x", b"**x", b":=", b"%s", b"%(", b"{0.x[", b"x" * 5000],
    *[b"**/", b"[!", b"[a-", b"\\", b"[[", b"***", b"!", b"[z-a]"],
    *[b"${CMAKE_SOURCE_DIR}", b"${PROJECT_NAME}", b"#[[", b"]]", b"install(DIRECTORY"],
]


def by_bytes(data: bytes, random: Random, _others: Sequence[bytes]) -> bytes:
    """One byte is another."""
    at = random.randrange(len(data) + 1)
    return data[:at] + bytes([random.randrange(256)]) + data[at + 1 :]


def by_cutting(data: bytes, random: Random, _others: Sequence[bytes]) -> bytes:
    """A piece is gone."""
    start = random.randrange(len(data) + 1)
    return data[:start] + data[start + int(random.expovariate(0.03)) + 1 :]


def by_ending(data: bytes, random: Random, _others: Sequence[bytes]) -> bytes:
    """The rest is missing."""
    return data[: random.randrange(len(data) + 1)]


def by_doubling(data: bytes, random: Random, _others: Sequence[bytes]) -> bytes:
    """A piece stands there twice, or very often."""
    start = random.randrange(len(data) + 1)
    piece = data[start : start + int(random.expovariate(0.02)) + 1]
    return data[:start] + piece * random.choice([2, 2, 3, 200]) + data[start + len(piece) :]


def by_moving(data: bytes, random: Random, _others: Sequence[bytes]) -> bytes:
    """Lines change places."""
    lines = data.splitlines(keepends=True)
    for _ in range(random.randint(1, 3)):
        if len(lines) > 1:
            lines.insert(random.randrange(len(lines)), lines.pop(random.randrange(len(lines))))
    return b"".join(lines)


def by_nasty_words(data: bytes, random: Random, _others: Sequence[bytes]) -> bytes:
    """A word is a nasty one, or such a one is put in."""
    start, end = _token(data, random)
    return data[: random.choice([start, end])] + random.choice(NASTY) + data[end:]


def by_other_words(data: bytes, random: Random, others: Sequence[bytes]) -> bytes:
    """A word is another one of this file or of another."""
    start, end = _token(data, random)
    other = random.choice([data, *others])
    from_, to = _token(other, random)
    return data[:start] + other[from_:to] + data[end:]


def by_crossing(data: bytes, random: Random, others: Sequence[bytes]) -> bytes:
    """A piece of another file stands in this one."""
    other = random.choice([data, *others])
    start, at = random.randrange(len(other) + 1), random.randrange(len(data) + 1)
    return data[:at] + other[start : start + random.randint(1, 400)] + data[at:]


MUTATIONS: Sequence[Callable[[bytes, Random, Sequence[bytes]], bytes]] = (
    *(by_bytes, by_cutting, by_ending, by_doubling, by_moving),
    *(by_nasty_words, by_nasty_words, by_nasty_words, by_other_words, by_other_words, by_crossing),
)


def mutated(data: bytes, random: Random, others: Sequence[bytes]) -> bytes:
    """The bytes after one to six changes; other files lend their pieces."""
    for _ in range(random.choice([1, 1, 1, 2, 2, 3, 6])):
        data = random.choice(MUTATIONS)(data, random, others)
    return data


def _token(data: bytes, random: Random) -> tuple[int, int]:
    """Where a word of some bytes stands, chosen at random."""
    found = _TOKEN.search(data, random.randrange(len(data) + 1)) or _TOKEN.search(data)
    return found.span() if found else (0, len(data))
