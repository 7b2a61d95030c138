#include "tools/gallery/page.h"

#include "tools/gallery/texts.h"

namespace oblong {

namespace {

constexpr std::array<std::string_view, 5> kSeeds{
    "1 Muratori: Inspecting the 3D Pipeline", "2 Lab: The Three-Dimensional Viewing Pipeline",
    "3 Notes: Rendering pipeline", "4 Princeton: 3D Polygon Rendering Pipeline", "5 Abrash: Frames of Reference"};

std::string escaped(std::string_view text) {
    std::string html;
    for (const char letter : text)
        html += letter == '&' ? "&amp;" : letter == '<' ? "&lt;" : letter == '"' ? "&quot;" : std::string(1, letter);
    return html;
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
        contents += "<a href=\"#" + std::string(shown.row.id) + "\">" + escaped(shown.row.name) + "</a>\n";
        body += row_html(shown, mode);
        for (const Figures& of_picture : shown.figures) figures += of_picture.size();
    }
    std::string page(kPage);
    const auto put = [&](std::string_view place, const std::string& text) {
        page.replace(page.find(place), place.size(), text);
    };
    put("@rows", std::to_string(rows.size()));
    put("@figures", std::to_string(figures));
    put("@contents", contents);
    put("@body", body);
    return page;
}

}  // namespace oblong
