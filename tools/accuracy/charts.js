// Text, tables and charts of the report, and of tools/article.
// Text: three significant digits without exponent, "0.0213", "375", "12,400".
function number(value) {
  if (value === 0) return "0";
  if (Math.abs(value) < 1e-5) return "below 0.00001";
  const digits = Number(value.toExponential(2).split("e")[1]) + 1;
  return digits >= 3 ? Number(value.toPrecision(3)).toLocaleString("en-US") : value.toFixed(3 - digits);
}
const shortNumber = value => number(value).replace(/(\.\d*?)0+$/, "$1").replace(/\.$/, "");
const escaped = text => String(text).replace(/[&<>"]/g, c => ({ "&": "&amp;", "<": "&lt;", ">": "&gt;", '"': "&quot;" }[c]));
const paragraph = (words, css = "") => `<p class="${css}">${escaped(words)}</p>\n`;

// rows: {cells, isDefault}; the first cell of a row names it.
function table(headings, rows) {
  const cells = (tag, all) => all.map(cell => `<${tag}>${escaped(cell)}</${tag}>`).join("");
  return `<div class="scroll" tabindex="0"><table><thead><tr>${cells("th", headings)}</tr></thead><tbody>\n` +
    rows.map(row => `<tr${row.isDefault ? ' class="default"' : ""}>${cells("td", row.cells)}</tr>\n`).join("") +
    "</tbody></table></div>\n";
}

// Charts: SVG whose colours come from the page's style, by classes.
const at = value => value.toFixed(1);
const svgText = (x, y, anchor, css, words) =>
  `<text class="${css}" x="${at(x)}" y="${at(y)}" text-anchor="${anchor}">${escaped(words)}</text>\n`;
const svgLine = (points, css) => `<polyline class="${css}" points="${points.map(p => p.map(at).join()).join(" ")}"/>\n`;
const svgBar = (x, y, width, css) =>
  `<rect class="${css}" x="${at(x)}" y="${at(y)}" width="${at(width)}" height="14.0"/>\n`;
const svg = (width, height, css, label, content) => `<svg class="${css}" viewBox="0 0 ${width} ${height}" role="img" ` +
  `aria-label="${escaped(label)}">\n${content}</svg>\n`;

// A logarithmic axis from `least` to `greatest`, along pixels `from` to `to`: places of values, and ticks to label.
function logAxis(least, greatest, from, to) {
  greatest = Math.max(greatest, least * 1.01);
  const place = value =>
    from + Math.log(Math.min(Math.max(value, least), greatest) / least) / Math.log(greatest / least) * (to - from);
  return { place, ticks: logTicks(least, greatest) };
}

// At most about eight round values.
function logTicks(least, greatest) {
  const decades = Math.log10(greatest / least), ticks = [];
  if (decades < 0.7) {  // evenly, by 1, 2 or 5 times a power of ten
    const rough = (greatest - least) / 6, unit = 10 ** Math.floor(Math.log10(rough));
    const step = unit * (rough / unit > 5 ? 10 : rough / unit > 2 ? 5 : rough / unit > 1 ? 2 : 1);
    for (let tick = Math.ceil(least / step) * step; tick <= greatest; tick += step) ticks.push(tick);
    return ticks;
  }
  for (let power = Math.floor(Math.log10(least)); 10 ** power <= greatest; power += decades > 8 ? 2 : 1)
    for (const factor of decades < 2.5 ? [1, 2, 5] : [1]) {
      const tick = factor * 10 ** power;
      if (tick >= least && tick <= greatest) ticks.push(tick);
    }
  return ticks;
}

// The marks for which no other has both a smaller error and a lower cost, by rising cost.
function paretoFront(marks) {
  const front = [];
  for (const mark of [...marks].sort((a, b) => a.cost - b.cost || a.error - b.error))
    if (front.length === 0 || mark.error < front.at(-1).error) front.push(mark);
  return front;
}

// Labels beside points where they cover nothing: right, left, above or below; if none is free, none, or over points
// if required.
function labeller(frame) {
  const FONT = 12, CHARACTER = 8.2, taken = [];
  const isFree = (x, y, width, areas = taken) =>
    x >= frame.left && x + width <= frame.right && y >= frame.top && y + FONT <= frame.bottom &&
    !areas.some(b => x < b.right && b.left < x + width && y < b.bottom && b.top < y + FONT);
  const reserve = (x, y, radius) =>
    taken.push({ left: x - radius, top: y - radius, right: x + radius, bottom: y + radius });
  const add = (x, y, name, css, isNeeded) => {
    const width = name.length * CHARACTER;
    const corners = [[x + 9, y - FONT / 2], [x - 9 - width, y - FONT / 2], [x - width / 2, y - 9 - FONT], [x - width / 2, y + 9],
      [x + 7, y - 7 - FONT], [x + 7, y + 7]];
    const corner = corners.find(([left, top]) => isFree(left, top, width)) || (isNeeded ?
      corners.find(([left, top]) => isFree(left, top, width, taken.filter(area => area.isLabel))) || corners[0] : null);
    if (!corner) return "";
    taken.push({ left: corner[0], top: corner[1], right: corner[0] + width, bottom: corner[1] + FONT, isLabel: true });
    return svgText(corner[0], corner[1] + FONT - 2, "start", css, name);
  };
  return { reserve, add };
}
