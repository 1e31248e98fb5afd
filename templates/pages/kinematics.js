/* A pose is 12 numbers: the rotation row by row, then the place in m. */
function poseAfter(a, b) {
  const c = new Array(12);
  for (let row = 0; row < 3; row++) {
    const [x, y, z] = [a[3 * row], a[3 * row + 1], a[3 * row + 2]];
    for (let column = 0; column < 3; column++) c[3 * row + column] = x * b[column] + y * b[3 + column] + z * b[6 + column];
    c[9 + row] = x * b[9] + y * b[10] + z * b[11] + a[9 + row];
  }
  return c;
}

function motionOf(joint, position) {
  const [x, y, z] = joint.axis;
  if (joint.type === "prismatic") return [1, 0, 0, 0, 1, 0, 0, 0, 1, x * position, y * position, z * position];
  const c = Math.cos(position), s = Math.sin(position), d = 1 - c;
  return [c + x * x * d, x * y * d - z * s, x * z * d + y * s,
    y * x * d + z * s, c + y * y * d, y * z * d - x * s,
    z * x * d - y * s, z * y * d + x * s, c + z * z * d, 0, 0, 0];
}

/* The position of a joint in rad or m; a joint that mimics another one follows it. */
function positionOf(scene, joint, positions, asked = new Set()) {
  const leader = joint.mimic && !asked.has(joint.name) && scene.joints.find(other => other.name === joint.mimic[0]);
  if (!leader) return positions[joint.name] ?? joint.start;
  asked.add(joint.name);
  return positionOf(scene, leader, positions, asked) * joint.mimic[1] + joint.mimic[2];
}

/* The pose of each link in the frame of the root. scene.joints is in the order from the root outwards. */
function posesOf(scene, positions) {
  const poses = {};
  for (const joint of scene.joints) {
    const parent = poses[joint.parent] ??= [1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0];
    const own = poseAfter(parent, joint.pose);
    poses[joint.child] = joint.moves ? poseAfter(own, motionOf(joint, positionOf(scene, joint, positions))) : own;
  }
  for (const link of Object.keys(scene.links)) poses[link] ??= [1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0];
  return poses;
}
