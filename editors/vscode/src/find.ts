/** Where urdfctl is: the setting, the selected Python environment, or PATH. Knows nothing of the editor. */

import * as path from "node:path";

/** A command line that starts urdfctl, and where it was found. */
export interface Found {
  command: string;
  args: string[];
  from: "setting" | "environment" | "path";
}

/** What finding depends on. */
export interface Surroundings {
  /** The setting `urdfctl.path`; empty if it is not set. */
  setting: string;
  /** The interpreter of the selected Python environment, if there is one. */
  interpreter?: string;
  /** The environment variable PATH. */
  searchPath: string;
  platform: NodeJS.Platform;
  home: string;
  isFile: (file: string) => boolean;
}

/** Return the command that starts urdfctl; undefined if it is not installed. */
export function findUrdfctl(around: Surroundings): Found | undefined {
  const setting = around.setting.trim();
  if (setting) {
    return { command: withHome(setting, around.home), args: [], from: "setting" };
  }
  const { join, dirname } = around.platform === "win32" ? path.win32 : path.posix;
  const beside = around.interpreter ? executable(dirname(around.interpreter), around, join) : undefined;
  if (beside) {
    return { command: beside, args: [], from: "environment" };
  }
  const separator = around.platform === "win32" ? ";" : ":";
  for (const folder of around.searchPath.split(separator).filter(Boolean)) {
    const found = executable(folder, around, join);
    if (found) {
      return { command: found, args: [], from: "path" };
    }
  }
  return undefined;
}

/** Return the command line that installs urdfctl with its server into a Python environment. */
export function installCommand(interpreter: string | undefined, platform: NodeJS.Platform): string {
  const python = interpreter ?? (platform === "win32" ? "py" : "python3");
  const start = platform === "win32" ? `& "${python}"` : `'${python.replaceAll("'", `'\\''`)}'`;
  return `${start} -m pip install "urdfctl[server]"`;
}

function executable(
  folder: string,
  around: Surroundings,
  join: (...parts: string[]) => string,
): string | undefined {
  const names = around.platform === "win32" ? ["urdfctl.exe", "Scripts\\urdfctl.exe"] : ["urdfctl"];
  return names.map((name) => join(folder, name)).find(around.isFile);
}

function withHome(file: string, home: string): string {
  return file === "~" || file.startsWith("~/") ? home + file.slice(1) : file;
}
