"""Robot descriptions in launch files in Python: by a command, by xacro's own functions, by helpers, or read as text."""

from __future__ import annotations

from textwrap import dedent

from systems.render.actions import Description
from systems.render.launch.python_values import PythonValues, call, listed

MODULE = "descriptions"
"""The module with the helper that makes descriptions, if it is one of its own."""
FUNCTION = "load_description"
_HELPER = '''
    def load_description(path, mappings=None):
        """Return the robot's description."""
        document = xacro.process_file(path, mappings=mappings)
        return document.toprettyxml(indent="  ")
    '''
_READER = """
    def load_description(path, mappings=None):
        with open(path) as file:
            return file.read()
    """


def helper(*, is_plain: bool) -> str:
    """Return the function that makes descriptions."""
    return dedent(_READER if is_plain else _HELPER).strip("\n") + "\n"


def description(values: PythonValues, found: Description, package: str) -> tuple[list[str], str]:
    """Return the statements that a description needs before it, and the expression of its text.

    package: that of the launch file.
    """
    form = values.idioms["description"]
    if form in ("parameter_value", "command", "find_executable", "perform"):
        return [], _command(values, found, form)
    path = values.text(found.path)
    mappings = _mappings(values, found)
    if form in ("function", "module"):
        if form == "module":
            values.imports.add(f"from {package}.{MODULE} import {FUNCTION}")
        elif not found.is_plain:
            values.use("xacro")
        return [], call(FUNCTION, path, *([mappings] if mappings else []))
    if found.is_plain or form == "open":
        return [f"with open({path}) as file:\n    robot_text = file.read()"], "robot_text"
    values.use("xacro")
    keyword = [f"mappings={mappings}"] if mappings else []
    if form == "process_file":
        return [], f"{call('xacro.process_file', path, *keyword)}.toxml()"
    return [
        f"document = xacro.parse(open({path}))",
        call("xacro.process_doc", "document", *keyword),
    ], "document.toxml()"


def _mappings(values: PythonValues, found: Description) -> str:
    pairs = [f'"{name}": {values.text(value)}' for name, value in found.mappings]
    return f"{{{', '.join(pairs)}}}" if pairs else ""


def _command(values: PythonValues, found: Description, form: str) -> str:
    program = ['"cat "' if found.is_plain else '"xacro "']
    if form == "find_executable" and not found.is_plain:
        program = [f'{values.use("FindExecutable")}(name="xacro")', '" "']
    words = [*program, *_flat(values.value(found.path))]
    for name, value in found.mappings:
        words += [f'" {name}:="', *_flat(values.value(value))]
    whole = f"{values.use('Command')}({listed(words)})"
    if form == "perform":
        return f"{whole}.perform(context)"
    if form == "command":
        return whole
    return f"{values.use('ParameterValue')}({whole}, value_type=str)"


def _flat(value: str) -> list[str]:
    """The items of a list of pieces, or the only piece."""
    return [value[1:-1]] if value.startswith("[") and value.endswith("]") else [value]
