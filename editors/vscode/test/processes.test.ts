import assert from "node:assert/strict";
import { chmodSync, existsSync, mkdtempSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import * as path from "node:path";
import { test } from "node:test";

import { install } from "../src/install";
import { begin } from "../src/processes";

const POSIX = { skip: process.platform === "win32" ? "the programs of this test are shell scripts" : false };

/** A folder with a program that stands for Python: it writes its arguments to a file, then runs `does`. */
function python(does: string): { folder: string; interpreter: string } {
  const folder = mkdtempSync(path.join(tmpdir(), "urdfctl-"));
  const interpreter = path.join(folder, "python3");
  writeFileSync(interpreter, `#!/bin/sh\necho "$@" >> "${folder}/asked"\n${does}\n`);
  chmodSync(interpreter, 0o755);
  return { folder, interpreter };
}

async function installed(does: string): Promise<{ failure: string | undefined; log: string; environment: string }> {
  const { folder, interpreter } = python(does);
  const environment = path.join(folder, "environment");
  let log = "";
  const failure = await install({ interpreter, environment, platform: "linux", log: (text) => (log += text) });
  return { failure, log, environment };
}

test("a program that ends says why in its last line", async () => {
  const code = "console.error('first\\nurdfctl: the server needs pygls\\n'); process.exit(2)";
  const running = await begin(process.execPath, ["-e", code], { folder: tmpdir() });
  assert.deepEqual(await running.ended, { status: 2, reason: "the server needs pygls" });
});

test("a program that says nothing is described by its exit status", async () => {
  const running = await begin(process.execPath, ["-e", "process.exit(3)"], { folder: tmpdir() });
  assert.equal((await running.ended).reason, "exit status 3");
});

test("a program that does not exist is refused", async () => {
  await assert.rejects(begin(path.join(tmpdir(), "no-such-urdfctl"), [], { folder: tmpdir() }), /there is no such file/);
});

test("urdfctl is installed into an environment of its own, with what the server needs", POSIX, async () => {
  const makes = 'if [ "$3" = venv ]; then mkdir -p "$4/bin" && cp "$0" "$4/bin/python"; fi';
  const { failure, log, environment } = await installed(makes);
  assert.equal(failure, undefined);
  assert.ok(existsSync(path.join(environment, "bin/python")));
  assert.match(log, /environment\/bin\/python -I -m pip install .*--upgrade urdfctl\[server\]/);
});

test("a Python that is too old is named, and nothing is made with it", POSIX, async () => {
  const { failure, environment } = await installed("exit 1");
  assert.match(failure ?? "", /requires Python 3\.10 or newer, and '.*python3' is older or missing/);
  assert.ok(!existsSync(environment));
});

test("an environment that cannot be made says what to install", POSIX, async () => {
  const { failure } = await installed('if [ "$3" = venv ]; then echo "No module named ensurepip" >&2; exit 1; fi');
  assert.equal(failure, "No module named ensurepip. On Ubuntu and Debian, install python3-venv first");
});

test("what pip says last is why urdfctl was not installed", POSIX, async () => {
  const makes = 'if [ "$3" = venv ]; then mkdir -p "$4/bin" && cp "$0" "$4/bin/python"; fi';
  const { failure } = await installed(`${makes}\nif [ "$3" = pip ]; then echo "ERROR: no network" >&2; exit 1; fi`);
  assert.equal(failure, "ERROR: no network");
});
