// Plays the page in headless Chromium, by its keys, a gamepad and touches, and compares it with the native game.
//   node play.cjs SITE NATIVE SCRATCH      SITE: the page's folder; NATIVE: what the game wrote of the recorded walk, its
//                                          pictures and walk.demo, recorded again; SCRATCH: for pictures to look at
"use strict";
const assert = require("assert"), fs = require("fs"), path = require("path"), {serve, readPng, run} = require("./chromium.cjs");

const [site, native, scratch] = process.argv.slice(2);
const file = name => path.join(scratch, name + ".png");
const MOVED = 0.3;  // of the pixels that differ: water and candles alone are less

// The bytes of each file that is kept, by its name; their names; and of those that differ from before.
const bytesOfSaves = tab => tab.evaluate(() => {
  const found = {}, look = folder => FS.readdir(folder).filter(name => !/^\.\.?$/.test(name)).forEach(name => {
    const file = folder + "/" + name;
    FS.isDir(FS.stat(file).mode) ? look(file) : found[file] = FS.readFile(file).join();
  });
  look("/save");
  return found;
});
const savesOf = async tab => Object.keys(await bytesOfSaves(tab));
const changedSaves = async (tab, before) => Object.entries(await bytesOfSaves(tab)).filter(([name, bytes]) => before[name] !== bytes).map(([name]) => name);

const bytesOf = async (tab, name) => Buffer.from(await tab.evaluate(name =>
  btoa(Array.from(FS.readFile(name), byte => String.fromCharCode(byte)).join("")), name), "base64");

// The hash of the state after each tick (game/simulation/demo.h).
const hashesOf = demo => {
  const HEAD = 28, TICK = 15;
  return Array.from({length: demo.readUInt32LE(24)}, (_, tick) => demo.readBigUInt64LE(HEAD + TICK * tick + 7).toString(16));
};

// Two thumbs, in the file that needs no server, nor others beside it.
const touch = async open => {
  const alone = path.resolve(scratch, "oblong.html");
  fs.copyFileSync(path.join(site, "oblong.html"), alone);
  const tab = await open("file://" + alone + "?/assets/demo.bsp",
                         {width: 900, height: 500, hasTouch: true, isMobile: true, deviceScaleFactor: 2});
  await tab.shows();
  await tab.until("Page.isCaptured", "a walk without a title");
  await tab.evaluate(() => {
    const note = Page.noteAxis;
    Page.axes = {};
    Page.noteAxis = function (axis, value, ofEach) { this.axes[axis] = value; note.call(this, axis, value, ofEach); };
  });
  await tab.evaluate("globalThis.before = seen");
  const thumb = await tab.page.touchscreen.touchStart(200, 300);
  await thumb.move(200, 240);
  await tab.until("Page.axes[0] === 0 && Page.axes[1] === -1", "the left thumb ahead");
  await tab.until(`different(seen, before) > ${MOVED}`, "the left thumb walks");
  await tab.shot(file("touch"));
  assert.deepStrictEqual(await tab.evaluate("[KEYS.Escape, KEYS.Space, KEYS.KeyV, KEYS.Enter, KEYS.KeyW].map(key => Page.buttonOf(key))"),
                         ["Menu", "Jump", "Dial", "OK", ""], "what texts call the buttons");
  await thumb.end();
  await tab.until("Page.axes[1] === 0", "the left thumb at rest");
  await tab.evaluate("globalThis.before = seen");
  await tab.page.tap("#dials");
  await tab.until("different(seen, before) > 0.2", "the drawer of dials");
  await tab.page.tap("#below");
  await tab.until("Page.events.length === 0", "a button of the drawer is read");
  await tab.shot(file("drawer"));
  await tab.page.tap("#dials");
  await tab.expect("getComputedStyle(document.getElementById('below')).display === 'none'", "the drawer is shut");
  await tab.page.touchscreen.tap(900 - 48, 48);
  await tab.until("!Page.isCaptured", "the menu by its button");

  // The gallery: a tap turns its pages, a thumb that moves in its menu chooses.
  await tab.page.goto("file://" + alone + "?--gallery");
  await tab.shows();
  for (const [x, number] of [[800, 2], [800, 3], [100, 2]]) {
    await tab.page.touchscreen.tap(x, 300);
    await tab.until(`document.title.includes("gallery, ${number} of")`, "a page of the gallery by a tap");
  }
  await tab.page.touchscreen.tap(900 - 48, 48);
  await tab.until("Page.events.length === 0", "the menu's button is read");
  await tab.evaluate("globalThis.before = seen");
  const swipe = await tab.page.touchscreen.touchStart(450, 300);
  await swipe.move(450, 270);
  await swipe.end();
  await tab.until("different(seen, before) > 0", "a swipe in the menu");
  await tab.shot(file("gallery"));

  // Held upright: rows are too low for a thumb, so that swipes choose and change them, and a button accepts.
  await tab.page.setViewport({width: 400, height: 800, hasTouch: true, isMobile: true, deviceScaleFactor: 2});
  await tab.page.goto("file://" + alone + "?--gallery");
  await tab.shows();
  const drag = async (x, y) => {
    const thumb = await tab.page.touchscreen.touchStart(200, 400);
    await thumb.move(200 + x, 400 + y);
    await thumb.end();
  };
  // Of the lower halves: above, the gallery's first message goes after some seconds.
  await tab.evaluate("globalThis.lower = picture => ({pixels: picture.pixels.subarray(picture.pixels.length / 2)})");
  await tab.evaluate("globalThis.before = lower(seen)");
  await drag(100, 0);
  await tab.until("different(lower(seen), before) > 0", "a swipe to the right changes the gallery's picture");
  await tab.expect("document.title.includes('gallery, 1 of')", "a swipe turns no page");
  await tab.evaluate("globalThis.before = lower(seen)");
  await tab.page.touchscreen.tap(400 - 48, 48);
  await tab.until("different(lower(seen), before) > 0", "a menu");
  await tab.shot(file("upright"));
  await tab.page.touchscreen.tap(200, 800 * 0.85 - 32);
  await tab.until("different(lower(seen), before) === 0", "the menu's first row, by the button that accepts: go on");
  return tab;
};

// The recorded walk, drawn tick by tick: states and pictures as natively.
const replay = async (open, address) => {
  const pictures = fs.readdirSync(native).filter(name => name.endsWith(".png")).sort();
  const words = ["--replay", "/assets/walk.demo", "--record", "/walk.demo", "--headless", pictures.length, "--out", "/pictures"];
  const tab = await open(address + "?" + words.join("%20"));
  await tab.until("Page.hasEnded", "the walk without a window ends");
  await tab.expect("getComputedStyle(Page.canvas).display === 'none'", "no picture behind what is said at the end");
  await tab.expect("FS.analyzePath('/walk.demo').exists", "the walk is recorded, and not: " + await tab.evaluate("Page.lines.join(' ')"));
  const hashes = hashesOf(await bytesOf(tab, "/walk.demo")), expected = hashesOf(fs.readFileSync(path.join(native, "walk.demo")));
  assert.ok(expected.length >= 300, expected.length + " ticks, expected 300");
  for (let tick = 0; tick < expected.length; ++tick)
    assert.strictEqual(hashes[tick], expected[tick], "hash of the state after tick " + (tick + 1));
  for (const name of pictures) {
    const drawn = readPng(await bytesOf(tab, "/pictures/" + name)), wanted = readPng(fs.readFileSync(path.join(native, name)));
    const wrong = wanted.pixels.reduce((count, pixel, i) => count + (pixel !== drawn.pixels[i]), 0);
    assert.strictEqual(wrong, 0, `${name}: ${wrong} pixels differ from the native game's`);
  }
  console.log(`${hashes.length} states and ${pictures.length} pictures of the recorded walk are the native game's`);
  return tab;
};

// What the screen shows in the middle of each pixel, of a picture that rests, is that pixel's colour.
const checkScreen = async (tab, name) => {
  const screen = await tab.shot(file(name));
  const {pixels, width, height, rect: [left, top, wide, high]} = await tab.evaluate("({...seen, pixels: [...seen.pixels]})");
  let wrong = 0;
  for (let y = 0; y < height; ++y)
    for (let x = 0; x < width; ++x) {
      const at = (top + Math.floor((y + 0.5) * high / height)) * screen.width + left + Math.floor((x + 0.5) * wide / width);
      const colour = pixels[y * width + x];  // red, green, blue, from the lowest byte
      if ([0, 1, 2].some(i => screen.pixels[at * screen.channels + i] !== (colour >> 8 * i & 255))) ++wrong;
    }
  assert.strictEqual(wrong, 0, `${name}: ${wrong} pixels of ${width * height} have another colour on the screen, which is in ${file(name)}`);
};

// Any size, in the right shape, 4:3 or upright 9:16 as large as fits; nothing is drawn outside.
const checkSize = async (tab, size) => {
  const density = size.deviceScaleFactor || 1, width = size.width * density, height = size.height * density;
  await tab.page.setViewport(size);
  await tab.until(`Page.canvas.width === ${width} && Page.canvas.height === ${height}`, "the canvas has the window's size");
  await tab.evaluate("globalThis.before = Page.screen.shown");
  await tab.until("Page.screen.shown > before", "a picture of the new size");
  const [left, top, wide, high] = await tab.evaluate("seen.rect"), [across, down] = height > width ? [9, 16] : [4, 3];
  const fit = Math.min(width / across, height / down);
  const found = `${wide}x${high} at ${left}, ${top} in ${width}x${height}, expected ${across * fit}x${down * fit}`;
  assert.ok(Math.abs(wide - across * fit) <= 1 && Math.abs(high - down * fit) <= 1, found);
  assert.ok(Math.abs(2 * left + wide - width) <= 1 && Math.abs(2 * top + high - height) <= 1, found);
};

// The front page's button, which has the keys, begins the walk or goes on with it.
const enter = async tab => {
  await tab.expect("document.activeElement.textContent === 'Play' && !Page.isCaptured", "the front page");
  await tab.press("Enter");
  await tab.until("Page.isCaptured && document.getElementById('front').hidden", "a walk after Play");
};

const play = async (open, address) => {
  const tab = await open(address);
  await tab.shows();
  console.log("first picture after ms: " + await tab.evaluate("Math.round(Page.screen.first_ms)"));
  await tab.shot(file("title"));
  await enter(tab);
  await tab.evaluate("globalThis.before = seen");
  await tab.down("KeyW");
  await tab.until(`different(seen, before) > ${MOVED}`, "W walks");
  await tab.up("KeyW");
  await tab.shot(file("walk"));
  await tab.evaluate("delete Page.screen.present");  // what the test follows takes time, too
  await tab.cdp.send("Performance.enable", {timeDomain: "threadTicks"});  // without what else the machine does
  const used_s = async () => (await tab.cdp.send("Performance.getMetrics")).metrics.find(metric => metric.name === "TaskDuration").value;
  const before_s = await used_s();
  const [from, began_ms] = await tab.evaluate("[globalThis.before = Page.screen.shown, performance.now()]");
  await tab.until("Page.screen.shown >= before + 120", "120 pictures");
  const [to, ended_ms] = await tab.evaluate("[Page.screen.shown, performance.now()]"), each_ms = (await used_s() - before_s) * 1000 / (to - from);
  console.log(`pictures a second: ${((to - from) * 1000 / (ended_ms - began_ms)).toFixed(1)}, main thread ms a picture: ${each_ms.toFixed(2)}`);

  // A page that is left keeps the walk, and the title goes on with it; what a key saves is there at once.
  const before = await bytesOfSaves(tab);
  await tab.page.reload();
  await tab.shows();
  const kept = await changedSaves(tab, before);
  assert.ok(kept.some(name => name.endsWith(".save")), `no save is new: ${kept}; before: ${Object.keys(before)}`);
  await tab.shot(file("continue"));
  await enter(tab);
  const left = await bytesOfSaves(tab);
  await tab.press("Insert");
  await tab.page.reload();
  await tab.shows();
  const quick = await changedSaves(tab, left);
  assert.ok(quick.some(name => /quick\d\.save$/.test(name)), "no quick save is new: " + quick);
  await enter(tab);

  for (const size of [{width: 500, height: 900}, {width: 1600, height: 500}, {width: 800, height: 600, deviceScaleFactor: 2}, {width: 1280, height: 960}])
    await checkSize(tab, size);

  // A gamepad, as its API shows it: Start opens the menu.
  await tab.evaluate(() => {
    const button = value => ({value, pressed: value > 0.5});
    const pad = {index: 0, connected: true, mapping: "standard", id: "test", axes: [0, 0, 0, 0], buttons: Array.from({length: 17}, () => button(0))};
    navigator.getGamepads = () => [pad];
    globalThis.push = (number, value) => { pad.buttons[number] = button(value); };
  });
  await tab.expect("Page.isCaptured", "the walk goes on");
  for (const value of [1, 0]) {
    await tab.evaluate(`push(9, ${value})`);
    await tab.until(`Pads.before.has(0) && Pads.before.get(0).buttons[9] === ${value} && Page.events.length === 0`, "a gamepad's Start is read as " + value);
  }
  await tab.expect("!Page.isCaptured", "the menu by a gamepad's Start");

  // A menu is not drawn again until something happens, and is still on the screen, also after the browser has lost it.
  const rest = () => tab.evaluate(`new Promise(resolve => {
    const shown = Page.screen.shown, after = turns => requestAnimationFrame(() => turns ? after(turns - 1) : resolve(Page.screen.shown - shown));
    after(20);
  })`);
  await rest();
  assert.strictEqual(await rest(), 0, "pictures of a menu at rest");
  await checkScreen(tab, "menu");
  await tab.evaluate("Page.screen.lose = Page.screen.gl.getExtension('WEBGL_lose_context'), Page.screen.lose.loseContext()");
  await tab.until("Page.screen.gl === null", "the browser takes its context away");
  await tab.evaluate("Page.screen.lose.restoreContext()");
  await tab.until("Page.screen.gl !== null", "another context");
  await rest();
  await checkScreen(tab, "menu again");
  return tab;
};

// The browser's own buttons: back to the front page, and forward into the walk.
const back = async (open, address) => {
  const tab = await open(address), isWalk = () => tab.until("document.getElementById('front').hidden && Page.isCaptured", "a walk");
  await tab.until("!document.getElementById('front').hidden", "the front page");
  await tab.page.click("#play");
  await isWalk();
  await tab.page.goBack();
  await tab.until("location.hash === '' && !document.getElementById('front').hidden", "the front page again");
  await tab.shot(file("front"));
  await tab.page.goForward();
  await isWalk();
  return tab;
};

// A link to a room begins there; one to none says which there are.
const rooms = async (open, address) => {
  const tab = await open(address + "?room=Vanishing%20Point");
  await tab.shows();
  await tab.until("Page.isCaptured && document.getElementById('front').hidden", "a walk in a room");
  await tab.shot(file("room"));
  await tab.page.goto(address + "?room=kitchen");
  await tab.until("Page.hasEnded && document.body.innerText.includes(\"'kitchen' is no room of this level, expected aspect, \")", "which rooms there are");
  tab.said.splice(0);
  return tab;
};

// A tab behind another one: nothing moves nor sounds, and an hour later the walk is where it was.
const rest = async (open, address) => {
  const tab = await open(address + "?/assets/demo.bsp");
  await tab.shows();
  await tab.evaluate(() => {
    const start = AudioBufferSourceNode.prototype.start;
    globalThis.mixed = globalThis.heard = 0;
    AudioBufferSourceNode.prototype.start = function (...when) {
      ++mixed;
      heard += this.buffer.getChannelData(0).some(sample => sample !== 0);
      start.apply(this, when);
    };
    globalThis.before = seen;
  });
  await tab.down("KeyW");
  await tab.until(`different(seen, before) > ${MOVED} && heard > 0`, "a walk with sound");
  const showsTwo = async () => tab.until(`Page.screen.shown > ${await tab.evaluate("Page.screen.shown")} + 1`, "two pictures");
  await tab.evaluate("performance.now = (now => () => now)(performance.now())");
  await showsTwo();
  await tab.evaluate("globalThis.before = seen");
  await tab.behind(async () => {
    await tab.until("Page.sound.context.state === 'suspended'", "no sound");
    await tab.evaluate(() => {
      performance.now = (now => () => now + 3600000)(performance.now());
      globalThis.hidden = {mixed, shown: Page.screen.shown};
      return new Promise(resolve => setTimeout(resolve, 500));
    });
    await tab.expect("Page.screen.shown === hidden.shown && mixed === hidden.mixed", "a hidden tab rests");
  });
  await tab.until("mixed > hidden.mixed && !Page.isCaptured", "the menu, and sound again");
  await tab.press("Enter");
  await tab.until("Page.isCaptured", "the menu's first row: go on");
  await showsTwo();
  await tab.expect("different(seen, before) === 0", "the walk is where it was");
  return tab;
};

// A browser with no room left, in either store: the player is told, once for each save, and what has room again is saved.
const full = async (open, address) => {
  const tab = await open(address + "?/assets/demo.bsp", {width: 1280, height: 960}, () => {
    const put = IDBObjectStore.prototype.put;
    IDBObjectStore.prototype.put = function (...what) {
      if (globalThis.isFull) throw new DOMException("full", "QuotaExceededError");
      return put.apply(this, what);
    };
  });
  await tab.shows();
  await tab.until("Page.isCaptured", "a walk");
  await tab.evaluate(() => {
    globalThis.isFull = true;
    for (let size = 1 << 22, number = 0; size > 0;)
      try { localStorage["filler" + number++] = "x".repeat(size); } catch (error) { size >>= 1; }
  });
  await tab.press("Insert");
  await tab.until("document.body.innerText.includes('stores no more')", "a word on the full store");
  await tab.shot(file("full"));
  await tab.evaluate("new Promise(resolve => setTimeout(resolve, 2000))");
  assert.deepStrictEqual(tab.said.splice(0), ["not saved: QuotaExceededError: full"], "on the console, once");
  await tab.behind(() => tab.evaluate("new Promise(resolve => setTimeout(resolve, 1000))"));
  const said = tab.said.splice(0);
  assert.ok(said.length > 1 && said.every(line => line.startsWith("not kept: QuotaExceededError") || line === "not saved: QuotaExceededError: full"),
            "what cannot be kept is no error of the page: " + said);
  await tab.evaluate("isFull = false, localStorage.clear()");
  await tab.press("Escape");
  await tab.until("Page.isCaptured", "the walk goes on");
  await tab.press("Insert");
  await tab.evaluate("new Promise(resolve => setTimeout(resolve, 2000))");
  await tab.page.reload();
  await tab.shows();
  assert.ok((await savesOf(tab)).some(name => name.endsWith("quick1.save")), "no quick save after there is room again");
  return tab;
};

// In two tabs: the second one says that it saves nothing, and removes nothing of the first one's.
const twice = async (open, address) => {
  const tab = await open(address + "?/assets/demo.bsp"), pause = tab => tab.evaluate("new Promise(resolve => setTimeout(resolve, 2000))");
  await tab.shows();
  const second = await open(address + "?/assets/demo.bsp");
  await second.shows();
  await second.expect("document.body.innerText.includes('open in another tab')", "a word on the other tab");
  await second.shot(file("second"));
  await tab.page.bringToFront();
  await tab.press("Insert");
  await pause(tab);
  await second.page.bringToFront();
  await second.evaluate("FS.writeFile('/save/second', 'saved')");
  await pause(second);
  await second.page.close();
  await tab.page.bringToFront();
  await tab.page.reload();
  await tab.shows();
  await tab.expect("!document.body.innerText.trim()", "no word on another tab, that has gone, or on what was here before");
  const kept = await savesOf(tab);
  assert.ok(kept.some(name => name.endsWith("quick1.save")) && !kept.includes("/save/second"), "the first tab's saves alone: " + kept);
  return tab;
};

// A browser that refuses all that it may: the game does without.
const refusals = async (open, address) => {
  const tab = await open(address, {width: 1280, height: 960}, () => {
    const refuse = () => { throw new DOMException("refused", "SecurityError"); };
    const getContext = HTMLCanvasElement.prototype.getContext;
    HTMLCanvasElement.prototype.getContext = function (kind, ...more) { return kind === "webgl" ? null : getContext.call(this, kind, ...more); };
    HTMLCanvasElement.prototype.requestPointerLock = () => { document.dispatchEvent(new Event("pointerlockerror")); };
    for (const name of ["indexedDB", "localStorage", "AudioContext"]) Object.defineProperty(window, name, {get: name === "localStorage" ? refuse : () => undefined});
    Object.defineProperty(Document.prototype, "fullscreenEnabled", {get: () => false});
    navigator.getGamepads = refuse;
  });
  await tab.shows();
  await tab.expect("document.body.innerText.includes('does not store saved games')", "a word on saves");
  await tab.shot(file("refused"));
  await enter(tab);
  await tab.expect("!document.body.innerText.trim()", "it is gone");
  await tab.page.keyboard.down("Alt");
  await tab.press("Enter");
  await tab.page.keyboard.up("Alt");
  await tab.evaluate("globalThis.before = seen");
  await tab.page.mouse.click(300, 300);
  await tab.page.mouse.move(900, 300);
  await tab.until(`different(seen, before) > ${MOVED}`, "the mouse turns the view");
  await tab.press("Escape");
  await tab.expect("!Page.isCaptured", "the menu");
  await checkScreen(tab, "menu without WebGL");
  assert.deepStrictEqual(tab.said.splice(0), ["no database: this browser has none", "oblong: no sound: the browser has no AudioContext for it"]);
  return tab;
};

run(async open => {
  const address = await serve(site);
  for (const test of [touch, replay, rest, refusals, full, twice, play, back, rooms]) {
    console.log(test.name);
    const tab = await test(open, address);
    assert.deepStrictEqual(tab.said, [], "on the console");
    await tab.page.close();
  }
});
