// Plays the page in headless Chromium, by its keys, a gamepad and touches, and compares its pictures with the native game's.
//   node play.cjs SITE NATIVE SCRATCH      SITE: the page's folder, NATIVE: pictures that the game wrote of the recorded walk
const puppeteer = require("puppeteer-core"), assert = require("assert"), fs = require("fs"), http = require("http"),
      path = require("path"), zlib = require("zlib");

const [site, native, scratch] = process.argv.slice(2);
const TYPES = {".html": "text/html", ".wasm": "application/wasm"};

const server = http.createServer((request, response) => {
  const file = path.join(site, path.basename(new URL(request.url, "http://localhost").pathname) || "index.html");
  if (!fs.existsSync(file)) return response.writeHead(404).end();
  response.writeHead(200, {"Content-Type": TYPES[path.extname(file)] || "application/octet-stream"});
  fs.createReadStream(file).pipe(response);
});

// The indices of a PNG as the page or the game writes it: 8 bits, not interlaced.
const indicesOf = file => {
  const packed = [];
  let width = 0, height = 0;
  for (let at = 8; at < file.length;) {
    const size = file.readUInt32BE(at), name = file.toString("latin1", at + 4, at + 8), bytes = file.subarray(at + 8, at + 8 + size);
    if (name === "IHDR") [width, height] = [bytes.readUInt32BE(0), bytes.readUInt32BE(4)];
    if (name === "IDAT") packed.push(bytes);
    at += size + 12;
  }
  const rows = zlib.inflateSync(Buffer.concat(packed)), indices = Buffer.alloc(width * height);
  for (let y = 0; y < height; ++y) {
    const filter = rows[y * (width + 1)];
    for (let x = 0; x < width; ++x) {
      const at = y * width + x, a = x ? indices[at - 1] : 0, b = y ? indices[at - width] : 0, c = x && y ? indices[at - width - 1] : 0;
      const p = a + b - c, [pa, pb, pc] = [a, b, c].map(v => Math.abs(p - v));
      const paeth = pa <= pb && pa <= pc ? a : pb <= pc ? b : c;
      indices[at] = rows[y * (width + 1) + 1 + x] + [0, a, b, (a + b) >> 1, paeth][filter];
    }
  }
  return indices;
};

const wait = ms => new Promise(resolve => setTimeout(resolve, ms));

const main = async () => {
  await new Promise(resolve => server.listen(0, "127.0.0.1", resolve));
  const address = "http://127.0.0.1:" + server.address().port + "/";
  const browser = await puppeteer.launch({executablePath: "/usr/bin/chromium", headless: true, protocolTimeout: 600000,
    args: ["--no-sandbox", "--disable-dev-shm-usage", "--use-angle=swiftshader", "--enable-unsafe-swiftshader",
           "--autoplay-policy=no-user-gesture-required", "--allow-file-access-from-files"]});
  const said = [];
  const open = async (name, size = {width: 1280, height: 960}) => {
    const page = await browser.newPage();
    page.on("console", line => { if (["error", "warn", "warning"].includes(line.type())) said.push(line.text()); });
    page.on("pageerror", error => said.push(error.message));
    await page.setViewport(size);
    await page.goto(name.startsWith("file:") ? name : address + name);
    return page;
  };
  const shows = page => page.waitForFunction("Page.screen && Page.screen.shown > 0 || Page.hasEnded", {timeout: 300000});
  const shot = (page, name) => page.screenshot({path: path.join(scratch, name + ".png")});
  const view = page => page.evaluate("[Page.isCaptured, Page.screen.shown, Page.hasEnded === true]");
  const until = async (page, condition, what) => {
    await page.waitForFunction(condition, {timeout: 120000}).catch(() => { throw new Error("never: " + what); });
  };
  const press = async (page, key, held_ms = 60) => {
    await page.keyboard.down(key);
    await wait(held_ms);
    await page.keyboard.up(key);
    await wait(400);
  };
  const saves = page => page.evaluate(() => {
    const found = [], look = folder => FS.readdir(folder).filter(name => !/^\.\.?$/.test(name)).forEach(name => {
      const file = folder + "/" + name;
      FS.isDir(FS.stat(file).mode) ? look(file) : found.push(file);
    });
    look("/save");
    return found;
  });

  // Two thumbs, in the file that needs no server.
  let page = await open("file://" + path.resolve(site, "oblong.html") + "?/assets/demo.bsp", {width: 900, height: 500, hasTouch: true, isMobile: true, deviceScaleFactor: 2});
  await shows(page);
  await wait(1000);
  await until(page, "Page.isCaptured", "a walk without a title");
  await page.evaluate(() => {
    const note = Page.noteAxis;
    Page.axes = {};
    Page.noteAxis = function (axis, value) { this.axes[axis] = value; note.call(this, axis, value); };
  });
  const thumb = await page.touchscreen.touchStart(200, 300);
  await thumb.move(200, 240);
  await until(page, "Page.axes[0] === 0 && Page.axes[1] === -1", "the left thumb ahead");
  await shot(page, "touch");
  await thumb.end();
  await until(page, "Page.axes[1] === 0", "the left thumb at rest");
  await page.touchscreen.tap(900 - 48, 48);
  await until(page, "!Page.isCaptured", "the menu by its button");
  await page.close();

  // The recorded walk, drawn tick by tick: pictures as natively.
  const pictures = fs.readdirSync(native).filter(name => name.endsWith(".png")).sort();
  page = await open("?--replay%20/assets/walk.demo%20--headless%20" + pictures.length + "%20--out%20/pictures");
  await until(page, "Page.hasEnded", "the walk without a window ends");
  for (const name of pictures) {
    const drawn = await page.evaluate(name => btoa(Array.from(FS.readFile("/pictures/" + name), b => String.fromCharCode(b)).join("")), name);
    assert.ok(indicesOf(Buffer.from(drawn, "base64")).equals(indicesOf(fs.readFileSync(path.join(native, name)))), name + " differs");
  }
  console.log(pictures.length + " pictures of the recorded walk are the native game's");
  await page.close();

  // The title, the walk by keys, and its sound.
  page = await open("");
  await shows(page);
  console.log("first picture after ms: " + await page.evaluate("Math.round(Page.screen.first_ms)"));
  await wait(1500);
  await shot(page, "title");
  await press(page, "Enter");
  await shot(page, "light");
  for (let i = 0; i < 4 && !(await view(page))[0]; ++i) await press(page, "Enter");
  await until(page, "Page.isCaptured", "a walk by Enter");
  await page.keyboard.down("KeyW");
  await wait(1500);
  await page.keyboard.up("KeyW");
  await shot(page, "walk");
  await until(page, "Page.sound && Page.sound.heard > 0", "sound");
  const before_s = (await page.metrics()).TaskDuration, began = Date.now(), shown = (await view(page))[1];
  await wait(4000);
  const pictures_shown = (await view(page))[1] - shown;
  console.log("pictures a second: " + (pictures_shown * 1000 / (Date.now() - began)).toFixed(1) + ", main thread ms a picture: " +
              (((await page.metrics()).TaskDuration - before_s) * 1000 / pictures_shown).toFixed(2));

  // A page that is left keeps the walk, and the title goes on with it; what a key saves is there at once.
  const before = await saves(page);
  await page.reload();
  await shows(page);
  const kept = (await saves(page)).filter(file => !before.includes(file));
  assert.ok(kept.some(file => file.endsWith(".save")), "no save among what is new: " + kept);
  await wait(1000);
  await shot(page, "continue");
  await press(page, "Enter");
  await until(page, "Page.isCaptured", "Continue goes on with the walk");
  await press(page, "Insert");
  await page.reload();
  await shows(page);
  assert.ok((await saves(page)).some(file => file.endsWith("quick1.save")), "no quick save");
  await wait(1000);
  await press(page, "Enter");
  await until(page, "Page.isCaptured", "a walk");

  // Any size, in the right shape; nothing is drawn outside.
  for (const size of [{width: 500, height: 900}, {width: 1600, height: 500}, {width: 800, height: 600, deviceScaleFactor: 2}]) {
    await page.setViewport(size);
    await wait(700);
    const canvas = await page.evaluate("[Page.canvas.width, Page.canvas.height]"), density = size.deviceScaleFactor || 1;
    assert.deepStrictEqual(canvas, [size.width * density, size.height * density]);
    await shot(page, "size" + size.width);
  }
  await page.setViewport({width: 1280, height: 960});

  // A gamepad, as its API shows it: Start opens the menu.
  await page.evaluate(() => {
    const button = value => ({value, pressed: value > 0.5});
    globalThis.testPad = {index: 0, connected: true, mapping: "standard", id: "test", axes: [0, 0, 0, 0], buttons: Array.from({length: 17}, () => button(0))};
    navigator.getGamepads = () => [globalThis.testPad];
    globalThis.push = (number, value) => { globalThis.testPad.buttons[number] = button(value); };
  });
  await page.evaluate("push(9, 1)");
  await wait(300);
  await page.evaluate("push(9, 0)");
  await until(page, "!Page.isCaptured", "the menu by a gamepad's Start");
  await shot(page, "pad");
  await page.close();

  assert.deepStrictEqual(said, [], "on the console");
  await browser.close();
  server.close();
};

main().catch(error => {
  console.error(error);
  process.exit(1);
});
