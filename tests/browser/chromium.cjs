// A page of ours in headless Chromium, looked at and pressed without clocks: on a busy machine all takes ten times as long.
"use strict";
const puppeteer = require("puppeteer-core"), assert = require("assert"), fs = require("fs"), http = require("http"),
      path = require("path"), zlib = require("zlib");

const LIMIT_ms = 1200000;  // of what never comes
const TYPES = {".html": "text/html", ".wasm": "application/wasm"};
// What software GL says of its own speed, and of a context that a test takes away.
const NO_FAULT = /GL Driver Message|CONTEXT_LOST_WEBGL/;

// The address of a folder's files.
const serve = folder => new Promise(resolve => {
  const server = http.createServer((request, response) => {
    const file = path.join(folder, path.basename(new URL(request.url, "http://localhost").pathname) || "index.html");
    if (!fs.existsSync(file)) return response.writeHead(404).end();
    response.writeHead(200, {"Content-Type": TYPES[path.extname(file)] || "application/octet-stream"});
    fs.createReadStream(file).pipe(response);
  });
  server.listen(0, "127.0.0.1", () => resolve("http://127.0.0.1:" + server.address().port + "/"));
});

// A PNG as the page, the game or Chromium writes it: 8 bits a channel, not interlaced.
const readPng = file => {
  const packed = [];
  let width = 0, height = 0, channels = 1;
  for (let at = 8; at < file.length;) {
    const size = file.readUInt32BE(at), name = file.toString("latin1", at + 4, at + 8), bytes = file.subarray(at + 8, at + 8 + size);
    if (name === "IHDR") [width, height, channels] = [bytes.readUInt32BE(0), bytes.readUInt32BE(4), {0: 1, 2: 3, 3: 1, 6: 4}[bytes[9]]];
    if (name === "IDAT") packed.push(bytes);
    at += size + 12;
  }
  const rows = zlib.inflateSync(Buffer.concat(packed)), stride = width * channels, pixels = Buffer.alloc(stride * height);
  for (let y = 0; y < height; ++y) {
    const filter = rows[y * (stride + 1)];
    for (let x = 0; x < stride; ++x) {
      const at = y * stride + x, isFirst = x < channels, a = isFirst ? 0 : pixels[at - channels], b = y ? pixels[at - stride] : 0;
      const c = isFirst || !y ? 0 : pixels[at - stride - channels], p = a + b - c, [pa, pb, pc] = [a, b, c].map(v => Math.abs(p - v));
      const paeth = pa <= pb && pa <= pc ? a : pb <= pc ? b : c;
      pixels[at] = rows[y * (stride + 1) + 1 + x] + [0, a, b, (a + b) >> 1, paeth][filter];
    }
  }
  return {width, height, channels, pixels};
};

// In the page: what it showed last, and in how many of its pixels, of 1, that differs from another picture.
const followPictures = () => {
  const screen = Page.screen, present = screen.present;
  screen.present = function (pixels, width, height, rect, ...more) {
    globalThis.seen = {pixels: new Uint32Array(pixels.slice().buffer), width, height, rect: [...rect]};
    return present.call(this, pixels, width, height, rect, ...more);
  };
  screen.isLost = true;  // a menu at rest shows its picture again
  globalThis.different = (a, b) => a.pixels.reduce((count, pixel, i) => count + (pixel !== b.pixels[i]), 0) / a.pixels.length;
};

class Tab {
  constructor(page, said, cdp) {
    this.page = page;
    this.said = said;  // errors and warnings on the console
    this.cdp = cdp;
  }

  // Once the page shows pictures.
  async shows() {
    await this.until("Page.screen && Page.screen.shown > 0", "a first picture");
    await this.page.evaluate(followPictures);
    await this.until("globalThis.seen", "a second picture");
  }

  evaluate(...what) {
    return this.page.evaluate(...what);
  }

  // Asks in the page until it is so. What has ended comes to nothing more.
  async until(condition, what) {
    const answer = await this.page.waitForFunction(`(${condition}) ? "so" : globalThis.Page && Page.hasEnded ? "ended" : ""`,
                                                   {polling: 50}).then(handle => handle.jsonValue(), error => error.message);
    if (answer === "so") return;
    const found = await this.evaluate(`JSON.stringify({said: document.body.innerText.trim(), isCaptured: Page.isCaptured,
      shown: Page.screen && Page.screen.shown, events: Page.events, hasFocus: document.hasFocus(), hidden: document.hidden})`)
      .catch(error => error.message);
    throw new Error(`${what}: expected ${condition}, but the page ${answer === "ended" ? "has ended" : "never came to that: " + answer}\n` +
                    `  found ${found}\n  on the console: ${this.said.join("\n  ") || "nothing"}`);
  }

  // Every key counts: each change is read by the game, and what it does is done, before the next.
  async down(key) {
    await this.page.keyboard.down(key);
    await this.until("Page.events.length === 0", key + " is read");
  }
  async up(key) {
    await this.page.keyboard.up(key);
    await this.until("Page.events.length === 0", key + " is let go of");
  }
  async press(key) {
    await this.down(key);
    await this.up(key);
  }

  async expect(condition, what) {
    assert.ok(await this.evaluate(condition), `${what}: expected ${condition}`);
  }

  // Another tab in front of it, while `work` is done.
  async behind(work) {
    const other = await this.page.browser().newPage();
    await other.bringToFront();
    await this.cdp.send("Emulation.setFocusEmulationEnabled", {enabled: false});
    await this.until("document.hidden", "a hidden tab");
    await work();
    await this.page.bringToFront();
    await this.cdp.send("Emulation.setFocusEmulationEnabled", {enabled: true});
    await this.until("!document.hidden", "a tab in front");
    await other.close();
  }

  // The screen's own picture, also in a file to look at.
  async shot(file) {
    return readPng(Buffer.from(await this.page.screenshot({path: file})));
  }
}

// Chromium, and open(address, size), which makes a tab of it.
const start = async () => {
  const browser = await puppeteer.launch({
    executablePath: process.env.CHROMIUM || "/usr/bin/chromium", headless: true, protocolTimeout: LIMIT_ms, timeout: LIMIT_ms,
    args: ["--no-sandbox", "--disable-dev-shm-usage", "--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--disable-gpu-watchdog",
           "--autoplay-policy=no-user-gesture-required"],
  }).catch(error => { throw new Error("Chromium does not start: " + error.message); });
  // `before`: what runs in the page before its own scripts.
  const open = async (address, size = {width: 1280, height: 960}, before = () => {}) => {
    const page = await browser.newPage(), said = [];
    page.setDefaultTimeout(LIMIT_ms);
    page.on("console", line => { if (["error", "warn", "warning"].includes(line.type()) && !NO_FAULT.test(line.text())) said.push(line.text()); });
    page.on("pageerror", error => said.push(error.message));
    page.on("error", error => said.push("crashed: " + error.message));
    const cdp = await page.createCDPSession();
    await cdp.send("Emulation.setFocusEmulationEnabled", {enabled: true});
    await page.setViewport(size);
    await page.evaluateOnNewDocument(before);
    await page.goto(address);
    return new Tab(page, said, cdp);
  };
  return {open, close: () => browser.close()};
};

// Runs a test of it, and says what failed.
const run = async test => {
  let browser = null;
  try {
    browser = await start();
    await test(browser.open);
  } catch (error) {
    console.error("FAILED: " + error.stack);
    process.exitCode = 1;
  }
  if (browser) await browser.close();
  process.exit();
};

module.exports = {serve, readPng, run};
