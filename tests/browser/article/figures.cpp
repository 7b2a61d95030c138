// What the article's page shows, computed natively: for each line of standard input, a view as numbers (x, y, z, yaw,
// pitch, roll, field of view, drawn for tall pixels, the measure, and the value of each dial), a line of JSON.
//   article_figures LEVEL PALETTE
#include <cstdio>
#include <iostream>
#include <string>

#include "engine/base/checksum.h"
#include "engine/io/files.h"
#include "tools/article/article.h"

namespace {

/// Of the bytes as a page's canvas has them.
unsigned crc_of(const std::vector<std::uint32_t>& picture) {
    std::vector<std::uint8_t> bytes;
    for (const std::uint32_t pixel : picture)
        for (int shift = 0; shift < 32; shift += 8) bytes.push_back(static_cast<std::uint8_t>(pixel >> shift));
    return oblong::crc32(bytes);
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 3) return 2;
    oblong::Article article(oblong::read_file(argv[1]), oblong::read_file(argv[2]));
    oblong::ArticleEye eye;
    int is_tall = 1, measure = 0;
    while (std::cin >> eye.x >> eye.y >> eye.z >> eye.yaw >> eye.pitch >> eye.roll >> eye.field_of_view >> is_tall >>
           measure) {
        for (std::size_t dial = 0; dial < oblong::all_dials().size(); ++dial) {
            std::int32_t value = 0;
            std::cin >> value;
            article.set_dial(dial, value);
        }
        article.correct_aspect(is_tall != 0);
        if (!article.look_from(eye)) return 1;
        const unsigned picture = crc_of(article.draw()), reference = crc_of(article.draw_reference()),
                       errors = crc_of(article.draw_errors(static_cast<oblong::Measure>(measure)));
        std::printf("{\"picture\": %u, \"reference\": %u, \"errors\": %u, \"figures\": %s}\n", picture, reference,
                    errors, article.figures().c_str());
    }
    return 0;
}
