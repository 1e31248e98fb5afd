import assert from "node:assert/strict";
import { test } from "node:test";

import manifest from "../package.json";
import { DOCUMENTS, wishes } from "../src/settings";

test("only settings that are set are sent to the server", () => {
  const set: Record<string, unknown> = { distro: " jazzy ", simulator: "", select: [], ignore: ["UC105"] };
  const read = <T>(name: string): T => set[name] as T;
  assert.deepEqual(wishes(read), { distro: "jazzy", ignore: ["UC105"] });
  set.arguments = { prefix: "left_" };
  assert.deepEqual(wishes(read), { distro: "jazzy", ignore: ["UC105"], arguments: { prefix: "left_" } });
});

test("each language of the extension is sent to the server and has a grammar", () => {
  const languages = manifest.contributes.languages.map((language) => language.id);
  const sent = DOCUMENTS.flatMap((filter) => ("language" in filter ? [filter.language] : []));
  assert.deepEqual([...sent].sort(), [...languages].sort());
  assert.deepEqual(manifest.contributes.grammars.map((grammar) => grammar.language).sort(), [...languages].sort());
});

test("the settings that are read are settings of the extension", () => {
  const read: string[] = [];
  wishes(<T>(name: string) => (read.push(name), undefined as T | undefined));
  for (const name of [...read, "path"]) {
    assert.ok(`urdfctl.${name}` in manifest.contributes.configuration.properties, name);
  }
});
