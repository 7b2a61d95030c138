// Where the error enters, and what each dial costs: the strip and the chart of one view. Both are generators, which rest
// after each setting that they have measured, so that sliders stay quick.
const STAGES = {sine: "sine", "matrix-bits": "rotation", "view-bits": "view", "t-junctions": "T-junctions", "subpixel-bits": "projection", edges: "edges",
                "inverse-z-bits": "1/z", "over-z-bits": "u/z, v/z", perspective: "between divisions", "pixel-bound": "its bound",
                "texel-bound": "its bound, texels", reciprocal: "reciprocal"};

// The exact setting, then the stages' dials turned one after the other, in the order of the frame, to those of `values`: the
// last is `values`, but for colours. What each step adds is the difference from the one before, so that all add up.
function* stepsOfError(engine, view) {
  const values = engine.values("exact"), steps = [], wrongPixels = engine.measure("wrong_pixels");
  const measure = name => {
    const at = {...view, values: [...values]}, texels = engine.errors(at, 0).rms, faces = engine.errors(at, wrongPixels).rms;
    steps.push({name, texels, faces, milliseconds: engine.milliseconds(1, engine.draw(at).cycles)});
  };
  measure("exact");
  for (const [name, caption] of Object.entries(STAGES)) {
    const dial = engine.dial(name);
    if (values[dial] === view.values[dial]) {
      steps.push({...steps.at(-1), name: caption, isExact: true});
      continue;
    }
    values[dial] = view.values[dial];
    yield null;
    measure(caption);
  }
  return steps;
}

const signed = value => (Math.abs(value) < 5e-4 ? "0" : (value < 0 ? "−" : "+") + number(Math.abs(value)));

const stripTable = (steps, engine) => {
  const columns = ["texels", "faces", "milliseconds"], first = steps[0], last = steps.at(-1);
  const most = columns.map(column => Math.max(1e-9, ...steps.slice(1).map((step, i) => Math.abs(step[column] - steps[i][column]))));
  const bar = (change, c) => `<span class="bar ${change < 0 ? "less" : "more"}" style="width:${(4 * Math.abs(change) / most[c]).toFixed(2)}em"></span>`;
  const row = (name, cells, css = "") => `<tr class="${css}"><th scope="row">${escaped(name)}</th>${cells.map(cell => `<td>${cell}</td>`).join("")}</tr>`;
  const whole = (name, step) => row(name, columns.map(column => step[column] === 0 ? "0" : number(step[column])), "default");
  const rows = steps.slice(1).map((step, i) => row(step.name, step.isExact ? ["exact", "", ""] :
    columns.map((column, c) => signed(step[column] - steps[i][column]) + bar(step[column] - steps[i][column], c)), step.isExact ? "soft" : ""));
  return `<div class="scroll"><table class="strip"><thead><tr><th scope="col">stage</th><th scope="col">texels out of place, pixels (rms)</th>` +
    `<th scope="col">wrong pixels, ‰</th><th scope="col">${engine.processors[1].name}, ms</th></tr></thead><tbody>` +
    whole("all exact", first) + rows.join("") + whole("this setting", last) + "</tbody></table></div>";
};

// Error and cost of presets, and of each dial of texels' places turned alone from the usual setting.
function* marksOfSettings(engine, view) {
  const marks = [];
  const measure = function* (name, values, isPreset) {
    if (marks.some(mark => mark.values.join() === values.join())) return;
    const at = {...view, values}, {cycles} = engine.draw(at), {rms} = engine.errors(at, 0);
    marks.push({name, values, isPreset, cost: engine.milliseconds(1, cycles), error: Math.max(rms, 1e-5)});
    yield null;
  };
  for (const preset of engine.presets) yield* measure(preset.name, preset.values, true);
  for (const [index, dial] of engine.dials.entries())
    for (const {name, value} of dial.measure === 0 ? dial.settings : [])
      yield* measure(`${dial.name}=${name}`, Object.assign([...engine.usual], {[index]: value}), false);
  return marks.sort((a, b) => a.cost - b.cost);
}

// An SVG whose dots are chosen by `preview(mark or null)` under the pointer or focus, and by `keep(mark)`. One stop of the Tab
// key: arrows go from dot to dot.
function drawChart(place, marks, processor, preview, keep) {
  const width = place.clientWidth < 500 ? 380 : 760, height = 360, frame = {left: 46, right: width - 12, top: 24, bottom: height - 44};
  const across = logAxis(marks[0].cost / 1.1, marks.at(-1).cost * 1.1, frame.left, frame.right);
  const errors = marks.map(mark => mark.error), down = logAxis(Math.min(...errors) / 2, Math.max(...errors) * 2, frame.bottom, frame.top);
  let drawn = across.ticks.map(tick => svgLine([[across.place(tick), frame.top], [across.place(tick), frame.bottom]], "grid") +
      svgText(across.place(tick), frame.bottom + 16, "middle", "tick", shortNumber(tick))).join("") +
    down.ticks.map(tick => svgLine([[frame.left, down.place(tick)], [frame.right, down.place(tick)]], "grid") +
      svgText(frame.left - 6, down.place(tick) + 4, "end", "tick", shortNumber(tick))).join("") +
    svgText(frame.left, 14, "start", "axis", "↑ texels out of place, pixels (rms)") + svgText(frame.right, height - 10, "end", "axis", `ms a frame, ${processor} →`);
  const labels = labeller(frame), places = marks.map(mark => [across.place(mark.cost), down.place(mark.error)]);
  marks.forEach((mark, i) => labels.reserve(...places[i], mark.isPreset ? 6 : 4));
  const dots = marks.map((mark, i) => `<circle class="${mark.isPreset ? "preset" : "setting"}" cx="${at(places[i][0])}" cy="${at(places[i][1])}" r="${mark.isPreset ? 6 : 4}" ` +
    `role="button" tabindex="${i ? -1 : 0}" data-mark="${i}" aria-label="${escaped(`${mark.name}: ${number(mark.error)} pixels, ${number(mark.cost)} ms`)}"></circle>`);
  drawn += dots.join("") + marks.map((mark, i) => mark.isPreset ? labels.add(...places[i], mark.name, "name", true) : "").join("");
  place.innerHTML = `<svg viewBox="0 0 ${width} ${height}" role="group" aria-label="Error against cost; arrow keys go from setting to setting">${drawn}</svg>`;
  const circles = [...place.querySelectorAll("circle")], markOf = event => event.target.dataset && marks[event.target.dataset.mark];
  place.firstChild.onpointerover = event => preview(markOf(event) || null);
  place.firstChild.onpointerleave = () => preview(null);
  place.firstChild.onclick = event => { if (markOf(event)) keep(markOf(event)); };
  place.firstChild.addEventListener("focusin", event => preview(markOf(event) || null));
  place.firstChild.addEventListener("focusout", () => preview(null));
  place.firstChild.onkeydown = event => {
    const now = circles.indexOf(event.target), step = {ArrowRight: 1, ArrowUp: 1, ArrowLeft: -1, ArrowDown: -1}[event.key];
    if (now < 0 || !(step || event.key === "Enter" || event.key === " ")) return;
    event.preventDefault();
    if (!step) return keep(marks[now]);
    const next = circles[(now + step + circles.length) % circles.length];
    event.target.tabIndex = -1;
    next.tabIndex = 0;
    next.focus();
  };
}
