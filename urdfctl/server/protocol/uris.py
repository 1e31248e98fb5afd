"""URIs of an editor and paths of files, and which files it may ask about."""

from __future__ import annotations

import os
import re
import stat
import sys
from collections.abc import Collection, Iterator
from urllib.parse import quote, unquote_to_bytes, urlsplit

import attrs
from pygls import uris
from pygls.exceptions import JsonRpcInvalidParams

from urdfctl.server.analysis.folders import folder_of
from urdfctl.source.disk.files import MAX_BYTES

_CONTROLS = re.compile("[\x00-\x1f\x7f]")
_FIELDS = frozenset({"uri", "root_uri"})
_THIS_MACHINE = frozenset({"", "localhost"})


def path_of(uri: str) -> str | None:
    """Return the path of a file's URI, with all links followed; None for what is no file of this machine, such as an
    unnamed buffer.

    Raises JsonRpcInvalidParams if it is not a URI, or one that no file can have.
    """
    try:
        path = _path(uri)
        if path is None:
            return None
        if "\0" in path or not os.path.isabs(path):
            raise JsonRpcInvalidParams(f"no file can have the URI {uri!a}")
        return os.path.realpath(path)
    except ValueError:  # an address in brackets that is none, or half a character
        raise JsonRpcInvalidParams(f"this is not a URI: {uri!a}") from None


def _path(uri: str) -> str | None:
    if _CONTROLS.search(uri):
        raise ValueError
    scheme, host, path, *_ = urlsplit(uri)
    if scheme != "file":
        return None
    if sys.platform == "win32":
        return uris.to_fs_path(uri)
    return os.fsdecode(unquote_to_bytes(path)) if host in _THIS_MACHINE else None


def uri_of(path: str) -> str:
    """Return the URI of a file, also of one whose name is not valid UTF-8."""
    if sys.platform == "win32":
        return uris.from_fs_path(path) or ""
    return "file://" + quote(os.fsencode(path))


def uris_in(params: object) -> Iterator[str]:
    """Yield the URIs in the parameters of a message: of documents, folders, and changes of files."""
    if isinstance(params, list | tuple):
        for one in params:
            yield from uris_in(one)
    elif attrs.has(kind := type(params)):
        for field in attrs.fields(kind):
            value = getattr(params, field.name)
            if isinstance(value, str) and field.name in _FIELDS:
                yield value
            else:
                yield from uris_in(value)


def is_readable_in(path: str, folders: Collection[str]) -> bool:
    """Return whether a path is that of a regular file of at most 16 MiB below one of the folders. All are real paths:
    a link that leaves the folders does not count."""
    if folder_of(path, folders) is None:
        return False
    try:
        info = os.stat(path)
    except (OSError, ValueError):
        return False
    return stat.S_ISREG(info.st_mode) and info.st_size <= MAX_BYTES
