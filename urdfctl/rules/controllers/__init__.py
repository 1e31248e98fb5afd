"""UC4: what controllers' files get wrong."""

from __future__ import annotations

from urdfctl.rule import Rule
from urdfctl.rules.controllers.alias_in_parameters import alias_in_parameters

RULES: tuple[Rule, ...] = (alias_in_parameters,)
