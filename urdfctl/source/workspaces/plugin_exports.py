"""The classes that a source package exports as plugins, and the parameter definitions that it generates code from.

Both are read as text from package.xml, CMakeLists.txt and the files that these name. Nothing is built or run.
"""

from __future__ import annotations

import os
import re
from collections.abc import Iterator, Mapping

from urdfctl.source.disk.files import FileProblem, Files, first_bytes
from urdfctl.source.disk.gate import is_file, names_in, walk
from urdfctl.source.problem import ReadError
from urdfctl.source.xml.parsing import parse
from urdfctl.startup.records import NamedTuple

_MOST_BYTES = 1 << 20
_MOST_SOURCES = 300
_COMMENT = re.compile(r"#[^\n]*")
_XML_COMMENT = re.compile(r"<!--.*?(?:-->|\Z)", re.DOTALL)
_EXPORT_CALL = re.compile(
    r"(?i)\bpluginlib_export_plugin_description_file\s*\(\s*\"?([^\s()\"]+)\"?\s+\"?([^\s()\"]+)\"?\s*\)"
)
_OTHER_WAYS = re.compile(r"(?i)\b(?:include|function|macro|add_subdirectory|ament_index_register_resource)\s*\(")
_EXPORTING = re.compile(r"\bPLUGINLIB_EXPORT_CLASS\s*\(\s*([\w:]+)\s*,\s*([\w:]+)\s*\)")
_PLUGIN_ATTRIBUTE = re.compile(r"<\w+\s[^<>]*\bplugin\s*=\s*[\"']\$\{prefix\}/([^\"']+)[\"']")
_LIBRARY = re.compile(r"(?i)\bgenerate_parameter_(?:library|module)\s*\(\s*([^\s()]+)\s+\"?([^\s()\"]+)\"?")
_SET = re.compile(r"(?i)\bset\s*\(\s*(\w+)\s+\"?([^\s()\"]+)\"?\s*\)")
_VARIABLE = re.compile(r"\$\{(\w+)\}")
_BUILT = ("build", "install")
_SOURCE_ENDS = (".hpp", ".h", ".cpp", ".cc", ".cxx", ".hxx")


class ExportedClass(NamedTuple):
    """A class that a package exports.

    name: the name that it is loaded by.
    class_name: the C++ class, without namespace.
    base: the C++ class that the plugin has to be, with namespace.
    kind: the C++ class, as it is written.
    path: the plugin description.
    """

    name: str
    class_name: str
    base: str
    kind: str = ""
    path: str = ""


class DefinitionFile(NamedTuple):
    """A file with parameter definitions, and the name of the library that is generated from it."""

    library: str
    path: str


def exported_classes(folder: str, files: Files) -> Iterator[ExportedClass]:
    """Yield the classes that the package in a folder exports."""
    for path in _descriptions(folder):
        try:
            root = parse(files.glance(path)).documentElement
        except (FileProblem, ReadError):
            continue
        pending = [root] if root is not None else []
        while pending:
            element = pending.pop(0)
            pending += element.elements()
            base, kind = element.attrs.get("base_class_type", ""), element.attrs.get("type", "")
            if element.tagName == "class" and base and kind:
                name = element.attrs.get("name") or kind
                kind = kind.strip()
                yield ExportedClass(name.strip(), kind.rpartition("::")[2], base.strip(), kind, path)


def _descriptions(folder: str) -> list[str]:
    """The plugin descriptions that package.xml and CMakeLists.txt name, and others directly in the folder."""
    manifest, cmake = (_text(os.path.join(folder, name)) for name in ("package.xml", "CMakeLists.txt"))
    named: list[str] = []
    if "${prefix}" in manifest:
        named += _PLUGIN_ATTRIBUTE.findall(_XML_COMMENT.sub("", manifest))
    if "plugin_description_file" in cmake.lower():
        named += [path for _, path in _EXPORT_CALL.findall(_substituted(cmake))]
    paths = [os.path.normpath(os.path.join(folder, name)) for name in named]
    return list(dict.fromkeys([*(path for path in paths if is_file(path)), *_by_form(folder)]))


def category_of(folder: str, description: str, expected: str) -> str | None:
    """Return what the CMakeLists.txt of an ament package exports a plugin description for.

    Empty if it exports it for nothing; None if that is not known. If it exports it for several, the expected one.
    """
    cmake = _substituted(_text(os.path.join(folder, "CMakeLists.txt")))
    calls = [(category, path) for category, path in _EXPORT_CALL.findall(cmake)]
    if "ament" not in cmake or _OTHER_WAYS.search(cmake) or any("$" in word for call in calls for word in call):
        return None
    named = [category for category, path in calls if os.path.normpath(os.path.join(folder, path)) == description]
    return expected if expected in named else next(iter(named), "")


def built_classes(folder: str) -> tuple[tuple[str, str], ...]:
    """Return the classes that the C++ sources of a package export for pluginlib, each with its base."""
    return tuple(_EXPORTING.findall(sources_of_class(folder, "PLUGINLIB_EXPORT_CLASS")))


def _by_form(folder: str) -> Iterator[str]:
    try:
        names = names_in(folder)
    except OSError:
        return
    for name in names:
        path = os.path.join(folder, name)
        if name.endswith(".xml") and name != "package.xml" and "base_class_type" in _text(path):
            yield path


def definition_files(folder: str) -> list[DefinitionFile]:
    """Return the definition files that CMakeLists.txt generates code from."""
    cmake = _substituted(_text(os.path.join(folder, "CMakeLists.txt")))
    named = [
        DefinitionFile(name, os.path.normpath(os.path.join(folder, path))) for name, path in _LIBRARY.findall(cmake)
    ]
    return [definition for definition in named if is_file(definition.path)]


def sources_of_class(folder: str, name: str) -> str:
    """Return the C++ sources of a package that name a class, joined; empty if there are none."""
    texts, walked = [], 0
    for above, folders, names in walk(folder):
        folders[:] = sorted(
            inner for inner in folders if not inner.startswith(".") and inner not in ("build", "install")
        )
        for file in sorted(names):
            if file.endswith(_SOURCE_ENDS):
                walked += 1
                text = _text(os.path.join(above, file))
                if re.search(rf"\b{re.escape(name)}\b", text):
                    texts.append(_without_comments(text))
        if walked > _MOST_SOURCES:
            break
    return "\n".join(texts)


def _without_comments(text: str) -> str:
    return re.sub(r"//[^\n]*", "", re.sub(r"(?s)/\*.*?(?:\*/|\Z)", "", text))


def _text(path: str) -> str:
    try:
        return first_bytes(path, _MOST_BYTES).decode("utf-8", "replace")
    except OSError:
        return ""


def _substituted(cmake: str) -> str:
    text = _COMMENT.sub("", cmake)
    for variable in ("${CMAKE_CURRENT_SOURCE_DIR}/", "${PROJECT_SOURCE_DIR}/", "${CMAKE_CURRENT_LIST_DIR}/"):
        text = text.replace(variable, "")
    project = re.search(r"(?i)\bproject\s*\(\s*([\w.-]+)", text)
    return _with_variables(text.replace("${PROJECT_NAME}", project[1]) if project else text)


def _with_variables(text: str) -> str:
    """A text with the variables that it sets replaced by the values that they have there."""
    values: dict[str, str] = {}
    parts, start = [], 0
    for found in _SET.finditer(text):
        parts.append(_replaced(text[start : found.start()], values))
        values[found[1]] = _replaced(found[2], values)
        start = found.end()
    return "".join((*parts, _replaced(text[start:], values)))


def _replaced(text: str, values: Mapping[str, str]) -> str:
    return _VARIABLE.sub(lambda found: values.get(found[1], found[0]), text) if values else text
