"""Write values so that they are read back unchanged: YAML, XML, xacro and Python."""

from __future__ import annotations

import json
import math
import re
from collections.abc import Mapping, Sequence

_PLAIN = re.compile(r"[A-Za-z_][A-Za-z0-9_./-]*")
_WORDS = frozenset({"y", "n", "yes", "no", "on", "off", "true", "false", "null", "none", "nan", "inf", "infinity"})


def yaml_value(value: object) -> str:
    """Return a value in YAML's flow style on one line.

    Strings that YAML or ROS would read as another type are quoted.
    """
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, float):
        return yaml_float(value)
    if isinstance(value, str):
        return yaml_text(value)
    if isinstance(value, Mapping):
        return "{" + ", ".join(f"{yaml_text(str(key))}: {yaml_value(part)}" for key, part in value.items()) + "}"
    if isinstance(value, Sequence):
        return "[" + ", ".join(map(yaml_value, value)) + "]"
    return str(value)


def yaml_text(text: str) -> str:
    """Return a string for YAML, with quotes if a reader could take it for another type."""
    if _PLAIN.fullmatch(text) and text.lower() not in _WORDS:
        return text
    if text.isprintable():
        return json.dumps(text, ensure_ascii=False)
    import yaml

    quoted: str = yaml.safe_dump(text, default_style='"', allow_unicode=True, width=1 << 30)
    return quoted.strip()


def yaml_float(value: float) -> str:
    """Return a number with a decimal point, as ROS 2 requires for a double. Never `1e-05`, a string in YAML 1.1."""
    if not math.isfinite(value):
        return ".nan" if math.isnan(value) else ".inf" if value > 0 else "-.inf"
    text = repr(value)
    if "e" in text:
        digits, _, exponent = text.partition("e")
        return f"{digits if '.' in digits else digits + '.0'}e{int(exponent):+03d}"
    return text


def xml_text(text: object) -> str:
    """Return a string escaped for a double-quoted attribute, or for text, in plain XML."""
    escaped = str(text).replace("&", "&amp;").replace("<", "&lt;").replace(">", "&gt;").replace('"', "&quot;")
    return "".join(f"&#{ord(c)};" if c in "\t\n\r" else c for c in escaped)


def xacro_text(text: object) -> str:
    """Return a string escaped for xacro. `${` and `$(` stay unchanged, because xacro removes one of several dollars."""
    return re.sub(r"\$+(?=[{(])", r"$\g<0>", xml_text(text))


def python_text(text: object) -> str:
    """Return a Python string literal in double quotes."""
    return json.dumps(str(text), ensure_ascii=not str(text).isprintable())


def one_line(text: str) -> str:
    """Return a string for a comment in YAML or Python, without line ends and unprintable characters."""
    return "".join(c if c.isprintable() else " " for c in text)


def xml_comment(text: str) -> str:
    """Return a string for an XML comment. A zero-width space separates dashes, because `--` is not allowed there."""
    return re.sub(r"-(?=-)", "-\u200b", one_line(text))


def json_text(text: str) -> str:
    """Return a string in double quotes, which YAML reads as a string whatever it contains."""
    return json.dumps(text, ensure_ascii=not text.isprintable())
