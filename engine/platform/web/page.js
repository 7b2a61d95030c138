"use strict";
// What of engine/platform/web only the browser can do: input, the picture, the whole screen, sound. page.cpp asks it.

// The numbers of InputEvent::Kind and Device.
const Kind = {Press: 0, Repeat: 1, Release: 2, Click: 3, Axis: 4, MouseMotion: 5, ReleasePressed: 6, ReleasePad: 7, ReleaseAll: 8};
const Device = {Key: 0, MouseButton: 1, MouseWheel: 2, PadButton: 3, PadAxis: 4};
const FULL_AXIS = 32767;

// From KeyboardEvent.code to a USB HID usage.
const KEYS = {
  Enter: 40, Escape: 41, Backspace: 42, Tab: 43, Space: 44, Minus: 45, Equal: 46, BracketLeft: 47, BracketRight: 48,
  Backslash: 49, Semicolon: 51, Quote: 52, Backquote: 53, Comma: 54, Period: 55, Slash: 56, CapsLock: 57, PrintScreen: 70,
  ScrollLock: 71, Pause: 72, Insert: 73, Home: 74, PageUp: 75, Delete: 76, End: 77, PageDown: 78, ArrowRight: 79,
  ArrowLeft: 80, ArrowDown: 81, ArrowUp: 82, NumLock: 83, NumpadDivide: 84, NumpadMultiply: 85, NumpadSubtract: 86,
  NumpadAdd: 87, NumpadEnter: 88, Numpad0: 98, NumpadDecimal: 99, IntlBackslash: 100, ContextMenu: 101, ControlLeft: 224,
  ShiftLeft: 225, AltLeft: 226, MetaLeft: 227, ControlRight: 228, ShiftRight: 229, AltRight: 230, MetaRight: 231};
for (let i = 0; i < 26; ++i) KEYS["Key" + String.fromCharCode(65 + i)] = 4 + i;
for (let i = 0; i < 10; ++i) KEYS["Digit" + (i + 1) % 10] = 30 + i;
for (let i = 1; i < 10; ++i) KEYS["Numpad" + i] = 88 + i;
for (let i = 1; i < 13; ++i) KEYS["F" + i] = 57 + i;

// What the canvas shows, without WebGL: all but the look of a tube.
class Screen {
  constructor(canvas) {
    this.canvas = canvas;
    this.shown = 0;
    document.addEventListener("visibilitychange", () => { this.isLost = true; });
    this.open();
  }

  open() {
    const context = () => document.createElement("canvas").getContext("2d");
    [this.picture, this.multiple, this.context] = [context(), context(), this.canvas.getContext("2d", {alpha: false})];
  }

  setMask() {}

  // pixels: red, green, blue, 255. rect: x, y, width, height in the canvas, and by how much columns and rows are multiplied first.
  present(pixels, width, height, rect, ...look) {
    if (++this.shown === 1) {
      this.first_ms = performance.now();
      document.body.classList.remove("loads");
    }
    this.draw(pixels, width, height, rect, ...look);
  }

  draw(pixels, width, height, rect, isBlended) {
    const {picture, multiple, context} = this, wide = width * rect[4], high = height * rect[5];
    Object.assign(picture.canvas, {width, height});
    picture.putImageData(new ImageData(new Uint8ClampedArray(pixels), width, height), 0, 0);
    Object.assign(multiple.canvas, {width: wide, height: high});
    multiple.imageSmoothingEnabled = false;
    multiple.drawImage(picture.canvas, 0, 0, wide, high);
    context.fillRect(0, 0, this.canvas.width, this.canvas.height);
    context.imageSmoothingEnabled = isBlended;
    context.drawImage(multiple.canvas, rect[0], rect[1], rect[2], rect[3]);
  }
}

// By WebGL, with the same scaling as SDL's window has.
class GlScreen extends Screen {
  static context(canvas) {
    return canvas.getContext("webgl", {alpha: false, antialias: false, depth: false});
  }

  constructor(canvas) {
    super(canvas);
    canvas.addEventListener("webglcontextlost", event => { event.preventDefault(); this.gl = null; });
    canvas.addEventListener("webglcontextrestored", () => this.open());
  }

  open() {
    const gl = this.gl = GlScreen.context(this.canvas), program = gl.createProgram();
    const add = (kind, source) => {
      const shader = gl.createShader(kind);
      gl.shaderSource(shader, source);
      gl.compileShader(shader);
      gl.attachShader(program, shader);
    };
    add(gl.VERTEX_SHADER, `
      attribute vec2 corner;
      varying vec2 at;
      void main() { at = vec2(corner.x + 1.0, 1.0 - corner.y) / 2.0; gl_Position = vec4(corner, 0.0, 1.0); }`);
    add(gl.FRAGMENT_SHADER, `
      precision highp float;
      varying vec2 at;
      uniform sampler2D picture, mask;
      uniform vec2 size, upscale;
      uniform bool is_blended, has_crt_look;
      vec3 mean_of_four(vec2 place) {
        return texture2D(picture, (clamp(place, vec2(0.0), floor(size / 2.0) - 1.0) * 2.0 + 1.0) / size).rgb;
      }
      void main() {
        vec2 texel = floor(at * size);
        if (is_blended) {  // whole multiples first, then one linear step, which is the texture's own
          vec2 place = at * size * upscale - 0.5, first = floor(place);
          vec2 a = floor((first + 0.25) / upscale), b = floor((first + 1.25) / upscale);
          texel = a + (b - a) * (place - first);
        }
        vec3 colour = texture2D(picture, (texel + 0.5) / size).rgb;
        if (has_crt_look) {  // the mask, and the glow of a copy of half the size
          vec2 place = at * size / 2.0 - 0.5, a = floor(place), share = place - a, b = a + 1.0;
          vec3 glow = mix(mix(mean_of_four(a), mean_of_four(vec2(b.x, a.y)), share.x),
                          mix(mean_of_four(vec2(a.x, b.y)), mean_of_four(b), share.x), share.y);
          colour = colour * texture2D(mask, at).bgr + glow * 90.0 / 255.0;
        }
        gl_FragColor = vec4(colour, 1.0);
      }`);
    gl.linkProgram(program);
    if (!gl.getProgramParameter(program, gl.LINK_STATUS)) throw new Error("WebGL: " + gl.getProgramInfoLog(program));
    gl.useProgram(program);
    gl.bindBuffer(gl.ARRAY_BUFFER, gl.createBuffer());
    gl.bufferData(gl.ARRAY_BUFFER, new Float32Array([-1, -1, 3, -1, -1, 3]), gl.STATIC_DRAW);
    const corner = gl.getAttribLocation(program, "corner");
    gl.enableVertexAttribArray(corner);
    gl.vertexAttribPointer(corner, 2, gl.FLOAT, false, 0, 0);
    this.place = name => gl.getUniformLocation(program, name);
    ["mask", "picture"].forEach((name, unit) => {  // the last one stays the active one
      gl.activeTexture(gl.TEXTURE0 + unit);
      gl.bindTexture(gl.TEXTURE_2D, gl.createTexture());
      for (const filter of [gl.TEXTURE_MIN_FILTER, gl.TEXTURE_MAG_FILTER]) gl.texParameteri(gl.TEXTURE_2D, filter, unit ? gl.LINEAR : gl.NEAREST);
      for (const wrap of [gl.TEXTURE_WRAP_S, gl.TEXTURE_WRAP_T]) gl.texParameteri(gl.TEXTURE_2D, wrap, gl.CLAMP_TO_EDGE);
      gl.uniform1i(this.place(name), unit);
    });
    this.places = Object.fromEntries(["size", "upscale", "is_blended", "has_crt_look"].map(name => [name, this.place(name)]));
    this.width = this.height = 0;  // of the texture
    this.isLost = true;  // what the canvas showed
    if (this.mask) this.setMask(...this.mask);
  }

  setMask(pixels, width, height) {
    const gl = this.gl;
    this.mask = [pixels.slice(), width, height];
    if (!gl) return;
    gl.activeTexture(gl.TEXTURE0);
    gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA, width, height, 0, gl.RGBA, gl.UNSIGNED_BYTE, pixels);
    gl.activeTexture(gl.TEXTURE1);
  }

  draw(pixels, width, height, rect, isBlended, hasCrtLook) {
    const gl = this.gl;
    if (!gl) return;
    if (this.width === width && this.height === height) {
      gl.texSubImage2D(gl.TEXTURE_2D, 0, 0, 0, width, height, gl.RGBA, gl.UNSIGNED_BYTE, pixels);
    } else {
      gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA, width, height, 0, gl.RGBA, gl.UNSIGNED_BYTE, pixels);
      [this.width, this.height] = [width, height];
      gl.uniform2f(this.places.size, width, height);
    }
    gl.uniform2f(this.places.upscale, rect[4], rect[5]);
    gl.uniform1i(this.places.is_blended, isBlended ? 1 : 0);
    gl.uniform1i(this.places.has_crt_look, hasCrtLook ? 1 : 0);
    gl.clear(gl.COLOR_BUFFER_BIT);
    gl.viewport(rect[0], this.canvas.height - rect[1] - rect[3], rect[2], rect[3]);
    gl.drawArrays(gl.TRIANGLES, 0, 3);
  }
}

// Samples that the program mixes, a few hundredths of a second ahead of what is heard.
class Sound {
  constructor() {
    this.context = new AudioContext({sampleRate: 44100, latencyHint: "interactive"});
    this.end = 0;  // of what has been mixed, seconds of the context's clock
    this.closed = new AbortController();
    const start = () => { if (!document.hidden) this.context.resume(); };
    const follow = (event, act) => addEventListener(event, act, {capture: true, signal: this.closed.signal});
    for (const event of ["keydown", "pointerdown", "pointerup"]) follow(event, start);
    follow("visibilitychange", () => document.hidden ? this.context.suspend() : start());
  }

  // mix(frames) returns so many pairs of 16-bit samples, left and right.
  play(mix) {
    const AHEAD_s = 0.08, FRAMES = 882;
    const goOn = () => {
      if (this.context.state !== "running") return;
      const now = this.context.currentTime;
      if (this.end < now) this.end = now + 0.02;
      while (this.end < now + AHEAD_s) {
        const samples = mix(FRAMES), buffer = this.context.createBuffer(2, FRAMES, 44100);
        for (let side = 0; side < 2; ++side) {
          const to = buffer.getChannelData(side);
          for (let i = 0; i < FRAMES; ++i) to[i] = samples[2 * i + side] / 32768;
        }
        const source = this.context.createBufferSource();
        source.buffer = buffer;
        source.connect(this.context.destination);
        source.start(this.end);
        this.end += FRAMES / 44100;
      }
    };
    this.timer = setInterval(goOn, 10);
  }

  close() {
    clearInterval(this.timer);
    this.closed.abort();
    this.context.close();
  }
}

const Page = globalThis.Page = {
  canvas: document.getElementById("screen"),
  events: [],
  pointer: null,  // {x, y, hasMoved, isPressed} in the canvas' pixels; null while the mouse is captured or elsewhere
  isCaptured: false,  // the game wants the mouse
  isLockRefused: !HTMLCanvasElement.prototype.requestPointerLock,  // then it turns the view as long as it is in the canvas
  changesFullScreen: false,
  fillsScreen: false,
  letters: null,  // the keyboard's layout, where the browser tells
  hasTouch: !matchMedia("(any-pointer: fine)").matches,  // thumbs, not a mouse, were used last

  start() {
    this.screen = new (GlScreen.context(this.canvas) ? GlScreen : Screen)(this.canvas);
    this.followSize();
    this.followKeys();
    this.followPointers();
    if (navigator.keyboard && navigator.keyboard.getLayoutMap)
      navigator.keyboard.getLayoutMap().then(map => { this.letters = map; }, () => {});
  },

  note(kind, device = 0, code = 0, x = 0, y = 0) {
    this.events.push([kind, device, code, Math.trunc(x), Math.trunc(y)]);
    if (this.events.length > 4096) this.events.splice(0, 1024);  // nobody asked for a long time
  },
  tap(device, code) {
    for (const kind of [Kind.Press, Kind.Release]) this.note(kind, device, code);
  },

  // What the program asks at each picture. Offsets are in 32-bit words.
  state(words, at) {
    this.followPads();
    const pointer = this.isCaptured ? null : this.pointer;
    const {x, y, hasMoved, isPressed} = pointer || {};
    words.set([document.hasFocus(), document.hidden, this.changesFullScreen, pointer !== null, x, y, hasMoved, isPressed,
               this.events.length], at);  // true is 1; false, and what there is not, 0
    this.changesFullScreen = false;
    if (this.pointer) this.pointer.hasMoved = this.pointer.isPressed = false;
  },
  takeEvents(words, at) {
    words.set(this.events.flat(), at);
    this.events = [];
  },

  takeLost() {
    const isLost = this.screen.isLost;
    this.screen.isLost = false;
    return isLost;
  },

  letter(key) {
    const code = Object.keys(KEYS).find(name => KEYS[name] === key);
    const letter = key <= 56 && this.letters && this.letters.get(code);
    return letter && letter.length === 1 ? letter.toUpperCase().charCodeAt(0) : 0;
  },

  // In pixels of the device, whatever the browser's zoom.
  followSize() {
    const canvas = this.canvas;
    // The browser's own count differs from the product by its rounding alone.
    const nearest = (product, exact) => Math.max(1, Math.abs(product - exact) < 2 ? exact : Math.round(product));
    const fit = (exactWidth, exactHeight) => {
      canvas.width = nearest(canvas.clientWidth * devicePixelRatio, exactWidth);
      canvas.height = nearest(canvas.clientHeight * devicePixelRatio, exactHeight);
    };
    fit(0, 0);
    addEventListener("resize", () => fit(canvas.width, canvas.height));
    const observer = new ResizeObserver(entries => {
      const exact = entries[0].devicePixelContentBoxSize;
      exact ? fit(exact[0].inlineSize, exact[0].blockSize) : fit(0, 0);
    });
    try {
      observer.observe(this.canvas, {box: "device-pixel-content-box"});
    } catch (error) {
      observer.observe(this.canvas);
    }
  },

  followKeys() {
    addEventListener("keydown", event => {
      const key = KEYS[event.code];
      if (key === undefined || event.metaKey) return;
      event.preventDefault();
      if (event.code === "Escape" && this.isSecondEscape()) return;
      if (event.altKey && event.code === "Enter") {
        if (!event.repeat) this.changesFullScreen = true;
        return;
      }
      this.note(event.repeat ? Kind.Repeat : Kind.Press, Device.Key, key);
    });
    addEventListener("keyup", event => {
      if (KEYS[event.code] !== undefined) this.note(Kind.Release, Device.Key, KEYS[event.code]);
    });
    addEventListener("blur", () => this.note(Kind.ReleaseAll));
    document.addEventListener("fullscreenchange", () => {
      const fills = document.fullscreenElement !== null;
      if (fills && navigator.keyboard && navigator.keyboard.lock) navigator.keyboard.lock(["Escape"]).catch(() => {});
      if (fills !== this.fillsScreen) this.changesFullScreen = true;  // by the browser's own key
      this.fillsScreen = fills;
    });
  },

  fillScreen(fills) {
    this.fillsScreen = fills;
    const giveUp = () => { this.fillsScreen = false; this.changesFullScreen = true; };
    if (!fills) return document.fullscreenElement && document.exitFullscreen();
    if (!document.fullscreenEnabled) return giveUp();
    if (!document.fullscreenElement) document.documentElement.requestFullscreen().catch(giveUp);
  },

  // A mouse that turns the view can't leave the canvas. Browsers grant that after a key or a click alone, and take it
  // back by Escape, of which they say nothing else: it is that key then.
  capture(isCaptured) {
    if (isCaptured === this.isCaptured) return;
    this.isCaptured = isCaptured;
    this.pointer = null;
    this.touch.release();
    this.note(Kind.ReleasePressed);
    document.body.classList.toggle("walks", isCaptured);
    if (isCaptured) this.lockPointer();
    else if (document.pointerLockElement) document.exitPointerLock();
  },
  // Some browsers report the key as well.
  isSecondEscape() {
    const before_ms = this.escape_ms || -1000;
    this.escape_ms = performance.now();
    return this.escape_ms - before_ms < 100;
  },
  lockPointer() {
    if (this.hasTouch || !this.canvas.requestPointerLock) return;
    const asked = this.canvas.requestPointerLock();
    if (asked) asked.catch(() => {});  // pointerlockerror says it, too
  },
  turnsView() {
    return this.isCaptured && (document.pointerLockElement === this.canvas || this.isLockRefused);
  },

  place(event) {
    const box = this.canvas.getBoundingClientRect();
    return [Math.floor((event.clientX - box.left) * this.canvas.width / box.width),
            Math.floor((event.clientY - box.top) * this.canvas.height / box.height)];
  },

  point(event) {
    const [x, y] = this.place(event), before = this.pointer;
    const hasMoved = before !== null && (before.hasMoved || before.x !== x || before.y !== y);
    this.pointer = {x, y, hasMoved, isPressed: before !== null && before.isPressed};
  },

  followPointers() {
    const canvas = this.canvas, BUTTONS = [1, 3, 2, 4, 5];
    canvas.addEventListener("pointerdown", event => {
      event.preventDefault();
      canvas.focus();
      this.hasTouch = event.pointerType === "touch";
      if (this.hasTouch) return this.touch.begin(event);
      if (this.isCaptured) {
        if (this.turnsView()) this.note(Kind.Press, Device.MouseButton, BUTTONS[event.button]);
        if (document.pointerLockElement !== canvas) this.lockPointer();
        return;
      }
      this.point(event);
      this.pointer.isPressed ||= event.button === 0;
      this.note(Kind.Click, Device.MouseButton, BUTTONS[event.button]);
    });
    // Of several buttons, all but the first are reported as moves.
    canvas.addEventListener("mousedown", event => {
      if (event.buttons & event.buttons - 1 && this.turnsView())
        this.note(Kind.Press, Device.MouseButton, BUTTONS[event.button]);
    });
    addEventListener("mouseup", event => this.note(Kind.Release, Device.MouseButton, BUTTONS[event.button]));
    canvas.addEventListener("pointermove", event => {
      if (event.pointerType === "touch") return this.touch.move(event);
      if (!this.isCaptured) return this.point(event);
      if (this.turnsView()) this.note(Kind.MouseMotion, 0, 0, event.movementX, event.movementY);
    });
    for (const end of ["pointerup", "pointercancel"])
      canvas.addEventListener(end, event => { if (event.pointerType === "touch") this.touch.end(event); });
    canvas.addEventListener("pointerleave", event => { if (event.pointerType !== "touch") this.pointer = null; });
    canvas.addEventListener("wheel", event => {
      event.preventDefault();
      this.tap(Device.MouseWheel, event.deltaY !== 0 ? (event.deltaY < 0 ? 0 : 1) : event.deltaX < 0 ? 2 : 3);
    }, {passive: false});
    canvas.addEventListener("contextmenu", event => event.preventDefault());
    document.addEventListener("pointerlockerror", () => { this.isLockRefused = true; });
    document.addEventListener("pointerlockchange", () => {
      if (document.pointerLockElement) this.isLockRefused = false;
      else if (this.isCaptured && !this.hasTouch && !this.isSecondEscape()) this.tap(Device.Key, KEYS.Escape);
    });
    for (const [id, key] of [["menu", KEYS.Escape], ["jump", KEYS.Space]]) {
      const button = document.getElementById(id);
      button.addEventListener("pointerdown", event => { event.preventDefault(); this.note(Kind.Press, Device.Key, key); });
      for (const end of ["pointerup", "pointercancel", "pointerleave"])
        button.addEventListener(end, () => this.note(Kind.Release, Device.Key, key));
    }
  },

  // Two thumbs: the left one is a stick where it touches, the right one turns the view. In a menu a tap clicks, and a
  // thumb that moves is a wheel.
  touch: {
    thumbs: new Map(),
    begin(event) {
      if (document.pointerLockElement) document.exitPointerLock();  // it would take the touches
      document.body.classList.add("touched");
      const isStick = Page.isCaptured && event.clientX < innerWidth / 2;
      this.thumbs.set(event.pointerId, {isStick, isTap: !Page.isCaptured, x: event.clientX, y: event.clientY});
    },
    move(event) {
      const thumb = this.thumbs.get(event.pointerId);
      if (!thumb) return;
      const x = event.clientX - thumb.x, y = event.clientY - thumb.y;
      if (thumb.isStick) return this.push(x, y);
      if (!Page.isCaptured) return this.scroll(thumb, y);
      const PER_PIXEL = 3;  // a mouse's counts
      Page.note(Kind.MouseMotion, 0, 0, Math.round(x * PER_PIXEL), Math.round(y * PER_PIXEL));
      thumb.x = event.clientX;
      thumb.y = event.clientY;
    },
    end(event) {
      const thumb = this.thumbs.get(event.pointerId);
      this.thumbs.delete(event.pointerId);
      if (!thumb) return;
      if (thumb.isStick) this.push(0, 0);
      if (!thumb.isTap || event.type !== "pointerup") return;
      Page.point(event);
      Page.pointer.isPressed = true;
      Page.note(Kind.Click, Device.MouseButton, 1);
    },
    release() {
      if (this.thumbs.size > 0) this.push(0, 0);
      this.thumbs.clear();
    },
    scroll(thumb, y) {
      const ROW = 24;
      for (; Math.abs(y) >= ROW; y -= Math.sign(y) * ROW) {
        Page.tap(Device.MouseWheel, y > 0 ? 0 : 1);
        thumb.y += Math.sign(y) * ROW;
        thumb.isTap = false;
      }
    },
    push(x, y) {
      const RADIUS = 60;
      Page.noteAxis(0, x / RADIUS);
      Page.noteAxis(1, y / RADIUS);
    },
  },

  // Both halves of an axis from -1 to 1; the code of the positive half is odd.
  noteAxis(axis, value) {
    const raw = Math.round(Math.max(-1, Math.min(1, value)) * FULL_AXIS);
    this.note(Kind.Axis, Device.PadAxis, 2 * axis + 1, raw);
    this.note(Kind.Axis, Device.PadAxis, 2 * axis, -raw);
  },

  pads: new Map(),
  usedPad: -1,
  // From the standard layout's buttons to PadButton; its two triggers are axes here.
  PAD_BUTTONS: [0, 1, 2, 3, 9, 10, -4, -5, 4, 6, 7, 8, 11, 12, 13, 14, 5],
  padsOfBrowser() {
    try {
      return navigator.getGamepads();
    } catch (error) {
      return [];  // a frame of another page that may not
    }
  },
  followPads() {
    const there = new Map();
    for (const pad of this.padsOfBrowser()) {
      if (!pad || !pad.connected || pad.mapping !== "standard") continue;
      const before = this.pads.get(pad.index) || {buttons: [], axes: []};
      const now = {buttons: pad.buttons.map(button => button.value), axes: pad.axes.slice(0, 4)};
      there.set(pad.index, now);
      now.axes.forEach((value, i) => {
        const isOther = this.usedPad >= 0 && this.usedPad !== pad.index;
        if (value === (before.axes[i] || 0) || (isOther && Math.abs(value) < 0.5)) return;
        this.usePad(pad.index);
        this.noteAxis(i, value);
      });
      now.buttons.forEach((value, i) => {
        const button = this.PAD_BUTTONS[i], was = before.buttons[i] || 0;
        if (button === undefined || value === was) return;
        this.usePad(pad.index);
        if (button < 0) return this.noteAxis(-button, value);
        if ((value > 0.5) !== (was > 0.5)) this.note(value > 0.5 ? Kind.Press : Kind.Release, Device.PadButton, button);
      });
    }
    if (this.usedPad >= 0 && !there.has(this.usedPad)) this.usePad(-1);
    this.pads = there;
  },
  usePad(index) {
    if (this.usedPad !== index) this.note(Kind.ReleasePad);
    this.usedPad = index;
  },

  openSound(mix) {
    this.closeSound();
    this.sound = new Sound();
    this.sound.play(mix);
  },
  closeSound() {
    if (this.sound) this.sound.close();
    this.sound = null;
  },
};
