// Opens the module, makes the figures of the page, and shares the time of a frame among those in view.
const BUDGET_ms = 13;  // of work a frame, so that a slider's next picture comes in time

const unpacked = async name => {
  const packed = Uint8Array.from(atob(document.getElementById(name).textContent), letter => letter.charCodeAt(0));
  return new Uint8Array(await new Response(new Blob([packed]).stream().pipeThrough(new DecompressionStream("gzip"))).arrayBuffer());
};

// The strip and the chart below the figure with all dials, measured anew when it has rested, and the figure of a dot.
class Measurements {
  constructor(engine, figure, dotFigure) {
    Object.assign(this, {engine, figure, dotFigure, chartEye: "", stripView: "", running: null});
  }

  *measureStrip(view) {
    document.getElementById("strip-table").innerHTML = stripTable(yield* stepsOfError(this.engine, view), this.engine);
  }

  *measureChart(view) {
    const marks = yield* marksOfSettings(this.engine, view), keep = ({values}) => this.turnDials(values);
    new Chart(document.getElementById("chart-dots"), marks, this.engine.processors[1].name, mark => this.preview(mark), keep);
    this.dotFigure.view.eye = [...view.eye];
    this.preview(marks.find(({name}) => name === "bounded"));
  }

  preview(mark) {
    document.getElementById("chart-said").textContent = wordsOf(mark);
    this.dotFigure.view.values = [...mark.values];
    this.dotFigure.change();
  }

  turnDials(values) {
    this.figure.view.values = [...values];
    this.figure.change();
  }

  // A step of what is to be measured; false: nothing.
  work() {
    const {rested, isTurning} = this.figure, {eye, values} = this.figure.view;
    if (isTurning || rested < 0.3) return false;
    const view = {values: [...values], eye: [...eye]}, place = eye.join(), whole = place + ":" + values.join();
    if (this.running && this.running.whole !== whole) this.running = null;  // of another view
    if (!this.running && this.stripView !== whole) this.running = {whole, name: "stripView", is: whole, steps: this.measureStrip(view)};
    if (!this.running && this.chartEye !== place) this.running = {whole, name: "chartEye", is: place, steps: this.measureChart(view)};
    if (!this.running) return false;
    if (this.running.steps.next().done) {
      this[this.running.name] = this.running.is;
      this.running = null;
    }
    return true;
  }
}

const openPage = async () => {
  if (!globalThis.WebAssembly) throw new Error("this browser has no WebAssembly");
  const module = await openArticle({wasmBinary: await unpacked("article.wasm")});
  const engine = new Engine(module, await unpacked("article.bsp"), await unpacked("palette.lmp"));
  const clock = {processor: null};  // whose pace turning views keep; null: this device's
  const figures = FIGURES.map(definition => new Figure(engine, definition, document.getElementById("figure-" + definition.id), clock));
  const measurements = new Measurements(engine, ...figures.slice(-2));
  const machine = document.getElementById("machine");
  machine.append(...["this device", ...engine.processors.map(one => one.name)].map(name => element("option", {}, name)));
  machine.onchange = () => { clock.processor = machine.selectedIndex ? machine.selectedIndex - 1 : null; };
  const seen = new IntersectionObserver(entries => entries.forEach(entry => {
    figures.find(figure => figure.place === entry.target).isInView = entry.isIntersecting;
  }), {rootMargin: "100px"});
  figures.forEach(figure => seen.observe(figure.place));
  let chartSeen = false;
  new IntersectionObserver(([entry]) => { chartSeen = entry.isIntersecting; }, {rootMargin: "400px"}).observe(document.getElementById("measured"));

  let before = performance.now(), first = 0;
  const frame = now => {
    const seconds = Math.min(0.25, (now - before) / 1000), inView = figures.filter(figure => figure.isInView);
    before = now;
    for (const figure of figures) figure.rested += seconds;
    for (const figure of inView) {
      figure.turn(now, seconds);
      if (figure.due.picture) figure.draw(now);
    }
    // The rest in turn, as far as there is time.
    const left_ms = () => BUDGET_ms - (performance.now() - now);
    for (let idle = 0; idle < inView.length && left_ms() > 0; ++first) idle = inView[first % inView.length].work(left_ms()) ? 0 : idle + 1;
    while (chartSeen && left_ms() > 0 && measurements.work());
    requestAnimationFrame(frame);
  };
  requestAnimationFrame(frame);
  globalThis.Article = {engine, figures, measurements};  // for tests
  document.documentElement.classList.add("opened");
  const named = location.hash && document.getElementById(location.hash.slice(1));
  if (named) named.scrollIntoView();  // figures are taller than the pictures that they replace
};

openPage().catch(error => {
  document.getElementById("fault").textContent = `The figures stay still: ${error.message}.`;
});
