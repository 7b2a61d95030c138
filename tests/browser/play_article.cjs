// Moves every slider of the article's page in headless Chromium, by keys: what each figure then shows is what the same code
// computes natively, and its pictures have the same bytes.
//   node play_article.cjs SITE NATIVE LEVEL PALETTE AXE SCRATCH      NATIVE: article_figures (article/figures.cpp); AXE: axe.min.js;
//                                                                    SCRATCH: for pictures to look at
"use strict";
const assert = require("assert"), child = require("child_process"), fs = require("fs"), path = require("path"),
      {run} = require("./chromium.cjs");

const [site, native, level, palette, axe, scratch] = process.argv.slice(2);
const address = "file://" + path.resolve(site, "accuracy.html");
const SIZES = [[360, 640], [390, 844], [820, 1180], [1440, 900], [2560, 1440]];

const crc = bytes => {
  let sum = ~0;
  for (const byte of bytes) {
    sum ^= byte;
    for (let i = 0; i < 8; ++i) sum = sum >>> 1 ^ (sum & 1 && 0xEDB88320);
  }
  return ~sum >>> 0;
};

// In the page: a figure at rest, as the text of a line for article_figures, and what is on its screens.
const inPage = (id, makeCrc) => {
  const figure = Article.figures.find(one => one.definition.id === id), {view, parts} = figure, crc = eval(makeCrc);
  const crcOf = part => parts[part] && crc(parts[part].pen.getImageData(0, 0, 320, 200).data);
  return {id, line: [...view.eye, view.drawnTall ? 1 : 0, figure.measure, ...view.values].join(" "), cycles: figure.cost.cycles,
          instructions: figure.cost.instructions, instructions486: figure.cost.instructions486, rms: figure.error && figure.error.rms,
          max: figure.error && figure.error.max, picture: crcOf("picture"), reference: crcOf("reference"), errors: crcOf("errors")};
};

const open = async (browser, size) => {
  const tab = await browser(address, size);
  await tab.until("globalThis.Article", "an open module");
  return tab;
};

const atRest = async (tab, id) => {
  await tab.until(`Object.values(Article.figures.find(one => one.definition.id === "${id}").due).every(due => !due)`, id + " at rest");
  return tab.evaluate(inPage, id, `(${crc})`);
};

// By keys: each slider to both of its ends and a step back, each box over and back.
const moveAll = async (tab, id, notes) => {
  const place = `#figure-${id}`;
  await tab.evaluate(place => document.querySelector(place).scrollIntoView(), place);
  notes.push(await atRest(tab, id));
  for (const input of await tab.page.$$(`${place} input`)) {
    await input.focus();
    const isBox = await input.evaluate(one => one.type === "checkbox"), before = await input.evaluate(one => one.value);
    for (const key of isBox ? ["Space", "Space"] : ["Home", "ArrowRight", "End"]) {
      await tab.page.keyboard.press(key);
      notes.push(await atRest(tab, id));
    }
    if (!isBox) await input.evaluate((one, before) => { one.value = before; one.dispatchEvent(new Event("input")); }, before);
  }
};

const compare = notes => {
  const ran = child.spawnSync(native, [level, palette], {input: notes.map(note => note.line).join("\n"), maxBuffer: 1 << 26});
  assert.strictEqual(ran.status, 0, ran.stderr.toString());
  const wanted = ran.stdout.toString().trim().split("\n").map(line => JSON.parse(line));
  assert.strictEqual(wanted.length, notes.length);
  notes.forEach((note, i) => {
    const {picture, reference, errors, figures} = wanted[i], where = `${note.id}, ${note.line}`;
    assert.strictEqual(note.picture, picture, "the picture of " + where);
    if (note.reference !== undefined) assert.strictEqual(note.reference, reference, "the exact picture of " + where);
    for (const name of ["instructions", "instructions486", "cycles"]) assert.deepStrictEqual(note[name], figures[name], `${name} of ${where}`);
    if (note.errors === undefined) return;
    assert.strictEqual(note.errors, errors, "the map of " + where);
    for (const name of ["rms", "max"])
      assert.ok(Math.abs(note[name] - figures[name]) <= 1e-9 * figures[name], `${name} of ${where}: ${note[name]}, natively ${figures[name]}`);
  });
};

const sliders = async browser => {
  const tab = await open(browser, {width: 1440, height: 900}), notes = [];
  for (const id of await tab.evaluate("Article.figures.map(figure => figure.definition.id)")) {
    await moveAll(tab, id, notes);
    await atRest(tab, id);
    await tab.shot(path.join(scratch, `article-${id}.png`));
  }
  assert.ok(new Set(notes.map(note => note.picture)).size > 40, "pictures that differ");
  compare(notes);
  tab.said = tab.said.filter(line => !line.includes("willReadFrequently"));  // this test alone reads canvases
  console.log(`${notes.length} views as natively`);
  return tab;
};

// Of a row of the strip: its numbers.
const numbersOf = row => row.map(text => Number(text.replace("−", "-").replace(/,/g, "")) || 0);

const strip = async browser => {
  const tab = await open(browser, {width: 1440, height: 900});
  await tab.evaluate("document.getElementById('measured').scrollIntoView()");
  await tab.until("document.querySelector('#strip-table table') && document.querySelector('#chart-dots svg')", "the strip and the chart");
  const rows = await tab.evaluate(
    "[...document.querySelectorAll('#strip-table tbody tr')].map(row => [...row.querySelectorAll('td')].map(cell => cell.textContent))");
  const [first, ...steps] = rows.map(numbersOf), last = steps.pop();
  last.forEach((whole, i) => {
    const sum = first[i] + steps.reduce((all, step) => all + step[i], 0);
    assert.ok(Math.abs(sum - whole) <= 0.01 * Math.max(...steps.map(step => Math.abs(step[i]))) + 5e-4, `the strip's parts are ${sum}, the whole ${whole}`);
  });
  assert.ok(last[0] > 1 && last[1] > 1, "a setting with errors of both kinds: " + last);

  await tab.evaluate("document.querySelector('#chart-dots circle[tabindex=\"0\"]').focus()");
  const before = await tab.evaluate("document.getElementById('chart-said').textContent");
  for (const key of ["ArrowLeft", "ArrowLeft", "Enter"]) await tab.page.keyboard.press(key);
  await tab.until(`document.getElementById('chart-said').textContent !== ${JSON.stringify(before)}`, "another dot");
  await tab.expect("Article.measurements.figure.view.values.join() === Article.measurements.dotFigure.view.values.join()", "Enter turns the dials");
  await tab.shot(path.join(scratch, "article-chart.png"));
  return tab;
};

// Nothing moves by itself; asked to, no faster than a 386.
const pace = async browser => {
  const tab = await open(browser, {width: 1440, height: 900});
  await tab.evaluate("document.getElementById('askew').scrollIntoView()");
  const {instructions} = await atRest(tab, "askew");
  await tab.evaluate(() => {
    const figure = Article.figures[0], draw = figure.draw;
    globalThis.drawn = [];
    figure.draw = function (now) { drawn.push(now); return draw.call(this, now); };
  });
  await tab.page.select("#machine", "386 at 33 MHz");
  await new Promise(resolve => setTimeout(resolve, 500));
  await tab.expect("drawn.length === 0", `nothing has moved (${instructions} instructions)`);
  await (await tab.page.$("#figure-askew button")).click();
  await tab.until("drawn.length > 5", "a view that turns");
  const gaps = await tab.evaluate("drawn.slice(2).map((now, i) => now - drawn[i + 1])");
  const milliseconds = await tab.evaluate("Article.engine.milliseconds(0, Article.figures[0].cost.cycles)");
  assert.ok(Math.min(...gaps) > 0.9 * milliseconds && milliseconds > 50, `pictures every ${gaps} ms on a 386, which takes ${milliseconds}`);
  return tab;
};

const sizes = async browser => {
  let tab = null;
  for (const [width, height] of SIZES) {
    if (tab) await tab.page.close();
    tab = await open(browser, {width, height, hasTouch: width < 1000, isMobile: width < 1000});
    await tab.expect("document.documentElement.scrollWidth <= innerWidth", `no sideways scroll at ${width}x${height}`);
    await tab.evaluate("document.getElementById('figure-all').scrollIntoView()");
    await atRest(tab, "all");
    await tab.shot(path.join(scratch, `article-${width}.png`));
    await tab.evaluate(fs.readFileSync(axe, "utf8"));
    const faults = await tab.evaluate(async () => (await axe.run(document, {runOnly: ["wcag2a", "wcag2aa", "wcag21a", "wcag21aa", "wcag22aa"]}))
      .violations.map(fault => `${fault.id}: ${fault.nodes.map(node => node.html).join(" ").slice(0, 300)}`));
    assert.deepStrictEqual(faults, [], `axe-core at ${width}x${height}`);
    assert.deepStrictEqual(tab.said, [], "on the console");
  }
  return tab;
};

// Without WebAssembly the pictures and the table stay, as without script, and it says why.
const still = async browser => {
  const tab = await browser(address, undefined, () => { delete globalThis.WebAssembly; });
  await tab.until("document.getElementById('fault').textContent", "a word on it");
  await tab.expect("document.querySelectorAll('.live > img').length >= 11 && document.querySelectorAll('table tr').length === 7", "pictures and a table");
  await tab.shot(path.join(scratch, "article-still.png"));
  return tab;
};

run(async browser => {
  for (const test of [sliders, strip, pace, sizes, still]) {
    console.log(test.name);
    const tab = await test(browser);
    assert.deepStrictEqual(tab.said, [], "on the console");
    await tab.page.close();
  }
});
