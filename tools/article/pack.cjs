// Makes the article's page of what was built, a single file.      node pack.cjs BUILD ASSETS SITE
// What needs no script is drawn here, by the same module: each figure's picture, and the table of presets.
"use strict";
const fs = require("fs"), path = require("path"), zlib = require("zlib");

const [build, assets, site] = process.argv.slice(2), accuracy = path.join(__dirname, "../accuracy");
const level = path.join(assets, "../article");
const read = (...name) => fs.readFileSync(path.join(...name));
const text = (...name) => read(...name).toString();
const FIGURES = JSON.parse(text(__dirname, "figures.json"));
// The page's classes and functions, for here.
const {Engine, number, table} = new Function(`${text(accuracy, "charts.js")}${text(__dirname, "engine.js")}` +
  "return {Engine, number, table};")();

const crc = bytes => {
  let sum = ~0;
  for (const byte of bytes) {
    sum ^= byte;
    for (let i = 0; i < 8; ++i) sum = sum >>> 1 ^ (sum & 1 && 0xEDB88320);
  }
  return ~sum >>> 0;
};

const png = (rgba, width, height) => {
  const rows = Buffer.alloc(height * (1 + width * 3));
  for (let i = 0; i < width * height; ++i)
    for (let c = 0; c < 3; ++c) rows[1 + Math.floor(i / width) + i * 3 + c] = rgba[i * 4 + c];
  const part = (name, content) => {
    const named = Buffer.concat([Buffer.from(name), content]), frame = Buffer.alloc(8);
    frame.writeUInt32BE(content.length, 0);
    frame.writeUInt32BE(crc(named), 4);
    return Buffer.concat([frame.subarray(0, 4), named, frame.subarray(4)]);
  };
  const head = Buffer.from([0, 0, 0, 0, 0, 0, 0, 0, 8, 2, 0, 0, 0]);
  head.writeUInt32BE(width, 0);
  head.writeUInt32BE(height, 4);
  return Buffer.concat([Buffer.from("\x89PNG\r\n\x1a\n", "latin1"), part("IHDR", head), part("IDAT", zlib.deflateSync(rows, {level: 9})),
                        part("IEND", Buffer.alloc(0))]);
};
const image = (engine, figure) => {
  const {picture} = engine.draw(engine.startOf(figure)), bytes = png(picture, engine.width, engine.height);
  return `<img src="data:image/png;base64,${bytes.toString("base64")}" width="320" height="240" alt="${figure.alt}">`;
};

const presets = engine => table(["preset", "texels out of place, pixels: rms", "largest", ...engine.processors.map(p => p.name + ", ms")],
  engine.presets.map(({name, values}) => {
    const view = {...engine.startOf(FIGURES.find(figure => figure.id === "all")), values};
    const {cycles} = engine.draw(view), {rms, max} = engine.errors(view, 0);
    return {isDefault: name === "bounded", cells: [name, number(rms), number(max), ...cycles.map((_, p) => number(engine.milliseconds(p, cycles)))]};
  }));

require(path.resolve(build, "article.js"))({wasmBinary: read(build, "article.wasm")}).then(module => {
  const engine = new Engine(module, read(level, "article.bsp"), read(assets, "palette.lmp"));
  let page = text(__dirname, "page.html");
  const put = (mark, content) => {
    if (!page.includes(mark)) throw new Error("page.html has no " + mark);
    page = page.replace(mark, () => content);
  };
  for (const figure of FIGURES) put(`<!--@figure ${figure.id}@-->`, `<div class="live" id="figure-${figure.id}">${image(engine, figure)}</div>`);
  put("<!--@presets@-->", presets(engine));
  put("/*@style@*/", text(accuracy, "style.css") + text(__dirname, "page.css"));
  const icon = read(__dirname, "../../assets/package/icons/oblong-32.png").toString("base64");
  put("<!--@icon@-->", `<link rel="icon" href="data:image/png;base64,${icon}">`);
  put("//@figures@", `const FIGURES = ${JSON.stringify(FIGURES)};`);
  put("//@scripts@", [[accuracy, "charts.js"], ...["engine", "figure", "strip", "page"].map(name => [__dirname, name + ".js"])]
    .map(name => text(...name)).join(""));
  put("//@module@", text(build, "article.js"));
  const files = [[build, "article.wasm"], [level, "article.bsp"], [assets, "palette.lmp"]];
  put("<!--@files@-->", files.map(([folder, name]) =>
    `<script type="text/plain" id="${name}">${zlib.gzipSync(read(folder, name), {level: 9}).toString("base64")}</script>\n`).join(""));
  fs.mkdirSync(site, {recursive: true});
  fs.writeFileSync(path.join(site, "accuracy.html"), page);
  console.log(`accuracy.html: ${page.length} bytes`);
}).catch(error => {
  console.error("pack.cjs: " + error.stack);
  process.exit(1);
});
