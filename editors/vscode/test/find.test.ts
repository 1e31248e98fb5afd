import assert from "node:assert/strict";
import { test } from "node:test";

import { type Found, findUrdfctl, pythonOf, type Surroundings } from "../src/find";

function around(changes: Partial<Surroundings>, files: string[] = []): Surroundings {
  const isFile = (file: string): boolean => files.includes(file);
  const usual = { setting: "", searchPath: "/usr/bin:/opt/bin", own: "/own", home: "/home/ada" };
  return { ...usual, platform: "linux", isFile, ...changes };
}

function commands(found: Found[]): string[] {
  return found.map((one) => `${one.from} ${one.command}`);
}

test("the setting is the only one", () => {
  const found = findUrdfctl(around({ setting: "~/venv/bin/urdfctl", interpreter: "/v/bin/python" }, ["/v/bin/urdfctl"]));
  assert.deepEqual(commands(found), ["setting /home/ada/venv/bin/urdfctl"]);
});

test("the selected Python environment comes before PATH, and that before the extension's own", () => {
  const files = ["/own/bin/urdfctl", "/usr/bin/urdfctl", "/v/bin/urdfctl"];
  const found = findUrdfctl(around({ interpreter: "/v/bin/python" }, files));
  assert.deepEqual(commands(found), ["environment /v/bin/urdfctl", "path /usr/bin/urdfctl", "own /own/bin/urdfctl"]);
});

test("the folders of PATH are looked at in their order, and each command is tried once", () => {
  const files = ["/opt/bin/urdfctl", "/usr/bin/urdfctl"];
  const found = findUrdfctl(around({ interpreter: "/opt/bin/python" }, files));
  assert.deepEqual(commands(found), ["environment /opt/bin/urdfctl", "path /usr/bin/urdfctl"]);
});

test("nothing is found where nothing is installed", () => {
  assert.deepEqual(findUrdfctl(around({ interpreter: "/v/bin/python" })), []);
});

test("on Windows it is beside the interpreter or in Scripts", () => {
  const windows = { platform: "win32" as const, searchPath: "C:\\bin;D:\\bin", interpreter: "C:\\py\\python.exe" };
  const find = (...files: string[]): string[] => commands(findUrdfctl(around({ ...windows, own: "C:\\own" }, files)));
  assert.deepEqual(find("C:\\py\\Scripts\\urdfctl.exe"), ["environment C:\\py\\Scripts\\urdfctl.exe"]);
  assert.deepEqual(find("D:\\bin\\urdfctl.exe"), ["path D:\\bin\\urdfctl.exe"]);
  assert.deepEqual(find("C:\\own\\Scripts\\urdfctl.exe"), ["own C:\\own\\Scripts\\urdfctl.exe"]);
  assert.equal(pythonOf("C:\\own", "win32"), "C:\\own\\Scripts\\python.exe");
});
