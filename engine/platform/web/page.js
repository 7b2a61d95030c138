"use strict";
// The JavaScript part of engine/platform/web: input and full screen; the other scripts do picture, gamepads, touch and
// sound. Called by page.cpp.

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

// The buttons on a touch screen, and the keys that they press.
const TOUCH_BUTTONS = [["menu", KEYS.Escape], ["jump", KEYS.Space], ["exhibit", KEYS.KeyV], ["accept", KEYS.Enter], ["dials", KEYS.F7],
                       ["above", KEYS.ArrowUp], ["below", KEYS.ArrowDown], ["less", KEYS.ArrowLeft], ["more", KEYS.ArrowRight]];

const Page = globalThis.Page = {
  canvas: document.getElementById("screen"),
  events: [],
  text: "",  // typed, as PlatformInput has it
  pointer: null,  // {x, y, hasMoved, isPressed} in the canvas' pixels; null while the mouse is captured or elsewhere
  isCaptured: false,  // the game wants the mouse
  isLockRefused: !HTMLCanvasElement.prototype.requestPointerLock,  // then the mouse turns the view while it is in the canvas
  changesFullScreen: false,
  fillsScreen: false,
  isCovered: false,  // something else in the page has the keys
  letters: null,  // the keyboard's layout, if the browser reports it
  hasTouch: !matchMedia("(any-pointer: fine)").matches,  // touch, not a mouse, was used last

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
    if (this.events.length > 4096) this.events.splice(0, 1024);  // not polled for a long time
  },
  tap(device, code) {
    for (const kind of [Kind.Press, Kind.Release]) this.note(kind, device, code);
  },

  // The state that the program polls for each picture. Offsets are in 32-bit words.
  state(words, at) {
    Pads.follow();
    const pointer = this.isCaptured ? null : this.pointer;
    const {x, y, hasMoved, isPressed} = pointer || {};
    words.set([document.hasFocus(), document.hidden, this.changesFullScreen, pointer !== null, x, y, hasMoved, isPressed,
               this.events.length], at);  // true is 1; false and undefined are 0
    this.changesFullScreen = false;
    if (this.pointer) this.pointer.hasMoved = this.pointer.isPressed = false;
  },
  takeEvents(words, at) {
    words.set(this.events.flat(), at);
    this.events = [];
  },
  takeText(most) {
    const text = this.text.slice(0, most);
    this.text = "";
    return text;
  },

  takeLost() {
    const isLost = this.screen.isLost;
    this.screen.isLost = false;
    return isLost;
  },

  // What the button for a key says, while touch is in use.
  buttonOf(key) {
    const button = this.hasTouch && TOUCH_BUTTONS.find(([, pressed]) => pressed === key);
    return button ? document.getElementById(button[0]).textContent : "";
  },
  letter(key) {
    const code = Object.keys(KEYS).find(name => KEYS[name] === key);
    const letter = key <= 56 && this.letters && this.letters.get(code);
    return letter && letter.length === 1 ? letter.charCodeAt(0) : 0;
  },

  // In pixels of the device, whatever the browser's zoom.
  followSize() {
    const canvas = this.canvas;
    // The browser's exact size differs from the product only by rounding.
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
      if (key === undefined || event.metaKey || this.isCovered) return;
      event.preventDefault();
      if (event.code === "Escape" && this.isSecondEscape()) return;
      if (event.altKey && event.code === "Enter") {
        if (!event.repeat) this.changesFullScreen = true;
        return;
      }
      this.note(event.repeat ? Kind.Repeat : Kind.Press, Device.Key, key);
      const isLetter = [...event.key].length === 1 && (!event.ctrlKey || event.altKey);
      this.text += {Backspace: "\b", Enter: "\n"}[event.key] || (isLetter ? event.key : "");
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

  // A mouse that turns the view cannot leave the canvas. Browsers allow that only after a key or a click, and end it on
  // Escape without a key event: the end is then taken as that key.
  capture(isCaptured) {
    if (isCaptured === this.isCaptured) return;
    this.isCaptured = isCaptured;
    this.pointer = null;
    Touch.release();
    this.note(Kind.ReleasePressed);
    document.body.classList.toggle("walks", isCaptured);
    if (isCaptured) this.lockPointer();
    else if (document.pointerLockElement) document.exitPointerLock();
  },
  // Some browsers also report the key.
  isSecondEscape() {
    const before_ms = this.escape_ms || -1000;
    this.escape_ms = performance.now();
    return this.escape_ms - before_ms < 100;
  },
  lockPointer() {
    if (this.hasTouch || !this.canvas.requestPointerLock) return;
    const asked = this.canvas.requestPointerLock();
    if (asked) asked.catch(() => {});  // pointerlockerror reports it, too
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
      if (this.hasTouch) return Touch.begin(event);
      if (this.isCaptured) {
        if (this.turnsView()) this.note(Kind.Press, Device.MouseButton, BUTTONS[event.button]);
        if (document.pointerLockElement !== canvas) this.lockPointer();
        return;
      }
      this.point(event);
      this.pointer.isPressed ||= event.button === 0;
      this.note(Kind.Click, Device.MouseButton, BUTTONS[event.button]);
    });
    // If several buttons are held, browsers report all but the first as pointermove.
    canvas.addEventListener("mousedown", event => {
      if (event.buttons & event.buttons - 1 && (this.turnsView() || !this.isCaptured))
        this.note(this.isCaptured ? Kind.Press : Kind.Click, Device.MouseButton, BUTTONS[event.button]);
    });
    addEventListener("mouseup", event => this.note(Kind.Release, Device.MouseButton, BUTTONS[event.button]));
    canvas.addEventListener("pointermove", event => {
      if (event.pointerType === "touch") return Touch.move(event);
      if (!this.isCaptured) return this.point(event);
      if (this.turnsView()) this.note(Kind.MouseMotion, 0, 0, event.movementX, event.movementY);
    });
    for (const end of ["pointerup", "pointercancel"])
      canvas.addEventListener(end, event => { if (event.pointerType === "touch") Touch.end(event); });
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
    // The lab's dials as a drawer: the buttons that turn them.
    document.getElementById("dials").addEventListener("pointerdown", () => document.body.classList.toggle("drawer"));
    for (const [id, key] of TOUCH_BUTTONS) {
      const button = document.getElementById(id);
      button.addEventListener("pointerdown", event => { event.preventDefault(); this.note(Kind.Press, Device.Key, key); });
      for (const end of ["pointerup", "pointercancel", "pointerleave"])
        button.addEventListener(end, () => this.note(Kind.Release, Device.Key, key));
    }
  },

  // Both halves of an axis from -1 to 1; the code of the positive half is odd.
  noteAxis(axis, value, ofEach = 0) {
    const raw = Math.round(Math.max(-1, Math.min(1, value)) * FULL_AXIS);
    this.note(Kind.Axis, Device.PadAxis, ofEach + 2 * axis + 1, raw);
    this.note(Kind.Axis, Device.PadAxis, ofEach + 2 * axis, -raw);
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
