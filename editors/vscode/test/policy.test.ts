import assert from "node:assert/strict";
import { test } from "node:test";

import { inPanel } from "../src/policy";

const HASH = `'sha256-${"A".repeat(43)}='`;
const STRICT = `default-src 'none'; script-src ${HASH} ${HASH}; style-src ${HASH}; base-uri 'none'; form-action 'none'`;

/** A page with a policy in its head. */
function page(policy: string, before = ""): string {
  const meta = `<meta http-equiv="Content-Security-Policy" content="${policy.replaceAll("'", "&#39;")}">`;
  return `<!DOCTYPE html>\n<html lang="en">\n<head>\n<meta charset="utf-8">\n${before}${meta}\n<title>t</title></head>`;
}

test("the scripts of a page that names them by their hashes run, and the page is as it was", () => {
  assert.deepEqual(inPanel(page(STRICT)), { html: page(STRICT), scripts: true });
});

test("a page without a policy loads nothing and runs no script", () => {
  const plain = `<!DOCTYPE html>\n<html lang="en">\n<head>\n<meta charset="utf-8">\n<title>t</title></head>`;
  const shown = inPanel(plain);
  assert.equal(shown.scripts, false);
  assert.ok(shown.html.indexOf("default-src 'none'") < shown.html.indexOf("<title>"));
  assert.equal(inPanel("<script>1</script>").scripts, false);
  assert.ok(inPanel("<script>1</script>").html.startsWith("<meta http-equiv"));
});

for (const policy of [
  STRICT.replace("script-src", "script-src 'unsafe-inline'"),
  STRICT.replace("script-src", "script-src https:"),
  STRICT.replace("style-src", "style-src 'unsafe-inline'"),
  STRICT.replace("default-src 'none'", "default-src *"),
  STRICT.replace("default-src 'none'; ", ""),
  STRICT.replace(/script-src[^;]*; /, ""),
  `${STRICT}; img-src https:`,
  `${STRICT}; connect-src *`,
  `script-src *; ${STRICT}`,
  "",
]) {
  test(`a policy that allows more counts for none: ${policy.slice(0, 60)}`, () => {
    assert.equal(inPanel(page(policy)).scripts, false);
  });
}

test("a policy that is not the first in the head counts for none", () => {
  for (const before of ["<script>1</script>", "<!-- -->", "<base href='x'>"]) {
    assert.equal(inPanel(page(STRICT, before)).scripts, false);
  }
});
