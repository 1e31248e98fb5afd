/** What the server is told: the files that it is asked about, and the wishes of the settings. */

/** The documents that the server gets, as VS Code's document filters. */
export const DOCUMENTS = [
  ...["urdf", "xacro", "srdf", "roslaunch"].map((language) => ({ scheme: "file", language })),
  { scheme: "file", pattern: "**/*.{urdf,xacro,srdf,launch,gazebo,ros2_control}" },
  { scheme: "file", pattern: "**/*.{urdf,srdf}.xacro" },
  { scheme: "file", pattern: "**/*.launch.{py,xml,yaml,yml}" },
  { scheme: "file", pattern: "**/{config,params,param,controllers,control}/**/*.{yaml,yml}" },
  { scheme: "file", pattern: "**/*{controller,controllers,control,joint_limits,kinematics}*.{yaml,yml}" },
];

/** Reads one setting of the section `urdfctl`. */
export type Reader = <T>(name: string) => T | undefined;

/** Return the settings that are set, as the server expects them. */
export function wishes(read: Reader): Record<string, unknown> {
  const texts = ["distro", "simulator"].map((name) => [name, read<string>(name)?.trim()] as const);
  const lists = ["select", "ignore"].map((name) => [name, read<string[]>(name)] as const);
  const given = Object.fromEntries([...texts, ...lists].filter(([, value]) => value !== undefined && value.length > 0));
  const variant = read<Record<string, string>>("arguments") ?? {};
  return Object.keys(variant).length > 0 ? { ...given, arguments: variant } : given;
}
