#include "tools/gallery/page.h"

namespace oblong {

namespace {

constexpr std::string_view kStyle = R"(
:root { color-scheme: light dark; --paper: #fdfcf9; --ink: #1d1f24; --soft: #5d626c; --line: #dcd8cf; --wrong: #b3402a; }
@media (prefers-color-scheme: dark) {
  :root { --paper: #16181d; --ink: #e8e6e1; --soft: #a3a7b0; --line: #33373f; --wrong: #f08a6b; } }
* { box-sizing: border-box; }
body { margin: 0 auto; padding: 1rem 1rem 4rem; max-width: 68rem; background: var(--paper); color: var(--ink);
  font: 1rem/1.5 system-ui, sans-serif; }
h1 { font-size: 1.9rem; margin: 0.5rem 0; }
h2 { margin: 3rem 0 1rem; border-top: 2px solid var(--line); padding-top: 1.5rem; }
section { margin: 2.5rem 0; display: grid; grid-template-columns: minmax(18rem, 30rem) 1fr; gap: 1rem 1.5rem; }
section > div { min-width: 0; }
h3 { margin: 0 0 0.3rem; }
p { margin: 0.3rem 0; }
a { color: inherit; }
code { font-family: ui-monospace, monospace; font-size: 0.9em; overflow-wrap: anywhere; }
.soft, figcaption { color: var(--soft); font-size: 0.9rem; }
img { width: 100%; image-rendering: pixelated; display: block; background: #000; }
figure { margin: 0; min-width: 0; scroll-margin-top: 1rem; }
figcaption { overflow-wrap: anywhere; }
.others { display: grid; grid-template-columns: repeat(auto-fill, minmax(7rem, 1fr)); gap: 0.5rem; margin-top: 0.5rem; }
.others :target { grid-column: 1 / -1; }
nav { columns: 15rem; font-size: 0.9rem; }
nav b { display: block; break-after: avoid; break-inside: avoid; margin-top: 0.4rem; }
nav a { display: block; break-inside: avoid; text-decoration: none; }
table { border-collapse: collapse; font-size: 0.88rem; margin: 0.6rem 0; font-variant-numeric: tabular-nums; width: 100%; }
th, td { text-align: left; padding: 0.2rem 0.6rem 0.2rem 0; border-bottom: 1px solid var(--line); vertical-align: top; }
th { color: var(--soft); font-weight: 600; }
.wrong { color: var(--wrong); font-weight: 700; }
@media (max-width: 46rem) { section { grid-template-columns: 1fr; } }
)";

constexpr std::array<std::string_view, 5> kSeeds{
    "1 Muratori: Inspecting the 3D Pipeline", "2 Lab: The Three-Dimensional Viewing Pipeline",
    "3 Notes: Rendering pipeline", "4 Princeton: 3D Polygon Rendering Pipeline", "5 Abrash: Frames of Reference"};

std::string escaped(std::string_view text) {
    std::string html;
    for (const char character : text) {
        if (character == '&')
            html += "&amp;";
        else if (character == '<')
            html += "&lt;";
        else if (character == '"')
            html += "&quot;";
        else
            html += character;
    }
    return html;
}

std::string link_of(const Row& row) {
    return "<a href=\"#" + std::string(row.id) + "\">" + escaped(row.name) + "</a>\n";
}

/// A picture that a click enlarges to its section's width: opened alone, a browser would show square pixels.
std::string picture_html(const PagePicture& picture, const std::string& id, const ScreenMode& mode) {
    const std::string shape = std::to_string(mode.display.numerator) + " / " + std::to_string(mode.display.denominator);
    std::string html = "<figure id=\"" + id + "\"><a href=\"#" + id + "\"><img src=\"" + picture.file + "\" alt=\"" +
                       escaped(picture.caption) + "\" style=\"aspect-ratio: " + shape + "\"></a>";
    if (!picture.caption.empty()) html += "<figcaption>" + escaped(picture.caption) + "</figcaption>";
    return html + "</figure>\n";
}

std::string figures_html(const Figures& figures) {
    if (figures.empty()) return "";
    std::string html = "<table><tr><th>figure</th><th>expected</th><th>found</th></tr>\n";
    for (const Figure& figure : figures)
        html += "<tr><td>" + escaped(figure.name) + "</td><td>" + escaped(figure.expected) + "</td><td" +
                (figure.agrees ? "" : " class=\"wrong\"") + ">" + escaped(figure.found) + "</td></tr>\n";
    return html + "</table>\n";
}

std::string text_html(const PageRow& shown) {
    const Row& row = shown.row;
    std::string html = "<h3>" + escaped(row.name) + "</h3>\n<p class=\"soft\">" + escaped(row.seeds) +
                       "<br>source <code>" + escaped(row.source) + "</code><br>test <code>" + escaped(row.test) +
                       "</code></p>\n";
    for (const std::string_view note : row.notes) html += "<p>" + escaped(note) + "</p>\n";
    html += figures_html(shown.figures.front());
    for (std::size_t i = 1; i < shown.figures.size(); ++i) {
        const std::string figures = figures_html(shown.figures[i]);
        if (figures.empty()) continue;
        html += "<details><summary class=\"soft\">" + escaped(shown.pictures[i].caption) + "</summary>" + figures +
                "</details>\n";
    }
    return html;
}

std::string row_html(const PageRow& shown, const ScreenMode& mode) {
    const std::string id(shown.row.id);
    std::string html = "<section id=\"" + id + "\"><div>" + picture_html(shown.pictures[0], id + "-0", mode);
    if (shown.pictures.size() > 1) {
        html += "<div class=\"others\">";
        for (std::size_t i = 1; i < shown.pictures.size(); ++i)
            html += picture_html(shown.pictures[i], id + "-" + std::to_string(i), mode);
        html += "</div>";
    }
    return html + "</div><div>" + text_html(shown) + "</div></section>\n";
}

std::string seed_of(const Row& row) {
    for (const std::string_view seed : kSeeds)
        if (seed.front() == row.seeds.front()) return escaped(seed);
    return "";
}

}  // namespace

std::string index_page(const std::vector<PageRow>& rows, const ScreenMode& mode) {
    std::string body, contents, last_seed;
    std::size_t figures = 0;
    for (const PageRow& shown : rows) {
        if (const std::string seed = seed_of(shown.row); seed != last_seed) {
            body += "<h2>" + seed + "</h2>\n";
            contents += "<b>" + seed + "</b>\n";
            last_seed = seed;
        }
        contents += link_of(shown.row);
        body += row_html(shown, mode);
        for (const Figures& of_picture : shown.figures) figures += of_picture.size();
    }
    return "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><meta name=\"viewport\" "
           "content=\"width=device-width\"><title>Oblong: the gallery</title><style>" +
           std::string(kStyle) +
           "</style></head><body>\n<h1>The gallery</h1>\n<p>All that the five texts name, drawn by Oblong: " +
           std::to_string(rows.size()) + " rows, " + std::to_string(figures) +
           " figures. An expected value is worked out from the text, as corrected, or by an independent method; a "
           "figure without "
           "one is a measurement. <code>oblong --gallery</code> steps through the same.</p>\n<nav>" +
           contents + "</nav>\n" + body + "</body></html>\n";
}

}  // namespace oblong
