// Gamepads with the standard layout; the one used last is active.
const Pads = {
  before: new Map(),  // by index: the last values of buttons and axes
  used: -1,
  // From the standard layout's buttons to PadButton; its two triggers are axes here.
  BUTTONS: [0, 1, 2, 3, 9, 10, -4, -5, 4, 6, 7, 8, 11, 12, 13, 14, 5],
  ofBrowser() {
    try {
      return navigator.getGamepads();
    } catch (error) {
      return [];  // not allowed in a frame of another page
    }
  },
  follow() {
    const there = new Map();
    for (const pad of this.ofBrowser()) {
      if (!pad || !pad.connected || pad.mapping !== "standard") continue;
      const before = this.before.get(pad.index) || {buttons: [], axes: []};
      const now = {buttons: pad.buttons.map(button => button.value), axes: pad.axes.slice(0, 4)};
      there.set(pad.index, now);
      const ofEach = 256 * (pad.index + 1);  // added to codes of events of this pad by itself
      now.axes.forEach((value, i) => {
        if (value !== (before.axes[i] || 0)) Page.noteAxis(i, value, ofEach);
        const isOther = this.used >= 0 && this.used !== pad.index;
        if (value === (before.axes[i] || 0) || (isOther && Math.abs(value) < 0.5)) return;
        this.use(pad.index);
        Page.noteAxis(i, value);
      });
      now.buttons.forEach((value, i) => {
        const button = this.BUTTONS[i], was = before.buttons[i] || 0;
        if (button === undefined || value === was) return;
        this.use(pad.index);
        for (const each of [0, ofEach])
          if (button < 0) Page.noteAxis(-button, value, each);
          else if ((value > 0.5) !== (was > 0.5)) Page.note(value > 0.5 ? Kind.Press : Kind.Release, Device.PadButton, button + each);
      });
    }
    if (this.used >= 0 && !there.has(this.used)) this.use(-1);
    for (const index of this.before.keys())
      if (!there.has(index)) Page.note(Kind.ReleasePad, Device.PadButton, 256 * (index + 1));
    this.before = there;
  },
  use(index) {
    if (this.used !== index) Page.note(Kind.ReleasePad);
    this.used = index;
  },
};
