// Opens the page that pack.py made of game/example, from its file, in headless Chromium: it is that game's, and is played.
//   node play_game.cjs SITE GAME SCRATCH      SITE: the page's folder, GAME: the game's
const puppeteer = require("puppeteer-core"), assert = require("assert"), fs = require("fs"), path = require("path");

const [site, game, scratch] = process.argv.slice(2);
const wait = ms => new Promise(resolve => setTimeout(resolve, ms));

const main = async () => {
  const browser = await puppeteer.launch({executablePath: "/usr/bin/chromium", headless: true, protocolTimeout: 600000,
    args: ["--no-sandbox", "--disable-dev-shm-usage", "--use-angle=swiftshader", "--enable-unsafe-swiftshader",
           "--autoplay-policy=no-user-gesture-required", "--allow-file-access-from-files"]});
  const said = [], page = await browser.newPage();
  page.on("console", line => { if (["error", "warn", "warning"].includes(line.type())) said.push(line.text()); });
  page.on("pageerror", error => said.push(error.message));
  const until = condition => page.waitForFunction(condition, {timeout: 300000}).catch(() => { throw new Error("never: " + condition); });
  await page.setViewport({width: 1280, height: 960});
  await page.goto("file://" + path.resolve(site, "oblong.html"));
  assert.strictEqual(await page.title(), "Three Rooms");
  const icon = await page.$eval("link[rel=icon]", link => link.href), [kind, bytes] = icon.split(",");
  assert.strictEqual(kind, "data:image/png;base64");
  assert.ok(Buffer.from(bytes, "base64").equals(fs.readFileSync(path.join(game, "icon.png"))), "another icon");

  await until("Page.screen && Page.screen.shown > 0 || Page.hasEnded");
  await wait(1500);
  await page.screenshot({path: path.join(scratch, "game-title.png")});
  // By Enter: what light there is, then a new walk.
  for (let i = 0; i < 6 && !await page.evaluate("Page.isCaptured"); ++i) {
    await page.keyboard.press("Enter", {delay: 60});
    await wait(500);
  }
  await until("Page.isCaptured");
  await until("document.title === 'Three Rooms - first'");
  await page.keyboard.down("KeyW");
  await wait(1500);
  await page.keyboard.up("KeyW");
  await page.screenshot({path: path.join(scratch, "game-walk.png")});
  assert.deepStrictEqual([said, await page.evaluate("Page.hasEnded === true")], [[], false], "on the console");
  await browser.close();
};

main().catch(error => {
  console.error(error);
  process.exit(1);
});
