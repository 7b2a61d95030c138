// Opens the module, makes the figures of the page, and shares the time of a frame among those in view.
const BUDGET_ms = 9;  // of work a frame, so that a slider's next picture comes in time

const unpacked = async name => {
  const packed = Uint8Array.from(atob(document.getElementById(name).textContent), letter => letter.charCodeAt(0));
  return new Uint8Array(await new Response(new Blob([packed]).stream().pipeThrough(new DecompressionStream("gzip"))).arrayBuffer());
};

// The strip and the chart below the figure with all dials, measured anew when it has rested.
class Measurements {
  constructor(engine, figure) {
    Object.assign(this, {engine, figure, chartEye: "", stripView: "", running: null});
    this.strip = document.getElementById("strip-table");
    this.chart = document.getElementById("chart-dots");
    this.said = document.getElementById("chart-said");
    this.kept = null;  // what the figure showed before a dot's setting
  }

  *measureStrip(view) {
    this.strip.innerHTML = stripTable(yield* stepsOfError(this.engine, view), this.engine);
  }

  *measureChart(view) {
    const marks = yield* marksOfSettings(this.engine, view);
    drawChart(this.chart, marks, this.engine.processors[1].name, mark => this.preview(mark), mark => this.keep(mark));
  }

  show(mark, values) {
    this.figure.view.values = [...values];
    this.figure.change();
    this.said.textContent = mark ? `${mark.name}: ${number(mark.error)} pixels, ${number(mark.cost)} ms. Shown above.` : "";
  }

  preview(mark) {
    if (mark) {
      this.kept = this.kept || [...this.figure.view.values];
      this.show(mark, mark.values);
    } else if (this.kept) {
      this.show(null, this.kept);
      this.kept = null;
    }
  }

  keep(mark) {
    this.kept = [...mark.values];
    this.show(mark, mark.values);
  }

  // A step of what is to be measured; false: nothing.
  work() {
    const {view, rested, isTurning} = this.figure, eye = view.eye.join(), whole = eye + ":" + view.values.join();
    if (isTurning || rested < 0.3) return false;
    if (this.running && this.running.whole !== whole) this.running = null;  // of another view
    if (!this.running && this.stripView !== whole && !this.kept) this.running = {whole, name: "stripView", is: whole, steps: this.measureStrip({...view, values: [...view.values]})};
    if (!this.running && this.chartEye !== eye) this.running = {whole, name: "chartEye", is: eye, steps: this.measureChart(view)};
    if (!this.running) return false;
    if (this.running.steps.next().done) {
      this[this.running.name] = this.running.is;
      this.running = null;
    }
    return true;
  }
}

const open = async () => {
  const module = await openArticle({wasmBinary: await unpacked("article.wasm")});
  const engine = new Engine(module, await unpacked("article.bsp"), await unpacked("palette.lmp"));
  const clock = {processor: null};  // whose pace turning views keep; null: this device's
  const figures = FIGURES.map(definition => new Figure(engine, definition, document.getElementById("figure-" + definition.id), clock));
  const measurements = new Measurements(engine, figures.at(-1));
  document.getElementById("machine").replaceChildren(...[...engine.processors.map(one => one.name), "this device"].map((name, i) => {
    const input = element("input", {type: "radio", name: "machine", value: i, change: () => { clock.processor = i < engine.processors.length ? i : null; }});
    input.checked = i === engine.processors.length;
    return element("label", {}, input, name);
  }));
  const seen = new IntersectionObserver(entries => entries.forEach(entry => {
    figures.find(figure => figure.place === entry.target).isInView = entry.isIntersecting;
  }), {rootMargin: "100px"});
  figures.forEach(figure => seen.observe(figure.place));
  let chartSeen = false;
  new IntersectionObserver(([entry]) => { chartSeen = entry.isIntersecting; }, {rootMargin: "400px"}).observe(document.getElementById("where"));

  let before = performance.now(), first = 0;
  const frame = now => {
    const seconds = Math.min(0.25, (now - before) / 1000), inView = figures.filter(figure => figure.isInView);
    before = now;
    for (const figure of figures) figure.rested += seconds;
    for (const figure of inView) {
      figure.turn(now, seconds);
      if (figure.due.picture) figure.work(now);
    }
    // The rest in turn, as far as there is time.
    for (let idle = 0; inView.length && idle < inView.length && performance.now() - now < BUDGET_ms; ++first)
      idle = inView[first % inView.length].work(now) ? 0 : idle + 1;
    while (chartSeen && performance.now() - now < BUDGET_ms && measurements.work());
    requestAnimationFrame(frame);
  };
  requestAnimationFrame(frame);
  globalThis.Article = {engine, figures, measurements};  // for tests
  document.documentElement.classList.add("opened");
};

open().catch(error => {
  document.getElementById("fault").textContent = `The figures stay still: ${error.message}.`;
  throw error;
});
