/* Corners and triangles of the shapes of a scene, without normals: the shader takes them from the triangles. */
function bytesOf(text) {
  const letters = atob(text), bytes = new Uint8Array(letters.length);
  for (let n = 0; n < letters.length; n++) bytes[n] = letters.charCodeAt(n);
  return bytes.buffer;
}

function surfaceOf(packed) {
  const fractions = new Uint16Array(bytesOf(packed.corners)), corners = new Float32Array(fractions.length);
  for (let n = 0; n < fractions.length; n++) corners[n] = packed.low[n % 3] + fractions[n] / 65535 * packed.size[n % 3];
  const faces = packed.wide ? new Uint32Array(bytesOf(packed.faces)) : Uint32Array.from(new Uint16Array(bytesOf(packed.faces)));
  return { corners, faces, colour: packed.colour };
}

function gridOf(rows, columns, at) {
  const corners = [], faces = [];
  for (let row = 0; row <= rows; row++)
    for (let column = 0; column <= columns; column++) corners.push(...at(row / rows, column / columns));
  for (let row = 0; row < rows; row++)
    for (let column = 0; column < columns; column++) {
      const a = row * (columns + 1) + column, b = a + columns + 1;
      faces.push(a, b, a + 1, a + 1, b, b + 1);
    }
  return { corners: new Float32Array(corners), faces: new Uint32Array(faces), colour: null };
}

function roundOf(profile) {
  return gridOf(profile.length - 1, 32, (along, around) => {
    const [radius, z] = profile[Math.round(along * (profile.length - 1))], angle = 2 * Math.PI * around;
    return [radius * Math.cos(angle), radius * Math.sin(angle), z];
  });
}

function arcOf(radius, from, to, shift) {
  return Array.from({ length: 9 }, (_, n) => {
    const angle = from + (to - from) * n / 8;
    return [radius * Math.cos(angle), radius * Math.sin(angle) + shift];
  });
}

function boxOf([x, y, z]) {
  const corners = [], faces = [0, 1, 3, 0, 3, 2, 4, 6, 7, 4, 7, 5, 0, 4, 5, 0, 5, 1, 2, 3, 7, 2, 7, 6, 0, 2, 6, 0, 6, 4, 1, 5, 7, 1, 7, 3];
  for (const a of [-.5, .5]) for (const b of [-.5, .5]) for (const c of [-.5, .5]) corners.push(a * x, b * y, c * z);
  return { corners: new Float32Array(corners), faces: new Uint32Array(faces), colour: null };
}

function surfacesOf(part, meshes) {
  const [radius, length = 0] = part.size, quarter = Math.PI / 2;
  switch (part.shape) {
    case "mesh":
      return meshes[part.mesh].map(mesh => ({ ...mesh, corners: mesh.corners.map((value, n) => value * part.size[n % 3]) }));
    case "box": return [boxOf(part.size)];
    case "cylinder": return [roundOf([[0, -length / 2], [radius, -length / 2], [radius, length / 2], [0, length / 2]])];
    case "sphere": return [roundOf(arcOf(radius, -quarter, quarter, 0))];
    case "capsule":
      return [roundOf([...arcOf(radius, -quarter, 0, -length / 2), ...arcOf(radius, 0, quarter, length / 2)])];
    default: return [roundOf([[0, -radius], [radius, 0], [0, radius]])];
  }
}
