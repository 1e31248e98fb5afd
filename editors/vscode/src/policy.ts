/** What pages may do in a panel. Knows nothing of the editor. */

/** A page as a panel shows it. */
export interface Shown {
  html: string;
  /** Whether its scripts run. */
  scripts: boolean;
}

const HEAD = /^<!DOCTYPE html>\s*<html[^<>]*>\s*<head>\s*(?:<meta charset="utf-8">\s*)?/;
const OWN = /^<meta http-equiv="Content-Security-Policy" content="([^"<>]*)">/;
const HASH = /^'sha256-[A-Za-z0-9+/]{43}='$/;
const QUIET = `<meta http-equiv="Content-Security-Policy" content="default-src 'none'; style-src 'unsafe-inline'">`;

/**
 * Return how a page of the server is shown. Its scripts run only if the page names them by their hashes, before
 * anything else, and loads nothing; that of an older server runs none.
 */
export function inPanel(page: string): Shown {
  const start = HEAD.exec(page)?.[0].length ?? 0;
  const own = OWN.exec(page.slice(start));
  if (own !== null && isStrict(own[1].replaceAll("&#39;", "'"))) {
    return { html: page, scripts: true };
  }
  return { html: page.slice(0, start) + QUIET + page.slice(start), scripts: false };
}

/** Whether a policy allows only scripts and styles with certain hashes. */
function isStrict(policy: string): boolean {
  const parts = policy.split(";").map((part) => part.trim().split(/\s+/));
  const directives = new Map(parts.map(([name, ...sources]) => [name, sources]));
  const allows = (name: string, sign: RegExp) => (directives.get(name) ?? ["*"]).every((source) => sign.test(source));
  const others = [...directives.keys()].filter((name) => name !== "script-src" && name !== "style-src");
  return (
    directives.size === parts.length &&
    allows("default-src", /^'none'$/) &&
    allows("script-src", HASH) &&
    allows("style-src", HASH) &&
    others.every((name) => allows(name, /^'none'$/))
  );
}
