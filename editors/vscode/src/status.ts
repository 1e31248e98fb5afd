/** The status item: the robot of the open file, its distro, and the evidence for it. Knows nothing of the editor. */

const ALONE =
  "No robot of this folder reads this file: it is linted alone.\nIf one does, declare it as [[robot]] in urdfctl.toml.";
const UNKNOWN_DISTRO = "distro: unknown; set urdfctl.distro, or distro in urdfctl.toml";

/** A robot of the workspace, as the notification `urdfctl/checked` describes it. */
export interface Robot {
  file: string;
  robot: string;
  arguments: Record<string, string>;
  launch: string | null;
  distro: string | null;
  distro_from: string | null;
  simulator: string | null;
  files: string[];
  /** Whether the user chose this variant. */
  shown: boolean;
}

/** What the server said last. */
export interface Known {
  robots: readonly Robot[];
  /** Why something is not linted, such as an invalid configuration. */
  problems: readonly string[];
}

export interface Status {
  text: string;
  tooltip: string;
}

/**
 * Return what the status item shows for a file; undefined for a file that is not linted.
 *
 * isLinted: whether the server gets the file.
 */
export function statusOf(file: string | undefined, { robots, problems }: Known, isLinted: boolean): Status | undefined {
  if (problems.length > 0) {
    return { text: "$(warning) urdfctl", tooltip: problems.join("\n\n") };
  }
  const here = robots.filter((robot) => file !== undefined && (robot.file === file || robot.files.includes(file)));
  if (here.length === 0) {
    return isLinted ? { text: "$(circuit-board) no robot", tooltip: ALONE } : undefined;
  }
  const chosen = here.find((robot) => robot.shown);
  const others = here.length > 1 ? ` +${here.length - 1}` : "";
  const name = chosen ? [chosen.robot, ...differing(chosen, here)].join(" ") : `${here[0].robot}${others}`;
  const distros = [...new Set((chosen ? [chosen] : here).map((robot) => robot.distro ?? "unknown distro"))];
  return {
    text: `$(circuit-board) ${name} · ${distros.join(", ")}`,
    tooltip: here.map(described).join("\n\n"),
  };
}

/** The arguments of a robot in which its variants differ. */
function differing(robot: Robot, among: readonly Robot[]): string[] {
  const variants = among.filter((other) => other.file === robot.file);
  return Object.entries(robot.arguments)
    .filter(([name, value]) => variants.some((other) => other.arguments[name] !== value))
    .map(([name, value]) => `${name}:=${value}`);
}

function described(robot: Robot): string {
  const given = Object.entries(robot.arguments).map(([name, value]) => `${name}:=${value}`);
  const lines = [
    [robot.robot, ...given].join(" ") + (robot.shown ? " (shown)" : ""),
    robot.launch ? `started by ${robot.launch}` : undefined,
    robot.distro ? `distro: ${robot.distro}${robot.distro_from ? ` (from ${robot.distro_from})` : ""}` : UNKNOWN_DISTRO,
    robot.simulator ? `simulator: ${robot.simulator}` : undefined,
  ];
  return lines.filter((line) => line !== undefined).join("\n");
}
