// The page of engine/examples in headless Chromium: each example draws what it draws natively, and one is looked at as it runs.
//   node play_examples.cjs SITE SCRATCH      SITE: the page's folder; SCRATCH: for pictures to look at
"use strict";
const assert = require("assert"), fs = require("fs"), path = require("path"), {readPng, run} = require("./chromium.cjs");

const [site, scratch] = process.argv.slice(2), root = path.resolve(__dirname, "../..");
const page = "file://" + path.resolve(site, "examples.html");
// {"plasma", "plasma", 40}: the example, its picture, and which of its pictures that is.
const shots = [...fs.readFileSync(path.join(root, "tests/examples/examples_test.cpp"), "latin1").matchAll(/\{"(\w+)", "(\w+)", (\d+)\}/g)];

const check = async (open, [, example, name, count], address = page, words = example + " /assets") => {
  const tab = await open(`${address}?OBLONG_HEADLESS=${count}:/shot.png ${words}`);
  await tab.until("Page.hasEnded", example + " ends");
  assert.deepStrictEqual(tab.said.filter(line => !line.includes("OBLONG_HEADLESS: no sound")), [], example + ", on the console");
  const drawn = readPng(Buffer.from(await tab.evaluate("btoa(String.fromCharCode(...FS.readFile('/shot.png')))"), "base64"));
  const wanted = readPng(fs.readFileSync(path.join(root, "engine/examples", name + ".png")));
  assert.deepStrictEqual([drawn.width, drawn.height], [wanted.width, wanted.height], name);
  const wrong = wanted.pixels.reduce((sum, pixel, i) => sum + (pixel !== drawn.pixels[i]), 0);
  assert.strictEqual(wrong, 0, `${name}: ${wrong} pixels differ from engine/examples/${name}.png`);
  await tab.page.close();
};

run(async open => {
  const list = await open(page);
  await list.until("document.querySelectorAll('#list a').length > 0", "a list of examples");
  const names = await list.evaluate("[...document.querySelectorAll('#list h2')].map(name => name.textContent)");
  for (const [at, name] of names.entries())
    assert.strictEqual(await list.evaluate(at => document.querySelectorAll("#list pre")[at].textContent, at), fs.readFileSync(path.join(root, "engine/examples", name + ".cpp"), "utf8"), "the source of " + name);
  assert.deepStrictEqual(names, [...new Set(shots.map(([, example]) => example))].sort());
  assert.deepStrictEqual(list.said, [], "on the console");
  await list.shot(path.join(scratch, "examples.png"));
  await list.page.close();
  for (const name of names) await check(open, shots.find(([, example]) => example === name));
  // A program that has a page of its own, as tools/build --web makes it.
  await check(open, shots.find(([, example]) => example === "plasma"), "file://" + path.resolve(site, "plasma.html"), "");

  const refused = await open(page + "?fire", undefined, () => { delete WebAssembly.Suspending; });
  await refused.until("Page.hasEnded && document.body.innerText.includes('JSPI')", "a browser where a program can't wait says so");
  await refused.page.close();

  const fire = await open(page + "?fire");
  await fire.shows();
  await fire.evaluate("globalThis.before = seen");
  await fire.until("different(seen, before) > 0.1", "it burns");
  await fire.shot(path.join(scratch, "fire.png"));
  assert.deepStrictEqual(fire.said, [], "on the console");
  console.log(names.length + " examples draw as natively");
});
