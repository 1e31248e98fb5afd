"""A distro that is added to the table is checked by every rule that holds from some distro on."""

from __future__ import annotations

import json
import subprocess
import sys

from folder import CHECKOUT, environment

CODE = r"""
import json, sys, types
from pathlib import Path

import urdfctl.catalog

path = Path(urdfctl.catalog.__file__).with_name("distros.py")
line = '    Distro("rolling", 2, maintained=True),\n'
source = path.read_text(encoding="utf-8")
assert line in source
module = types.ModuleType("urdfctl.catalog.distros")
sys.modules[module.__name__] = module
exec(compile(source.replace(line, line.replace("rolling", "meteor") + line), str(path), "exec"), module.__dict__)

from urdfctl.rules import all_faults, faults_found_by
from urdfctl.control.parameters.spawner_options import DISTROS as OPTIONS

rules = [rule.code for rule in all_faults() if "rolling" in rule.distros and "meteor" not in rule.distros]
options = [option for option, distros in OPTIONS.items() if "rolling" in distros and "meteor" not in distros]

import os, tempfile
from urdfctl.lint.examples import written
from urdfctl.lint.selection import Selection
from urdfctl.lint.target import lint_target
from urdfctl.load.loader import Loader

def codes(target, settings, distro):
    result = lint_target(Loader(settings._replace(distro=distro)), target, Selection()).result
    return sorted({finding.code for finding in result.outcome.diagnostics if finding.code[:3] != "UC7"})

different = {}
for rule in faults_found_by("lint"):
    if "rolling" not in rule.distros:
        continue
    for number, example in enumerate(rule.bad, 1):
        with tempfile.TemporaryDirectory() as folder:
            target, settings = written(example, os.path.realpath(folder))
            found = codes(target, settings, "meteor"), codes(target, settings, "rolling")
            if found[0] != found[1]:
                different[f"{rule.code}-{number}"] = found
print(json.dumps({"rules": rules, "options": options, "different": different}))
"""


def test_a_distro_in_the_table_is_checked_by_every_rule_that_should_cover_it() -> None:
    ran = subprocess.run(
        [sys.executable, "-c", CODE],
        env=environment({"PYTHONPATH": str(CHECKOUT)}),
        capture_output=True,
        text=True,
        check=False,
    )
    assert ran.returncode == 0, ran.stderr
    assert json.loads(ran.stdout) == {"rules": [], "options": [], "different": {}}
