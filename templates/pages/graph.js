for (const box of document.querySelectorAll(".wired:not([data-ready])")) {
  box.dataset.ready = "";
  const drawing = box.querySelector("svg"), search = box.querySelector(".wired-search");
  const nodes = [...drawing.querySelectorAll(".node")], edges = [...drawing.querySelectorAll("[data-from]")];
  const kind = new Map(nodes.map(node => [node.dataset.node, node.classList]));
  const isHub = edge => edge.dataset.kind === "drives" || edge.dataset.kind === "moves";
  const isFeedback = edge => edge.dataset.kind === "reads" && !kind.get(edge.dataset.to).contains("broadcaster");
  const jointOf = new Map();
  for (const node of nodes)
    if (node.classList.contains("command"))
      for (const other of nodes)
        if (other.classList.contains("joint") && node.dataset.name.startsWith(other.dataset.name + "/"))
          jointOf.set(node.dataset.node, other.dataset.node);
  const pairs = (start) => [
    ...jointOf,
    ...edges.filter(edge => !isFeedback(edge) && (!isHub(edge) || start.has(edge.dataset.from) || start.has(edge.dataset.to)))
      .map(edge => [edge.dataset.from, edge.dataset.to])];
  const reached = (start, ways) => {
    const seen = new Set(start), pending = [...start];
    while (pending.length) {
      const current = pending.pop();
      for (const [from, to] of ways) if (from === current && !seen.has(to)) { seen.add(to); pending.push(to); }
    }
    return seen;
  };
  const show = (found) => {
    drawing.classList.toggle("dimmed", found !== null);
    if (found === null) return;
    const start = new Set(found), ways = pairs(start);
    const lit = new Set([...reached(start, ways), ...reached(start, ways.map(([from, to]) => [to, from]))]);
    for (const edge of edges)
      if (edge.dataset.kind === "drives" && lit.has(edge.dataset.from)) lit.add(edge.dataset.to);
    for (const node of nodes) node.classList.toggle("lit", lit.has(node.dataset.node));
    for (const edge of edges) edge.classList.toggle("lit", lit.has(edge.dataset.from) && lit.has(edge.dataset.to));
  };
  const searched = () => {
    const text = search.value.trim().toLowerCase();
    const found = nodes.filter(node => text && node.querySelector("title").textContent.toLowerCase().includes(text));
    show(text ? found.map(node => node.dataset.node) : null);
    if (found.length) found[0].scrollIntoView({ block: "nearest", inline: "nearest" });
  };
  const area = box.querySelector(".wired-drawing"), natural = drawing.viewBox.baseVal;
  let scale = 1, isFitted = true;
  const zoom = (wanted) => {
    const middle = [area.scrollLeft + area.clientWidth / 2, area.scrollTop + area.clientHeight / 2].map(at => at / scale);
    scale = Math.min(4, Math.max(.1, wanted));
    drawing.setAttribute("width", natural.width * scale);
    drawing.setAttribute("height", natural.height * scale);
    area.scrollTo(middle[0] * scale - area.clientWidth / 2, middle[1] * scale - area.clientHeight / 2);
  };
  const fitting = () => Math.min(1, (area.clientWidth - 2) / natural.width);
  const fit = () => { isFitted = true; zoom(fitting()); };
  const legible = .75, narrow = 600;
  const begin = () => {  // on a telephone the whole graph would be too small to read: it begins where something is wrong
    if (area.clientWidth > narrow || fitting() >= legible) { fit(); return; }
    isFitted = false;
    zoom(legible);
    area.scrollTo(0, 0);
    const wrong = nodes.find(node => node.classList.contains("broken"));
    if (!wrong) return;
    const at = wrong.getBoundingClientRect(), around = area.getBoundingClientRect();
    area.scrollTo(at.left - around.left - (area.clientWidth - at.width) / 2, at.top - around.top - (area.clientHeight - at.height) / 2);
  };
  const zoomBy = factor => { isFitted = false; zoom(scale * factor); };
  const zooms = { in: () => zoomBy(1.3), out: () => zoomBy(1 / 1.3), fit };
  for (const button of box.querySelectorAll("[data-zoom]")) button.addEventListener("click", zooms[button.dataset.zoom]);
  area.addEventListener("wheel", event => {
    if (!event.ctrlKey) return;
    event.preventDefault();
    zoomBy(event.deltaY < 0 ? 1.15 : 1 / 1.15);
  }, { passive: false });
  area.addEventListener("pointermove", event => {
    if (event.buttons === 1 && event.pointerType === "mouse") area.scrollBy(-event.movementX, -event.movementY);
  });
  begin();
  if (isFitted) area.scrollTo(0, 0);
  let width = area.clientWidth;
  window.ResizeObserver && new ResizeObserver(() => {
    if (isFitted && area.clientWidth !== width) fit();
    width = area.clientWidth;
  }).observe(area);
  search.addEventListener("input", searched);
  for (const node of nodes) {
    for (const event of ["mouseenter", "focus"]) node.addEventListener(event, () => show([node.dataset.node]));
    for (const event of ["mouseleave", "blur"]) node.addEventListener(event, searched);
  }
}
