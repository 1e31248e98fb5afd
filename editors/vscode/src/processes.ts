/** Programs that the extension starts, and why they ended. Knows nothing of the editor. */

import { type ChildProcess, spawn } from "node:child_process";

/** A program that runs. */
export interface Running {
  process: ChildProcess;
  /** Settles when it has ended, with its exit status and the last line that it wrote to its standard error. */
  ended: Promise<Ended>;
}

export interface Ended {
  status: number | null;
  reason: string;
}

/** Where a program starts. */
export interface Place {
  /** Its current folder: not the editor's own, in which a stranger's files may lie. */
  folder: string;
  /** Its environment variables; by default the editor's. */
  variables?: NodeJS.ProcessEnv;
}

const WHY: Record<string, string> = { ENOENT: "there is no such file", EACCES: "it is not executable" };

/** Start a program. Rejects if there is no such program, or it may not be run. */
export async function begin(command: string, args: readonly string[], at: Place): Promise<Running> {
  const process = spawn(command, args, { cwd: at.folder, env: at.variables, stdio: "pipe", windowsHide: true });
  let last = "";
  process.stderr.on("data", (data: Buffer) => (last = (last + data.toString()).slice(-4000)));
  const ended = new Promise<Ended>((settle) => {
    process.once("close", (status) => settle({ status, reason: lastLine(last) || `exit status ${status}` }));
  });
  await new Promise<void>((started, failed) => {
    process.once("spawn", started);
    process.once("error", (error: NodeJS.ErrnoException) => failed(new Error(WHY[error.code ?? ""] ?? error.message)));
  });
  process.on("error", () => undefined);
  return { process, ended };
}

function lastLine(text: string): string {
  const last = text.trim().split(/\r?\n/).at(-1)?.trim() ?? "";
  return last.replace(/^urdfctl: /, "");
}
