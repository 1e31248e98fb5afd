/* Where a joint is at a time: between the samples, on the line from one to the next. */
function positionAt(replay, time) {
  const { seconds, positions } = replay, next = seconds.findIndex(second => second >= time);
  if (next < 0) return positions[positions.length - 1];
  if (next === 0) return positions[0];
  const part = (time - seconds[next - 1]) / (seconds[next] - seconds[next - 1]);
  return positions[next - 1] + part * (positions[next] - positions[next - 1]);
}

for (const button of document.querySelectorAll(".replay")) {
  const replay = JSON.parse(button.dataset.replay), cursor = button.closest("figure").querySelector(".cursor");
  const box = button.closest(".robot").querySelector(".robot-view"), end = replay.seconds[replay.seconds.length - 1];
  button.addEventListener("click", () => {
    const began = performance.now();
    box.scrollIntoView({ block: "nearest" });
    box.robot.choose(replay.joint);
    cursor.setAttribute("visibility", "visible");
    const tick = () => {
      const time = Math.min(end, (performance.now() - began) / 1000), x = 52 + time / end * 298;
      cursor.setAttribute("x1", x); cursor.setAttribute("x2", x);
      box.robot.set({ [replay.joint]: positionAt(replay, time) });
      if (time < end) requestAnimationFrame(tick);
    };
    tick();
  });
}

for (const button of document.querySelectorAll(".failing")) {
  const pose = JSON.parse(button.dataset.pose), box = button.closest(".robot").querySelector(".robot-view");
  button.addEventListener("click", () => {
    box.scrollIntoView({ block: "nearest" });
    box.robot.set(pose.positions);
    box.robot.choose(pose.joint);
  });
}
