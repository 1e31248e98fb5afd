/** Installs urdfctl into a Python environment of the extension's own. Knows nothing of the editor. */

import { pythonOf } from "./find";
import { begin } from "./processes";

const REQUIREMENT = "urdfctl[server]";
const OLDEST = [3, 10];
const VERSION = `import sys; sys.exit(sys.version_info < (${OLDEST.join(", ")}))`;

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

/** Run a program; return undefined, or why it failed. */
async function run(to: Installation, command: string, args: readonly string[]): Promise<string | undefined> {
  to.log(`$ ${[command, ...args].join(" ")}\n`);
  try {
    const { process, ended } = await begin(command, args);
    process.stdin?.end();
    process.stdout?.on("data", (data: Buffer) => to.log(data.toString()));
    process.stderr?.on("data", (data: Buffer) => to.log(data.toString()));
    const { status, reason } = await ended;
    return status === 0 ? undefined : reason;
  } catch (error) {
    return error instanceof Error ? error.message : String(error);
  }
}
