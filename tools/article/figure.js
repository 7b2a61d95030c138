// A figure: pictures of one view, the controls that change it, and what it costs. What takes time is left to
// its work(), so that a moving slider gets a picture each frame, and maps and exact pictures as soon as there is time.
const element = (tag, attributes = {}, ...content) => {
  const made = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes))
    if (typeof value === "function") made.addEventListener(name, value);
    else if (value !== null) made.setAttribute(name, value);
  made.append(...content);
  return made;
};

const PARTS = {picture: "drawn with these dials", reference: "exact, by a renderer in doubles", errors: "the error of each pixel"};
const ASKED = {  // of the eye: place in view.eye, least, greatest, caption
  yaw: [3, -15, 15, "turned left or right, degrees", true], pitch: [4, -30, 30, "looking up or down, degrees"],
  roll: [5, -45, 45, "leaning, degrees"], field: [6, 20, 150, "field of view, degrees"],
};

const took_ms = {errors: 12, reference: 16};  // of late, of any figure
const LATE_ms = 120;  // how long these wait while a slider moves

class Figure {
  constructor(engine, definition, place, clock) {
    Object.assign(this, {engine, definition, place, clock, isInView: false, due: {}, heldUntil: 0, isTurning: false, rested: 0});
    this.view = engine.startOf(definition);
    this.measure = engine.measure(definition.measure || "displacement");
    this.controls = [];  // what shows a control's state again
    this.parts = {};
    place.replaceChildren(this.pictures(), this.key(), this.readout = element("p", {class: "readout"}), this.form());
    this.change();
  }

  pictures() {
    const box = element("div", {class: "pictures"});
    for (const name of this.definition.shows || Object.keys(PARTS)) {
      const canvas = element("canvas", {width: this.engine.width, height: this.engine.height, role: "img",
                                        "aria-label": `${this.definition.alt}: ${PARTS[name]}`});
      const caption = element("figcaption", {}, PARTS[name]);
      this.parts[name] = {canvas, caption, pen: canvas.getContext("2d")};
      box.append(element("figure", {class: name}, canvas, caption));
    }
    return box;
  }

  // For narrow screens, where pictures have no captions.
  key() {
    const places = [["left: drawn"], ["right: exact", "reference"], ["below it: errors, bright is more", "errors"]];
    return element("p", {class: "key soft"}, places.filter(([, name]) => !name || this.parts[name]).map(([words]) => words).join(", "));
  }

  // ---- controls

  form() {
    const form = element("div", {class: this.definition.sway ? "dials" : ""});
    const {asks = [], dials = []} = this.definition, {engine} = this;
    if (asks.includes("preset")) form.append(this.presetChoice());
    for (const name of dials === "all" ? engine.dials.map(dial => dial.name) : dials) form.append(this.dialSlider(engine.dial(name)));
    for (const name of asks) if (ASKED[name]) form.append(this.eyeSlider(name));
    if (asks.includes("drawnTall"))
      form.append(this.box("drawn for tall pixels", () => this.view.drawnTall, value => { this.view.drawnTall = value; }));
    if (asks.includes("shownTall")) form.append(this.box("shown with tall pixels", () => !this.place.classList.contains("square"),
                                                         value => this.place.classList.toggle("square", !value)));
    if (asks.includes("measure")) form.append(this.measureChoice());
    if (this.definition.sway) form.append(this.turnButton());
    return form;
  }

  labelled(caption, input, about = null) {
    const shown = element("output");
    this.controls.push(() => { shown.textContent = input.getAttribute("aria-valuetext") || ""; });
    return element("label", {title: about}, element("span", {}, caption, shown), input);
  }

  slider(caption, attributes, put, show, about = null) {
    const input = element("input", {type: "range", ...attributes, input: () => { put(Number(input.value)); this.change(); }});
    this.controls.push(() => show(input));
    return this.labelled(caption, input, about);
  }

  dialSlider(index) {
    const dial = this.engine.dials[index];
    const put = at => { this.view.values[index] = dial.settings[at].value; };
    const show = input => {
      const at = dial.settings.findIndex(setting => setting.value === this.view.values[index]);
      input.value = at;
      input.setAttribute("aria-valuetext", dial.settings[at].name);
    };
    return this.slider(dial.caption, {min: 0, max: dial.settings.length - 1, step: 1, "data-dial": dial.name}, put, show, dial.about);
  }

  eyeSlider(name) {
    const [place, least, greatest, caption, isRelative] = ASKED[name], base = isRelative ? this.definition.eye[place] : 0;
    const put = value => {
      this.view.eye[place] = base + value;
      if (name === "yaw") this.middle = this.view.eye[place];
    };
    const show = input => {
      input.value = this.view.eye[place] - base;
      input.setAttribute("aria-valuetext", number(Number(input.value)));
    };
    return this.slider(caption, {min: least, max: greatest, step: place === 6 ? 1 : 0.1, "data-eye": name}, put, show);
  }

  box(caption, get, put) {
    const input = element("input", {type: "checkbox", change: () => { put(input.checked); this.change(); }});
    this.controls.push(() => { input.checked = get(); });
    return element("label", {class: "box"}, input, caption);
  }

  choice(caption, names, get, put) {
    const select = element("select", {change: () => { put(select.value); this.change(); }}, ...names.map(name => element("option", {}, name)));
    this.controls.push(() => { select.value = get(); });
    return element("label", {}, element("span", {}, caption), select);
  }

  presetChoice() {
    const {presets} = this.engine, own = "your own";
    const get = () => (presets.find(one => one.values.join() === this.view.values.join()) || {name: own}).name;
    const put = name => { if (name !== own) this.view.values = this.engine.values(name); };
    return this.choice("preset", [...presets.map(one => one.name), own], get, put);
  }

  measureChoice() {
    const {measures} = this.engine, names = measures.map(measure => measure.name.replace("_", " "));
    return this.choice("the map shows", names, () => names[this.measure], name => { this.measure = names.indexOf(name); });
  }

  turnButton() {
    const button = element("button", {type: "button", "aria-pressed": "false", click: () => {
      this.isTurning = !this.isTurning;
      this.turned = 0;
      if (this.isTurning) this.middle = this.view.eye[3];
      else this.view.eye[3] = this.middle;
      button.setAttribute("aria-pressed", this.isTurning);
      this.change();
    }}, "turn the view");
    return button;
  }

  // ---- drawing

  change() {
    const seen = this.view.eye.join() + this.view.drawnTall;  // all that the exact picture depends on
    for (const part of Object.keys(this.parts))
      if (part !== "reference" || seen !== this.seen) this.due[part] = this.due[part] || performance.now();
    this.seen = seen;
    this.rested = 0;
    for (const show of this.controls) show();
  }

  // The eye sways about where it was, and each picture stays for as long as its machine would take for the next.
  turn(now, seconds) {
    if (!this.isTurning) return;
    this.turned += seconds;
    if (now < this.heldUntil) return;
    this.view.eye[3] = this.middle + this.definition.sway * Math.sin(this.turned / 2);
    this.change();
  }

  // A map or an exact picture, if one is due and fits into so many milliseconds, or has been due for long. False: nothing was done.
  work(left_ms) {
    const isLate = name => left_ms > 0 && performance.now() - this.due[name] > LATE_ms;
    const isNext = one => this.due[one] && (took_ms[one] < left_ms || isLate(one)) && (one !== "errors" || this.isReady());
    const name = ["errors", "reference"].find(isNext);
    if (!name) return false;
    const before = performance.now();
    if (name === "errors") this.drawErrors();
    else this.paint(name, this.engine.reference(this.view).picture);
    took_ms[name] += (performance.now() - before - took_ms[name]) / 4;
    return true;
  }

  // Other maps than displacement's need what is exact first: too long for a moving view.
  isReady() {
    return this.measure === 0 || (!this.isTurning && this.rested > 0.15);
  }

  paint(name, picture) {
    this.due[name] = 0;
    this.parts[name].pen.putImageData(new ImageData(picture, this.engine.width), 0, 0);
  }

  draw(now) {
    const frame = this.engine.draw(this.view);
    this.cost = frame;
    this.heldUntil = now + (this.clock.processor === null ? 0 : this.engine.milliseconds(this.clock.processor, frame.cycles));
    this.say();
    this.paint("picture", frame.picture);
  }

  drawErrors() {
    const errors = this.engine.errors(this.view, this.measure), {least, greatest} = this.engine.measures[this.measure];
    this.error = {...errors, measure: this.measure};
    this.parts.errors.caption.textContent = `${PARTS.errors}: dark ${least}, bright ${greatest}, grey not measured`;
    this.paint("errors", errors.picture);
    this.say();
  }

  errorText() {
    if (!this.error || this.error.measure !== this.measure) return "";
    const {unit, share} = this.engine.measures[this.measure], {rms, max} = this.error;
    return share ? `${number(rms)} ${unit}. ` : `Error: ${number(rms)} ${unit} (rms), ${number(max)} at most. `;
  }

  say() {
    const {instructions486, cycles} = this.cost, {engine} = this;
    const times = engine.processors.map(({name}, p) => `${name}: ${number(engine.milliseconds(p, cycles))} ms`);
    this.readout.textContent = `${this.errorText()}Cost: ${instructions486.toLocaleString("en-US")} instructions; ${times.join(", ")}.`;
  }
}
