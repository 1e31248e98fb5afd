import assert from "node:assert/strict";
import { test } from "node:test";

import manifest from "../package.json";
import { FILE_COMMANDS, fileCommand, withFile } from "../src/commands";

const OPEN = "file:///ws/arm.xacro";

test("a command from the palette is about the open file", () => {
  assert.deepEqual(withFile("urdfctl.graph", [], OPEN), [OPEN]);
  assert.equal(withFile("urdfctl.graph", [], undefined), undefined);
});

test("a command above a robot is about that robot, whatever is open", () => {
  assert.deepEqual(withFile("urdfctl.migrate", ["file:///ws/b.urdf", "jazzy"], OPEN), ["file:///ws/b.urdf", "jazzy"]);
});

test("a command from a menu, which gives it something else, is about the open file", () => {
  assert.deepEqual(withFile("urdfctl.smoke", [{ groupId: 0 }], OPEN), [OPEN]);
});

test("a command that is not about a file keeps its arguments", () => {
  assert.deepEqual(withFile("urdfctl.explain", ["UC201"], undefined), ["UC201"]);
  assert.equal(fileCommand("urdfctl.explain"), undefined);
});

test("each command is in the palette", () => {
  const titles = manifest.contributes.commands.map((each) => each.command);
  for (const { command } of FILE_COMMANDS) {
    assert.ok(titles.includes(command), command);
  }
});
