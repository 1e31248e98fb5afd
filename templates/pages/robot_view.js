const SHADERS = [`#version 300 es
uniform mat4 view; uniform mat4 model; uniform vec2 shift; in vec3 corner; out vec3 place;
void main() { vec4 world = model * vec4(corner, 1.0); place = world.xyz; gl_Position = view * world; gl_Position.xy += shift * gl_Position.w; }`, `#version 300 es
precision highp float; uniform vec4 colour; uniform vec3 eye; uniform bool flat_colour; in vec3 place; out vec4 shown;
void main() {
  if (flat_colour) { shown = colour; return; }
  vec3 normal = normalize(cross(dFdx(place), dFdy(place))), to_eye = normalize(eye - place);
  if (dot(normal, to_eye) < 0.0) normal = -normal;
  float light = 0.35 + 0.45 * max(dot(normal, to_eye), 0.0) + 0.25 * max(dot(normal, normalize(vec3(0.4, -0.5, 1.0))), 0.0);
  shown = vec4(colour.rgb * light, colour.a);
}`];
const GREY = [.62, .65, .7, 1], MARKED = [.85, .3, .75, 1], UNMOVED = [1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0];
const AXES = ["#e5484d", "#46a758", "#3e7bfa"], OUTLINE = 2.5;
const AROUND = Array.from({ length: 8 }, (_, n) => [Math.cos(n * Math.PI / 4), Math.sin(n * Math.PI / 4)]);

function colourOf(style, name) {
  return numbersOf(style.getPropertyValue(name).trim());
}

function numbersOf(hex) {
  const found = hex.match(/^#(..)(..)(..)$/);
  return found ? [...found.slice(1).map(part => parseInt(part, 16) / 255), 1] : GREY;
}

/* A link's own colour half as strong: a red part must not look like a fault. */
function muted(colour) {
  const grey = .3 * colour[0] + .6 * colour[1] + .1 * colour[2];
  return colour.slice(0, 3).map(part => .45 * part + .55 * (.25 + .6 * grey));
}

/* A column-major matrix from a pose. */
function matrixOf(p) {
  return [p[0], p[3], p[6], 0, p[1], p[4], p[7], 0, p[2], p[5], p[8], 0, p[9], p[10], p[11], 1];
}

class RobotView {
  constructor(box, scene) {
    this.box = box; this.scene = scene; this.positions = {}; this.chosen = null; this.group = new Set(); this.untested = new Set(); this.picked = [];
    this.canvas = box.querySelector("canvas");
    this.own = box.querySelector(".own-colours"); this.frames = box.querySelector(".joint-frames");
    this.gl = this.canvas.getContext("webgl2", { antialias: true, stencil: true, preserveDrawingBuffer: true });
    this.turn = { yaw: .7, pitch: .4, distance: 3, target: [0, 0, 0] };
    this.connect();
    if (!this.gl) { box.classList.add("without-webgl"); return; }
    this.prepare();
    this.frame();
    new ResizeObserver(() => this.draw()).observe(this.canvas);
    matchMedia("(prefers-color-scheme: dark)").addEventListener?.("change", () => this.draw());
    this.draw();
  }

  prepare() {
    const gl = this.gl, program = gl.createProgram();
    [gl.VERTEX_SHADER, gl.FRAGMENT_SHADER].forEach((kind, n) => {
      const shader = gl.createShader(kind);
      gl.shaderSource(shader, SHADERS[n]); gl.compileShader(shader); gl.attachShader(program, shader);
    });
    gl.linkProgram(program); gl.useProgram(program); gl.enable(gl.DEPTH_TEST);
    this.at = Object.fromEntries(["view", "model", "colour", "eye", "flat_colour", "shift"].map(name => [name, gl.getUniformLocation(program, name)]));
    const meshes = this.scene.meshes.map(mesh => mesh.map(surfaceOf)), corner = gl.getAttribLocation(program, "corner");
    this.pieces = [];
    for (const [link, parts] of Object.entries(this.scene.links))
      for (const part of parts)
        for (const surface of surfacesOf(part, meshes)) {
          const vao = gl.createVertexArray();
          gl.bindVertexArray(vao);
          gl.bindBuffer(gl.ARRAY_BUFFER, gl.createBuffer());
          gl.bufferData(gl.ARRAY_BUFFER, surface.corners, gl.STATIC_DRAW);
          gl.enableVertexAttribArray(corner); gl.vertexAttribPointer(corner, 3, gl.FLOAT, false, 0, 0);
          gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, gl.createBuffer());
          gl.bufferData(gl.ELEMENT_ARRAY_BUFFER, surface.faces, gl.STATIC_DRAW);
          const colour = part.shape === "missing" ? MARKED : part.colour ?? surface.colour ?? GREY;
          this.pieces.push({ link, vao, colour, count: surface.faces.length, pose: part.pose, corners: surface.corners, missing: part.shape === "missing" });
        }
    this.joints = this.mover(); this.lines = [0, 1, 2, 3].map(() => this.lineBuffer(corner));
    this.prepareBadges();
  }

  lineBuffer(corner) {
    const gl = this.gl, vao = gl.createVertexArray(), buffer = gl.createBuffer();
    gl.bindVertexArray(vao); gl.bindBuffer(gl.ARRAY_BUFFER, buffer);
    gl.enableVertexAttribArray(corner); gl.vertexAttribPointer(corner, 3, gl.FLOAT, false, 0, 0);
    return { vao, buffer };
  }

  /* A badge with the number of findings beside each link whose joint has an error; it leads to them. */
  prepareBadges() {
    this.badges = this.scene.joints.filter(joint => joint.error && this.rows.has(joint.name)).map(joint => {
      const badge = document.createElement("button");
      badge.type = "button"; badge.className = "badge"; badge.textContent = joint.findings.length;
      badge.setAttribute("aria-label", `${joint.name}: lint reports an error; show it`);
      badge.addEventListener("click", () => this.choose(joint.name, true));
      this.canvas.parentElement.append(badge);
      return { joint, badge };
    });
  }

  /* For each link the nearest joint above it that moves. */
  mover() {
    const found = {};
    for (const joint of this.scene.joints) found[joint.child] = joint.moves ? joint : found[joint.parent];
    return found;
  }

  /* Look at the whole robot. */
  frame() {
    const poses = posesOf(this.scene, this.positions), low = [1e9, 1e9, 1e9], high = [-1e9, -1e9, -1e9];
    const include = (pose, x, y, z) => {
      for (let n = 0; n < 3; n++) {
        const value = pose[3 * n] * x + pose[3 * n + 1] * y + pose[3 * n + 2] * z + pose[9 + n];
        low[n] = Math.min(low[n], value); high[n] = Math.max(high[n], value);
      }
    };
    for (const piece of this.pieces) {
      const pose = poseAfter(poses[piece.link], piece.pose), step = 3 * Math.max(1, Math.floor(piece.corners.length / 900));
      for (let n = 0; n + 2 < piece.corners.length; n += step) include(pose, ...piece.corners.subarray(n, n + 3));
    }
    if (!this.pieces.length) Object.values(poses).forEach(pose => include(pose, 0, 0, 0));
    this.turn.target = low.map((value, n) => (value + high[n]) / 2);
    this.size = Math.max(.05, Math.hypot(...low.map((value, n) => high[n] - value))); this.ground = low[2];
    this.turn.distance = 1.15 * this.size;
  }

  camera() {
    const { yaw, pitch, distance, target } = this.turn;
    const back = [Math.cos(pitch) * Math.cos(yaw), Math.cos(pitch) * Math.sin(yaw), Math.sin(pitch)];
    const right = [-Math.sin(yaw), Math.cos(yaw), 0];
    const up = [-Math.sin(pitch) * Math.cos(yaw), -Math.sin(pitch) * Math.sin(yaw), Math.cos(pitch)];
    const eye = target.map((value, n) => value + distance * back[n]);
    const near = distance / 100, far = distance * 20 + this.size * 4, focus = 2.1;
    const wide = this.canvas.width / this.canvas.height, dot = axis => -axis.reduce((sum, value, n) => sum + value * eye[n], 0);
    const rows = [[right, focus / Math.max(1, wide)], [up, focus * Math.min(1, wide)]].map(([axis, scale]) => [...axis, dot(axis)].map(value => value * scale));
    const depth = [...back.map(value => -value), -dot(back)];
    const z = depth.map((value, n) => value * (far + near) / (far - near) - (n === 3 ? 2 * far * near / (far - near) : 0));
    const all = [...rows, z, depth];
    return { eye, right, up, view: [0, 1, 2, 3].flatMap(column => all.map(row => row[column])) };
  }

  tint(piece) {
    const joint = this.joints[piece.link], style = getComputedStyle(this.box);
    if (piece.missing) return MARKED;
    if (this.own?.checked || !joint) return muted(piece.colour);
    const [red, green, blue] = piece.colour, brightness = .3 * red + .6 * green + .1 * blue;
    return colourOf(style, `--by-${joint.control}`).map(value => .8 * value + .2 * brightness);
  }

  draw(ids = false) {
    const gl = this.gl;
    if (!gl) return;
    const ratio = ids ? 1 : Math.min(2, devicePixelRatio || 1);
    this.canvas.width = Math.max(1, Math.round(this.canvas.clientWidth * ratio)); this.canvas.height = Math.max(1, Math.round(this.canvas.clientHeight * ratio));
    gl.viewport(0, 0, this.canvas.width, this.canvas.height);
    gl.clearColor(...(ids ? [0, 0, 0, 1] : [0, 0, 0, 0])); gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT | gl.STENCIL_BUFFER_BIT);
    const { eye, view } = this.camera(), poses = posesOf(this.scene, this.positions);
    gl.uniformMatrix4fv(this.at.view, false, view); gl.uniform3fv(this.at.eye, eye); gl.uniform1i(this.at.flat_colour, ids ? 1 : 0); gl.uniform2f(this.at.shift, 0, 0);
    if (!ids) this.drawGround();
    this.pieces.forEach((piece, n) => {
      gl.bindVertexArray(piece.vao);
      gl.uniformMatrix4fv(this.at.model, false, matrixOf(poseAfter(poses[piece.link], piece.pose)));
      const number = n + 1, colour = ids ? [(number & 255) / 255, (number >> 8) / 255, 0, 1] : [...this.tint(piece).slice(0, 3), 1];
      gl.uniform4fv(this.at.colour, colour);
      gl.drawElements(gl.TRIANGLES, piece.count, gl.UNSIGNED_INT, 0);
    });
    if (ids) return;
    this.drawOutlines(poses, ratio);
    this.drawAxes(poses);
    this.placeBadges(poses, view);
  }

  drawLines(slot, corners, colour) {
    const gl = this.gl, { vao, buffer } = this.lines[slot];
    gl.bindVertexArray(vao); gl.bindBuffer(gl.ARRAY_BUFFER, buffer);
    gl.bufferData(gl.ARRAY_BUFFER, new Float32Array(corners), gl.DYNAMIC_DRAW);
    gl.uniformMatrix4fv(this.at.model, false, matrixOf(UNMOVED)); gl.uniform1i(this.at.flat_colour, 1); gl.uniform4fv(this.at.colour, colour);
    gl.drawArrays(gl.LINES, 0, corners.length / 3);
    gl.uniform1i(this.at.flat_colour, 0);
  }

  /* A grid under the robot, in steps of 1, 2 or 5 times a power of ten. */
  drawGround() {
    const rough = this.size / 6, power = 10 ** Math.floor(Math.log10(rough)), step = [1, 2, 5, 10].find(part => part * power >= rough) * power;
    const half = 6 * step, corners = [], z = this.ground;
    for (let n = -6; n <= 6; n++) corners.push(n * step, -half, z, n * step, half, z, -half, n * step, z, half, n * step, z);
    this.drawLines(0, corners, colourOf(getComputedStyle(this.box), "--ground"));
    const words = this.box.querySelector(".ground-step"), text = `a square is ${step < 1 ? `${+(step * 100).toPrecision(1)} cm` : `${step} m`} wide`;
    if (words && words.textContent !== text) words.textContent = text;
  }

  /* The axes of the origin, and those of each joint that is asked for: x red, y green, z blue. */
  drawAxes(poses) {
    const gl = this.gl, frames = [[UNMOVED, .12 * this.size]];
    if (this.frames?.checked) for (const joint of this.scene.joints) if (joint.moves && poses[joint.child]) frames.push([poses[joint.child], .06 * this.size]);
    gl.disable(gl.DEPTH_TEST);
    AXES.forEach((colour, axis) => {
      const corners = frames.flatMap(([p, length]) => [p[9], p[10], p[11], ...[0, 3, 6].map((row, n) => p[9 + n] + p[row + axis] * length)]);
      this.drawLines(1 + axis, corners, numbersOf(colour));
    });
    gl.enable(gl.DEPTH_TEST);
  }

  /* An outline around what has an error, also if something is before it, and around what is chosen. */
  drawOutlines(poses, ratio) {
    const gl = this.gl, style = getComputedStyle(this.box), isMarked = name => name === this.chosen || this.group.has(name), isChosen = piece => isMarked(this.joints[piece.link]?.name) || this.untested.has(piece.link);
    const kinds = [["--error", piece => this.joints[piece.link]?.error && !isChosen(piece)], ["--chosen", isChosen]];
    gl.enable(gl.STENCIL_TEST); gl.disable(gl.DEPTH_TEST); gl.uniform1i(this.at.flat_colour, 1);
    for (const [name, wanted] of kinds) {
      const pieces = this.pieces.filter(wanted);
      if (!pieces.length) continue;
      gl.clear(gl.STENCIL_BUFFER_BIT); gl.uniform4fv(this.at.colour, colourOf(style, name));
      gl.stencilFunc(gl.ALWAYS, 1, 255); gl.stencilOp(gl.KEEP, gl.KEEP, gl.REPLACE); gl.colorMask(false, false, false, false);
      this.drawFlat(pieces, poses, [[0, 0]]);
      gl.stencilFunc(gl.NOTEQUAL, 1, 255); gl.stencilOp(gl.KEEP, gl.KEEP, gl.KEEP); gl.colorMask(true, true, true, true);
      this.drawFlat(pieces, poses, AROUND.map(([x, y]) => [x * 2 * OUTLINE * ratio / this.canvas.width, y * 2 * OUTLINE * ratio / this.canvas.height]));
    }
    gl.uniform2f(this.at.shift, 0, 0); gl.uniform1i(this.at.flat_colour, 0); gl.disable(gl.STENCIL_TEST); gl.enable(gl.DEPTH_TEST);
  }

  drawFlat(pieces, poses, shifts) {
    for (const piece of pieces) {
      this.gl.bindVertexArray(piece.vao);
      this.gl.uniformMatrix4fv(this.at.model, false, matrixOf(poseAfter(poses[piece.link], piece.pose)));
      for (const [x, y] of shifts) { this.gl.uniform2f(this.at.shift, x, y); this.gl.drawElements(this.gl.TRIANGLES, piece.count, this.gl.UNSIGNED_INT, 0); }
    }
  }

  placeBadges(poses, view) {
    for (const { joint, badge } of this.badges) {
      const pose = poses[joint.child], at = pose && [0, 1, 3].map(row => view[row] * pose[9] + view[4 + row] * pose[10] + view[8 + row] * pose[11] + view[12 + row]);
      const [x, y] = at ? [at[0] / at[2], at[1] / at[2]] : [2, 2];
      badge.hidden = !at || Math.abs(x) > 1 || Math.abs(y) > 1;
      badge.style.left = `${(x + 1) / 2 * this.canvas.clientWidth}px`; badge.style.top = `${(1 - y) / 2 * this.canvas.clientHeight}px`;
    }
  }

  /* The joint at a place of the canvas, in pixels. */
  jointAt(x, y) {
    const pixel = new Uint8Array(4);
    this.draw(true);
    this.gl.readPixels(Math.round(x), Math.round(this.canvas.height - y), 1, 1, this.gl.RGBA, this.gl.UNSIGNED_BYTE, pixel);
    this.draw();
    const piece = this.pieces[pixel[0] + 256 * pixel[1] - 1];
    return piece && this.joints[piece.link];
  }

  connect() {
    this.rows = new Map([...this.box.querySelectorAll("[data-joint]")].map(row => [row.dataset.joint, row]));
    for (const [name, row] of this.rows) {
      row.querySelector("input")?.addEventListener("input", event => this.set({ [name]: Number(event.target.value) }));
      row.addEventListener("focusin", () => this.choose(name));
      row.querySelector("details")?.addEventListener("toggle", () => this.choose(name));
    }
    for (const box of [this.own, this.frames]) box?.addEventListener("change", () => this.draw());
    this.box.querySelector(".robot-search")?.addEventListener("input", event => {
      const text = event.target.value.trim().toLowerCase();
      for (const [name, row] of this.rows) row.hidden = !name.toLowerCase().includes(text);
    });
    this.box.querySelector(".robot-groups")?.addEventListener("change", event => this.mark(event.target.value));
    this.box.querySelector(".robot-untested")?.addEventListener("change", event => this.part(event.target.value));
    this.box.querySelector(".robot-poses")?.addEventListener("change", event => {
      const pose = this.scene.poses.find(one => one.name === event.target.value);
      if (pose) this.set(pose.positions);
    });
    this.box.querySelector(".reset")?.addEventListener("click", () => { this.positions = {}; this.set({}); this.gl && this.frame(); this.draw(); });
    let held = null;
    this.canvas.addEventListener("pointerdown", event => { held = { x: event.offsetX, y: event.offsetY, moved: 0, shift: event.shiftKey || event.button === 2 }; this.canvas.setPointerCapture(event.pointerId); });
    this.canvas.addEventListener("pointermove", event => {
      if (!held) return;
      const [dx, dy] = [event.offsetX - held.x, event.offsetY - held.y];
      held = { ...held, x: event.offsetX, y: event.offsetY, moved: held.moved + Math.abs(dx) + Math.abs(dy) };
      if (held.shift) this.shift(dx, dy); else this.rotate(-dx / 150, dy / 150);
    });
    this.canvas.addEventListener("pointerup", event => {
      if (held && held.moved < 4 && this.gl) { const joint = this.jointAt(event.offsetX, event.offsetY); this.choose(joint?.name ?? null, true); }
      held = null;
    });
    this.canvas.addEventListener("contextmenu", event => event.preventDefault());
    this.canvas.addEventListener("wheel", event => { event.preventDefault(); this.zoom(Math.exp(event.deltaY / 800)); }, { passive: false });
    this.canvas.addEventListener("keydown", event => {
      const act = { ArrowLeft: () => this.rotate(.1, 0), ArrowRight: () => this.rotate(-.1, 0), ArrowUp: () => this.rotate(0, .1), ArrowDown: () => this.rotate(0, -.1), "+": () => this.zoom(.9), "-": () => this.zoom(1.1) }[event.key];
      if (act) { act(); event.preventDefault(); }
    });
  }

  rotate(yaw, pitch) { this.turn.yaw += yaw; this.turn.pitch = Math.max(-1.5, Math.min(1.5, this.turn.pitch + pitch)); this.draw(); }

  zoom(factor) { this.turn.distance *= factor; this.draw(); }

  shift(dx, dy) {
    const { right, up } = this.camera(), scale = this.turn.distance / this.canvas.clientHeight / 1.05;
    this.turn.target = this.turn.target.map((value, n) => value - right[n] * dx * scale + up[n] * dy * scale);
    this.draw();
  }

  /* Move joints, by name, to positions in rad or m. */
  set(positions) {
    Object.assign(this.positions, positions);
    for (const joint of this.scene.joints) {
      const row = this.rows.get(joint.name), value = positionOf(this.scene, joint, this.positions);
      if (!row || !joint.moves) continue;
      const input = row.querySelector("input");
      if (input && Number(input.value) !== value) input.value = value;
      row.querySelector("output").textContent = `${value.toFixed(2)} ${joint.unit}`;
    }
    this.draw();
  }

  /* Outline the links that the joints of a planning group move; those of none without a name. */
  mark(name) {
    this.group = new Set(this.scene.groups.find(group => group.name === name)?.joints ?? []);
    for (const [joint, row] of this.rows) row.classList.toggle("in-group", this.group.has(joint));
    this.draw();
  }

  /* Outline the links that a planner does not test for collisions with a link, and say why. */
  part(link) {
    const others = this.scene.untested[link] ?? [];
    this.untested = new Set(others.map(([other]) => other));
    this.box.querySelector(".untested-links").textContent = others.map(([other, reason]) => reason ? `${other} (${reason})` : other).join(", ");
    this.draw();
  }

  choose(name, open = false) {
    this.chosen = name;
    for (const [joint, row] of this.rows) {
      row.classList.toggle("chosen", joint === name);
      if (joint === name && open) { row.querySelector("details").open = true; row.scrollIntoView({ block: "nearest" }); }
    }
    this.draw();
  }
}

for (const box of document.querySelectorAll(".robot-view")) {
  const scene = JSON.parse(box.querySelector("script[type='application/json']").textContent);
  box.robot = new RobotView(box, scene);
}
