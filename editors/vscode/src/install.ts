/** Installs urdfctl into a Python environment of the extension's own. Knows nothing of the editor. */

import { mkdirSync } from "node:fs";
import * as path from "node:path";

import { pythonOf } from "./find";
import { begin } from "./processes";

const REQUIREMENT = "urdfctl[server]";
const OLDEST = [3, 10];
const VERSION = `import sys; sys.exit(sys.version_info < (${OLDEST.join(", ")}))`;

/** Python as we start it: it imports nothing of its current folder, nor what PYTHONPATH or the user's folder have. */
const ISOLATED = "-I";

/** What installing depends on. */
export interface Installation {
  /** The interpreter that makes the environment; by default the one on PATH. */
  interpreter?: string;
  /** The folder of the environment. */
  environment: string;
  platform: NodeJS.Platform;
  /** Takes what the programs write. */
  log: (text: string) => void;
}

/**
 * Install urdfctl, or its newest version. Return undefined, or what went wrong.
 *
 * An environment of its own works where systems protect their Python from pip, and changes nothing that the user has.
 */
export async function install(to: Installation): Promise<string | undefined> {
  const python = to.interpreter ?? (to.platform === "win32" ? "py" : "python3");
  if ((await run(to, python, ["-c", VERSION])) !== undefined) {
    const wanted = `urdfctl requires Python ${OLDEST.join(".")} or newer`;
    return `${wanted}, and '${python}' is older or missing. Select another interpreter, or install one`;
  }
  const made = await run(to, python, ["-m", "venv", to.environment]);
  if (made !== undefined) {
    return to.platform === "linux" ? `${made}. On Ubuntu and Debian, install python3-venv first` : made;
  }
  const own = pythonOf(to.environment, to.platform);
  return run(to, own, ["-m", "pip", "install", "--disable-pip-version-check", "--upgrade", REQUIREMENT]);
}

/** Run Python, isolated, in a folder of the extension's own; return undefined, or why it failed. */
async function run(to: Installation, python: string, words: readonly string[]): Promise<string | undefined> {
  const args = [ISOLATED, ...words];
  to.log(`$ ${[python, ...args].join(" ")}\n`);
  // pip starts further Pythons, which are not isolated
  const variables = Object.fromEntries(Object.entries(process.env).filter(([name]) => !name.startsWith("PYTHON")));
  const folder = path.dirname(to.environment);
  try {
    mkdirSync(folder, { recursive: true });
    const { process: program, ended } = await begin(python, args, { folder, variables });
    program.stdin?.end();
    program.stdout?.on("data", (data: Buffer) => to.log(data.toString()));
    program.stderr?.on("data", (data: Buffer) => to.log(data.toString()));
    const { status, reason } = await ended;
    return status === 0 ? undefined : reason;
  } catch (error) {
    return error instanceof Error ? error.message : String(error);
  }
}
