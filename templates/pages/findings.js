const list = document.querySelector("ul.findings"), filters = document.querySelector("div.filters");
if (filters) {
  const all = [...list.children], said = filters.querySelector("[role=status]");
  const boxes = [...filters.querySelectorAll("input")], selects = [...filters.querySelectorAll("select")];
  const chosen = name => [...filters.querySelectorAll(`[name=${name}]:checked`)].map(box => box.value);
  const apply = (codes) => {
    const severities = chosen("severity"), [code, file] = selects.map(one => one.value);
    let shown = 0;
    for (const one of all) {
      const { severity, code: own, file: place } = one.dataset;
      one.hidden = !(severities.includes(severity) && (!file || file === place) && (codes ? codes.includes(own) : !code || code === own));
      shown += one.hidden ? 0 : 1;
    }
    said.textContent = shown === all.length ? "" : `${shown} of ${all.length}`;
  };
  filters.addEventListener("change", () => apply(null));
  const broken = [...document.querySelectorAll(".graph .node")].filter(node => node.dataset.rules);
  const open = node => {
    for (const box of boxes) box.checked = true;
    for (const one of selects) one.value = "";
    apply(node.dataset.rules.split(" "));
    document.getElementById("findings").scrollIntoView({ block: "start" });
  };
  for (const node of broken) {
    node.addEventListener("click", () => open(node));
    node.addEventListener("keydown", event => { if (event.key === "Enter") open(node); });
  }
  const marks = [...document.querySelectorAll(".graph [data-from]")].filter(mark => mark.tagName === "text");
  for (const button of list.querySelectorAll("button.in-graph")) {
    const node = broken.find(one => one.dataset.rules.split(" ").includes(button.dataset.code));
    const mark = marks.find(one => one.textContent.split(" ").includes(button.dataset.code));
    const source = mark && mark.closest("svg").querySelector(`[data-node="${mark.dataset.from}"]`);
    const target = node || source;
    if (!target) continue;
    button.hidden = false;
    button.addEventListener("click", () => { target.scrollIntoView({ block: "center", inline: "center" }); target.focus(); });
  }
}
