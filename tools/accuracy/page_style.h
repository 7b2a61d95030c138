#pragma once

#include <string_view>

namespace oblong {

/// The style of the report's page.
inline constexpr std::string_view kPageStyle = R"(
:root { color-scheme: light dark; --paper: #fdfcf9; --ink: #1d1f24; --soft: #5d626c; --line: #dcd8cf; --panel: #f3f0e8;
  --error: #b3402a; --cost: #2b6cb0; --front: #8a8f99; --link: #1f5fa8; }
@media (prefers-color-scheme: dark) {
  :root { --paper: #16181d; --ink: #e8e6e1; --soft: #a3a7b0; --line: #33373f; --panel: #1f2229;
    --error: #f08a6b; --cost: #6cb0f5; --front: #7b818c; --link: #8fc1ff; } }
* { box-sizing: border-box; }
body { margin: 0 auto; padding: 1rem 1rem 4rem; max-width: 64rem; background: var(--paper); color: var(--ink);
  font: 1rem/1.5 system-ui, sans-serif; }
h1 { font-size: 1.9rem; line-height: 1.15; margin: 0.5rem 0; }
h2 { margin: 3rem 0 0.5rem; border-top: 2px solid var(--line); padding-top: 1.5rem; }
h3 { margin: 2.5rem 0 0.3rem; }
p { max-width: 44rem; margin: 0.5rem 0; }
a { color: var(--link); }
code { font-family: ui-monospace, monospace; font-size: 0.92em; }
.soft, figcaption { color: var(--soft); font-size: 0.9rem; }
figure { margin: 1rem 0; }
nav { display: flex; flex-wrap: wrap; gap: 0.3rem 0.9rem; margin: 1rem 0; }
.scroll { overflow-x: auto; }
table { border-collapse: collapse; font-size: 0.88rem; margin: 0.8rem 0; font-variant-numeric: tabular-nums; }
th, td { text-align: right; padding: 0.25rem 0.6rem 0.25rem 0; border-bottom: 1px solid var(--line); white-space: nowrap; }
th:first-child, td:first-child { text-align: left; position: sticky; left: 0; background: var(--paper); }
th { font-weight: 600; color: var(--soft); vertical-align: bottom; }
tr.default td { font-weight: 600; }
.note { border-left: 3px solid var(--error); padding-left: 0.8rem; }
.maps { display: flex; flex-wrap: wrap; gap: 1rem; margin: 1rem 0; }
.maps figure { flex: 1 1 17rem; max-width: 28rem; margin: 0; }
.maps img { width: 100%; aspect-ratio: 4 / 3; image-rendering: pixelated; display: block; }
.heat { display: flex; align-items: center; gap: 0.6rem; font-size: 0.85rem; color: var(--soft); }
.heat span.bar { width: 10rem; height: 0.7rem; background: linear-gradient(90deg, #080828, #3c146e, #96286e, #dc503c,
  #faa01e, #fffaa0); }
.heat span.none { width: 0.9rem; height: 0.7rem; background: #6e6e6e; }
svg { display: block; width: 100%; height: auto; font: 12px system-ui, sans-serif; }
svg.dial { max-width: 38rem; }
svg.narrow { display: none; }
@media (max-width: 34rem) { svg.wide { display: none; } svg.narrow { display: block; } h1 { font-size: 1.5rem; } }
svg text { fill: var(--ink); stroke: var(--paper); stroke-width: 3px; paint-order: stroke; stroke-linejoin: round; }
svg .tick { fill: var(--soft); font-size: 11px; }
svg .axis { fill: var(--soft); }
svg .name { font-weight: 700; }
svg polyline { fill: none; }
svg .grid { stroke: var(--line); }
svg .front { stroke: var(--front); stroke-width: 1.5; stroke-dasharray: 5 3; }
svg .preset { fill: var(--error); stroke: var(--paper); stroke-width: 1.5; }
svg .setting { fill: var(--cost); opacity: 0.75; }
svg rect.error { fill: var(--error); }
svg rect.cost { fill: var(--cost); }
svg rect.modelled { opacity: 0.45; }
svg .spread { stroke: var(--ink); stroke-width: 2; }
)";

}  // namespace oblong
