// Where the error enters, and what each dial costs: the strip and the chart of one view. Both are generators, which rest
// after each setting that they have measured, so that sliders stay quick.
const STAGES = {sine: "sine", "matrix-bits": "rotation", "view-bits": "view", "t-junctions": "T-junctions", "subpixel-bits": "projection",
                edges: "edges", "inverse-z-bits": "1/z", "over-z-bits": "u/z, v/z", perspective: "between divisions", "pixel-bound": "its bound",
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
  const bar = (change, c) =>
    `<span class="bar ${change < 0 ? "less" : "more"}" style="width:${(4 * Math.abs(change) / most[c]).toFixed(2)}em"></span>`;
  const row = (name, cells, css = "") =>
    `<tr class="${css}"><th scope="row">${escaped(name)}</th>${cells.map(cell => `<td>${cell}</td>`).join("")}</tr>`;
  const whole = (name, step) => row(name, columns.map(column => step[column] === 0 ? "0" : number(step[column])), "default");
  const rows = steps.slice(1).map((step, i) => row(step.name, step.isExact ? ["exact", "", ""] :
    columns.map((column, c) => signed(step[column] - steps[i][column]) + bar(step[column] - steps[i][column], c)), step.isExact ? "soft" : ""));
  const heads = ["stage", "texels out of place, pixels (rms)", "wrong pixels, ‰", engine.processors[1].name + ", ms"];
  return `<div class="scroll" tabindex="0"><table class="strip"><thead><tr>` +
    heads.map(head => `<th scope="col">${head}</th>`).join("") + "</tr></thead><tbody>" +
    whole("all exact", first) + rows.join("") + whole("this setting", last) + "</tbody></table></div>";
};

const wordsOf = mark => `${mark.name}: ${number(mark.error)} pixels, ${number(mark.cost)} ms`;

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

const KEYS = {ArrowRight: 1, ArrowUp: 1, ArrowLeft: -1, ArrowDown: -1};
const NEAR_px = 16;  // from a dot's middle, on the screen

// An SVG whose dots are shown by `preview(mark)` under the pointer or focus, and taken by `keep(mark)`. One stop of the Tab key:
// arrows go from dot to dot.
class Chart {
  constructor(place, marks, processor, preview, keep) {
    Object.assign(this, {marks, preview, keep, width: place.clientWidth < 450 ? 380 : 700, height: 380});
    place.innerHTML = `<svg viewBox="0 0 ${this.width} ${this.height}" role="group" aria-label="Error against cost; arrow keys go from ` +
      `setting to setting">${this.drawn(processor)}</svg>`;
    this.svg = place.firstChild;
    this.dots = [...place.querySelectorAll("circle")];
    this.svg.onpointermove = event => this.choose(this.dotAt(event));
    this.svg.onclick = event => {
      const dot = this.dotAt(event);
      this.choose(dot);
      if (dot) keep(this.markOf(dot));
    };
    this.svg.onkeydown = event => this.press(event);
    this.svg.addEventListener("focusin", event => this.choose(event.target));
  }

  drawn(processor) {
    const {marks} = this, frame = {left: 46, right: this.width - 12, top: 24, bottom: this.height - 44}, errors = marks.map(mark => mark.error);
    const across = logAxis(marks[0].cost / 1.1, marks.at(-1).cost * 1.1, frame.left, frame.right);
    const down = logAxis(Math.min(...errors) / 2, Math.max(...errors) * 2, frame.bottom, frame.top);
    const labels = labeller(frame), places = marks.map(mark => [across.place(mark.cost), down.place(mark.error)]);
    marks.forEach((mark, i) => labels.reserve(...places[i], mark.isPreset ? 6 : 4));
    return across.ticks.map(tick => svgLine([[across.place(tick), frame.top], [across.place(tick), frame.bottom]], "grid") +
        svgText(across.place(tick), frame.bottom + 16, "middle", "tick", shortNumber(tick))).join("") +
      down.ticks.map(tick => svgLine([[frame.left, down.place(tick)], [frame.right, down.place(tick)]], "grid") +
        svgText(frame.left - 6, down.place(tick) + 4, "end", "tick", shortNumber(tick))).join("") +
      svgText(2, 14, "start", "axis", "↑ texels out of place, pixels (rms)") +
      svgText(frame.right, this.height - 10, "end", "axis", `ms a frame, ${processor} →`) +
      marks.map((mark, i) => mark.isPreset ? labels.add(...places[i], mark.name, "name", true) : "").join("") +
      marks.map((mark, i) => `<circle class="${mark.isPreset ? "preset" : "setting"}" cx="${at(places[i][0])}" cy="${at(places[i][1])}" ` +
        `r="${mark.isPreset ? 6 : 4}" role="button" tabindex="${i ? -1 : 0}" aria-label="${escaped(wordsOf(mark))}"></circle>`).join("");
  }

  markOf(dot) {
    return this.marks[this.dots.indexOf(dot)];
  }

  // The nearest one; none if that is not near.
  dotAt({clientX, clientY}) {
    const away = dot => {
      const box = dot.getBoundingClientRect();
      return Math.hypot(clientX - box.left - box.width / 2, clientY - box.top - box.height / 2);
    };
    const dot = this.dots.reduce((best, one) => away(one) < away(best) ? one : best);
    return away(dot) < NEAR_px ? dot : null;
  }

  choose(dot) {
    if (!this.markOf(dot) || dot.classList.contains("chosen")) return;
    for (const one of this.dots) {
      one.classList.toggle("chosen", one === dot);
      one.tabIndex = one === dot ? 0 : -1;
    }
    this.preview(this.markOf(dot));
  }

  press(event) {
    const step = KEYS[event.key], now = this.dots.indexOf(event.target);
    if (now < 0 || !(step || event.key === "Enter" || event.key === " ")) return;
    event.preventDefault();
    if (step) this.dots[(now + step + this.dots.length) % this.dots.length].focus();
    else this.keep(this.marks[now]);
  }
}
