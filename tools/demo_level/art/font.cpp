#include "tools/demo_level/art/font.h"

#include <algorithm>

namespace oblong::art {
namespace {

constexpr int kGlyphWidth = 5;

/// A letter and its seven rows of five, '#' for ink.
struct Glyph {
    char letter;
    std::string_view ink;
};

constexpr std::array<Glyph, 37> kGlyphs{
    {{'A', ".###.#...##...#######...##...##...#"}, {'B', "####.#...##...#####.#...##...#####."},
     {'C', ".###.#...##....#....#....#...#.###."}, {'D', "####.#...##...##...##...##...#####."},
     {'E', "######....#....####.#....#....#####"}, {'F', "######....#....####.#....#....#...."},
     {'G', ".###.#...##....#.####...##...#.####"}, {'H', "#...##...##...#######...##...##...#"},
     {'I', ".###...#....#....#....#....#...###."}, {'J', "..###...#....#....#....#.#..#..##.."},
     {'K', "#...##..#.#.#..##...#.#..#..#.#...#"}, {'L', "#....#....#....#....#....#....#####"},
     {'M', "#...###.###.#.##.#.##...##...##...#"}, {'N', "#...###..##.#.##..###...##...##...#"},
     {'O', ".###.#...##...##...##...##...#.###."}, {'P', "####.#...##...#####.#....#....#...."},
     {'Q', ".###.#...##...##...##.#.##..#..##.#"}, {'R', "####.#...##...#####.#.#..#..#.#...#"},
     {'S', ".#####....#.....###.....#....#####."}, {'T', "#####..#....#....#....#....#....#.."},
     {'U', "#...##...##...##...##...##...#.###."}, {'V', "#...##...##...##...##...#.#.#...#.."},
     {'W', "#...##...##...##.#.##.#.###.###...#"}, {'X', "#...##...#.#.#...#...#.#.#...##...#"},
     {'Y', "#...##...#.#.#...#....#....#....#.."}, {'Z', "#####....#...#...#...#...#....#####"},
     {'0', ".###.#...##..###.#.###..##...#.###."}, {'1', "..#...##....#....#....#....#...###."},
     {'2', ".###.#...#....#...#...#...#...#####"}, {'3', ".###.#...#....#..##.....##...#.###."},
     {'4', "...#...##..#.#.#..#.#####...#....#."}, {'5', "######....####.....#....##...#.###."},
     {'6', ".###.#....#....####.#...##...#.###."}, {'8', ".###.#...##...#.###.#...##...#.###."},
     {'9', ".###.#...##...#.####....#....#.###."}, {'>', "#.....#.....#.....#...#...#...#...."},
     {':', ".......#....#.........#....#......."}}};

/// The ink of a letter; none for a space or what the font lacks.
std::string_view ink_of(char letter) {
    const auto found = std::find_if(kGlyphs.begin(), kGlyphs.end(), [&](const Glyph& g) { return g.letter == letter; });
    return found == kGlyphs.end() ? std::string_view{} : found->ink;
}

void draw_glyph(Canvas& canvas, std::string_view ink, int x, int y, int scale, Texel texel) {
    for (std::size_t at = 0; at < ink.size(); ++at) {
        if (ink[at] != '#') continue;
        const int column = static_cast<int>(at) % kGlyphWidth, row = static_cast<int>(at) / kGlyphWidth;
        canvas.fill({x + column * scale, y + row * scale, scale, scale}, texel);
    }
}

}  // namespace

int text_width(std::string_view text, int scale) {
    return static_cast<int>(text.size()) * (kGlyphWidth + 1) * scale - scale;
}

void draw_text(Canvas& canvas, std::string_view text, int x, int y, int scale, Texel texel) {
    for (const char letter : text) {
        draw_glyph(canvas, ink_of(letter), x, y, scale, texel);
        x += (kGlyphWidth + 1) * scale;
    }
}

}  // namespace oblong::art
