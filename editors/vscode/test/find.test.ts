import assert from "node:assert/strict";
import { test } from "node:test";

import { type Found, findUrdfctl, pythonOf, type Surroundings } from "../src/find";

function around(changes: Partial<Surroundings>, files: string[] = []): Surroundings {
  const isFile = (file: string): boolean => files.includes(file);
  const usual = { setting: "", searchPath: "/usr/bin:/opt/bin", own: "/own", home: "/home/ada", untrusted: [] };
  return { ...usual, platform: "linux", isFile, realPath: (file) => file, ...changes };
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

test("what lies in an untrusted workspace is not run, also where a link leads there", () => {
  const files = ["/ws/.venv/bin/urdfctl", "/usr/bin/urdfctl", "/opt/bin/urdfctl", "/wsx/bin/urdfctl"];
  const realPath = (file: string): string => (file === "/usr/bin/urdfctl" ? "/ws/tools/urdfctl" : file);
  const open = { interpreter: "/ws/.venv/bin/python", searchPath: "/usr/bin:/opt/bin:/wsx/bin", realPath };
  assert.deepEqual(commands(findUrdfctl(around({ ...open, untrusted: ["/ws"] }, files))), [
    "path /opt/bin/urdfctl",
    "path /wsx/bin/urdfctl",
  ]);
  assert.deepEqual(commands(findUrdfctl(around(open, files))), [
    "environment /ws/.venv/bin/urdfctl",
    "path /usr/bin/urdfctl",
    "path /opt/bin/urdfctl",
    "path /wsx/bin/urdfctl",
  ]);
});

test("folders that are named relative to wherever the editor was started are not looked at", () => {
  const files = ["urdfctl", "./urdfctl", "bin/urdfctl", "/opt/bin/urdfctl"];
  const found = findUrdfctl(around({ interpreter: "python", searchPath: ".:bin::/opt/bin" }, files));
  assert.deepEqual(commands(found), ["path /opt/bin/urdfctl"]);
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
