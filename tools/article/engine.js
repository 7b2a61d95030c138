// The module (exports.cpp) as an object: frames, errors and costs of a view, which is {values: of all dials, eye: [x, y, z,
// yaw, pitch, roll, field of view], drawnTall}. Pictures are RGBA, and stay valid until the next one.
class Engine {
  constructor(module, level, palette) {
    this.module = module;
    const put = bytes => {
      const at = module._malloc(bytes.length);
      module.HEAPU8.set(bytes, at);
      return at;
    };
    const fault = module.UTF8ToString(module._article_open(put(level), level.length, put(palette), palette.length));
    if (fault) throw new Error(fault);
    Object.assign(this, JSON.parse(module.UTF8ToString(module._article_choices())));
    this.now = {values: [], eye: [], drawnTall: true};  // what the module stands at
  }

  pictureAt(pointer) {
    return new Uint8ClampedArray(this.module.HEAPU8.buffer, pointer, this.width * this.height * 4);
  }

  look({values, eye, drawnTall = true}) {
    values.forEach((value, dial) => value === this.now.values[dial] || this.module._article_dial(dial, value));
    if (drawnTall !== this.now.drawnTall) this.module._article_aspect(drawnTall);
    if (eye.some((value, i) => value !== this.now.eye[i]) && !this.module._article_look(...eye)) throw new Error("an eye in a wall: " + eye);
    this.now = {values: [...values], eye: [...eye], drawnTall};
  }

  figures() {
    return JSON.parse(this.module.UTF8ToString(this.module._article_figures()));
  }

  // {picture, instructions, instructions486, cycles: of each of `processors`}
  draw(view) {
    this.look(view);
    const picture = this.pictureAt(this.module._article_draw());
    return {picture, ...this.figures()};
  }

  // {picture: a map, rms, p99, max} by the measure of this number.
  errors(view, measure) {
    this.look(view);
    const picture = this.pictureAt(this.module._article_errors(measure));
    return {picture, ...this.figures()};
  }

  reference(view) {
    this.look(view);
    return {picture: this.pictureAt(this.module._article_reference())};
  }

  milliseconds(processor, cycles) {
    return cycles[processor] / this.processors[processor].megahertz / 1000;
  }

  dial(name) {
    return this.dials.findIndex(dial => dial.name === name);
  }

  // Values of a preset, with settings of dials by their names.
  values(preset, settings = {}) {
    const values = [...this.presets.find(one => one.name === preset).values];
    for (const [name, setting] of Object.entries(settings)) {
      const dial = this.dial(name);
      values[dial] = this.dials[dial].settings.find(one => one.name === setting).value;
    }
    return values;
  }

  // The view that a figure of figures.json begins with.
  startOf(figure) {
    return {values: this.values(figure.preset, figure.set), eye: [...figure.eye], drawnTall: true};
  }

  measure(name) {
    return this.measures.findIndex(measure => measure.name === name);
  }
}
