// What the script of accuracy.html makes of a report: one whole page with every dial.
// usage: node page_test.js FOLDER
"use strict";
const assert = require("assert"), fs = require("fs"), path = require("path"), vm = require("vm");

// Runs the page's script; its functions, and what it shows.
function drawPage(file) {
  const [, json, script] = file.match(/<script type="application\/json" id="report">([^<]*)<\/script>\n<script>(.*)<\/script>/s);
  const elements = { report: { textContent: json }, page: {} };
  const context = vm.createContext({ document: { getElementById: id => elements[id] }, btoa });
  vm.runInContext(script, context);
  return { call: code => vm.runInContext(code, context), json, page: elements.page.innerHTML };
}

// Follows tags; those that HTML leaves without an end are skipped.
function checkTags(page) {
  const open = [];
  for (const [, tag] of page.matchAll(/<([^>]*)>/g)) {
    const name = tag.split(/[ /]/, 2)[0];
    if (tag.endsWith("/") || name === "img") continue;
    if (tag.startsWith("/")) assert.equal("/" + open.pop(), tag);
    else open.push(name);
  }
  assert.deepEqual(open, []);
}

function checkSections(page, report) {
  const values = attribute => [...page.matchAll(new RegExp(` ${attribute}="([^"]*)"`, "g"))].map(match => match[1]);
  const ids = values("id"), sources = values("src");
  assert.equal(new Set(ids).size, ids.length);
  for (const link of values("href")) assert(ids.includes(link.replace(/^#/, "")), link);
  assert(sources.length >= 20);
  for (const source of sources) assert(source.startsWith("data:image/png;base64,iVBORw0KGgo"), source.slice(0, 60));
  for (const dial of report.dials) {
    const section = page.split(`<h3 id="${dial.name}"`)[1].split("<h3")[0];
    assert(section.includes('<svg class="dial"'), dial.name);
    assert.notEqual(section.includes("<img"), section.includes("off by this measure: no map"), dial.name);
    for (const setting of dial.settings) assert(section.includes(`<td>${setting.name}</td>`), dial.name);
  }
  for (const level of report.run.levels) assert(page.includes(`<td>${level.name}</td>`), level.name);
  const words = page.replace(/ src="[^"]*"/g, "");
  for (const broken of ["NaN", "undefined", "null", "Infinity", "[object"]) assert(!words.includes(broken), broken);
}

function checkFunctions(call) {
  const equal = (code, expected) => assert.equal(JSON.stringify(call(code)), JSON.stringify(expected), code);
  equal("[0, 0.0213456, 0.1, 375.4, 12446, -12446789, 0.000001, 9.999, 999.7].map(number)",
    ["0", "0.0213", "0.100", "375", "12,400", "-12,400,000", "below 0.00001", "10.0", "1,000"]);
  equal("[0.1, 10, 300].map(shortNumber)", ["0.1", "10", "300"]);
  equal("escaped('a<b>&\"c\"')", "a&lt;b&gt;&amp;&quot;c&quot;");
  equal("paretoFront([[5, 1], [3, 2], [4, 3], [1, 4], [1, 5], [3, 2.5]].map(([error, cost]) => ({ error, cost })))",
    [{ error: 5, cost: 1 }, { error: 3, cost: 2 }, { error: 1, cost: 4 }]);
  const axis = call("logAxis(0.01, 100, 0, 400)");
  for (const [value, place] of [[0.01, 0], [1, 200], [100, 400], [1e9, 400]]) assert(Math.abs(axis.place(value) - place) < 1e-9);
  assert.equal(axis.ticks.length, 5);
  for (const [least, greatest] of [[290, 720], [100, 103], [0.5, 9], [1e-5, 300]]) {
    const ticks = call(`logTicks(${least}, ${greatest})`);
    assert(ticks.length >= 2 && ticks.length <= 10 && ticks.every(tick => tick >= least && tick <= greatest), `${ticks}`);
  }
}

// Nothing that was measured is cheaper on a 486 than a year's preset and nearer by each measure.
function checkYears(report) {
  const all = [...report.tiers, ...report.frontier, ...report.dials.flatMap(dial => dial.settings)];
  for (const year of report.tiers.filter(tier => /^[0-9]+$/.test(tier.name)))
    for (const other of all) {
      const isNearer = ["displacement", "wrong_pixels", "pixel_colour"].every(m => other.errors[m].rms < year.errors[m].rms * 1.0005) &&
        other.errors.displacement.rms < year.errors.displacement.rms * 0.999;
      assert(!isNearer || other.cost.cycles_486 > year.cost.cycles_486, `${other.name} against ${year.name}`);
    }
}

const [file, json] = ["accuracy.html", "accuracy.json"].map(name => fs.readFileSync(path.join(process.argv[2], name), "utf8"));
const drawn = drawPage(file);
assert.deepEqual(JSON.parse(drawn.json), JSON.parse(json));
for (const outside of ["http:", "https:", "url(", "@import", "<script src", "<link"]) assert(!file.includes(outside), outside);
checkTags(drawn.page);
checkSections(drawn.page, JSON.parse(json));
checkFunctions(drawn.call);
checkYears(JSON.parse(json));
