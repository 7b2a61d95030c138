#include "engine/pictures/picture.h"

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <numeric>
#include <string>
#include <string_view>

#include "engine/base/table.h"
#include "engine/pictures/bitmaps.h"

// Only this file uses stb: for JPEGs.
#define STBI_ONLY_JPEG
#define STBI_NO_STDIO
#define STBI_NO_SIMD               // the same colours on every machine
#define STBI_MAX_DIMENSIONS 65535  // check_jpeg_size() says more
// Zeroed memory: a JPEG without tables is decoded with what is in their place.
#define STBI_MALLOC(size) std::calloc(1, size)
#define STBI_REALLOC std::realloc
#define STBI_FREE std::free
#include <stb/stb_image.h>  // its types

// Where a row has half of the colours, stb gives the last column but one three parts of the column before, instead of
// its own. So its function gets another name, and its own for blocks of 2x2 does the work.
static stbi_uc* stbi__resample_row_h_2(stbi_uc* out, stbi_uc* row, stbi_uc* far_row, int width, int);
[[maybe_unused]] static stbi_uc* unused_row_h_2(stbi_uc*, stbi_uc*, stbi_uc*, int, int);
#define stbi__resample_row_h_2(...) unused_row_h_2(__VA_ARGS__)
#define STB_IMAGE_IMPLEMENTATION
#include <stb/stb_image.h>
#undef stbi__resample_row_h_2

static stbi_uc* stbi__resample_row_h_2(stbi_uc* out, stbi_uc* row, stbi_uc*, int width, int) {
    return stbi__resample_row_hv_2(out, row, row, width, 2);
}

namespace oblong {
namespace {

/// Feeds bytes to stb, which reads zeros beyond the end without an error, and notes if it did.
class Source {
  public:
    explicit Source(std::span<const std::uint8_t> file) : left_(file) {}
    bool is_short() const { return is_short_; }
    static stbi_io_callbacks callbacks() { return {read, skip, is_at_end}; }

  private:
    // stb first fills its own buffer, always the same one, with as much as there is. Into any other it reads exactly
    // what it needs.
    static int read(void* source, char* to, int wanted) {
        Source& self = *static_cast<Source*>(source);
        if (!self.buffer_) self.buffer_ = to;
        const auto size = std::min(self.left_.size(), as_size(wanted));
        std::memset(to, 0, as_size(wanted));
        std::copy_n(self.left_.begin(), size, to);
        self.is_short_ |= size == 0 || (to != self.buffer_ && size < as_size(wanted));
        self.left_ = self.left_.subspan(size);
        return static_cast<int>(size);
    }
    static void skip(void* source, int count) {
        Source& self = *static_cast<Source*>(source);
        const auto size = std::min(self.left_.size(), as_size(std::max(count, 0)));
        self.is_short_ |= count < 0 || size < as_size(count);
        self.left_ = self.left_.subspan(size);
    }
    static int is_at_end(void* source) { return static_cast<Source*>(source)->left_.empty(); }

    std::span<const std::uint8_t> left_;
    const char* buffer_ = nullptr;
    bool is_short_ = false;
};

/// Checks a JPEG's Huffman tables (ISO/IEC 10918-1, B.2.4.2), of one segment: more than 256 codes would be written past
/// the end of stb 2.27's table.
void check_huffman_tables(std::span<const std::uint8_t> file, std::size_t table, std::size_t segment_end) {
    constexpr std::size_t kLengths = 16, kMostCodes = 256;
    while (table < segment_end && table + 1 < file.size()) {
        const auto counts = file.subspan(table + 1, std::min(kLengths, file.size() - table - 1));
        const auto codes = std::accumulate(counts.begin(), counts.end(), std::size_t{0});
        if (codes > kMostCodes)
            refuse_picture("a Huffman table of " + std::to_string(codes) + " codes, expected 256 at most");
        table += 1 + kLengths + codes;
    }
}

/// Walks from marker to marker, as stb does: over the contents of segments, and over the bytes between them.
void check_jpeg_segments(std::span<const std::uint8_t> file) {
    constexpr int kMostScans = 100;  // each costs the time of all pixels; encoders write 10 or so
    int scans = 0;
    for (std::size_t at = 0; at + 3 < file.size();) {
        const std::uint8_t marker = file[at + 1];
        const bool is_marker = file[at] == 0xff && marker != 0xff && marker != 0;
        const bool is_alone = marker == 0x01 || (marker >= 0xd0 && marker <= 0xd8);
        if (is_marker && marker == 0xd9) return;  // the end of the picture
        if (!is_marker || is_alone) {
            at += is_marker || (file[at] == 0xff && marker == 0) ? 2 : 1;
            continue;
        }
        const std::size_t end = at + 2 + std::size_t{file[at + 2]} * 256 + file[at + 3];
        if (marker == 0xc4) check_huffman_tables(file, at + 4, end);
        if (marker == 0xda && ++scans > kMostScans)
            refuse_picture("a JPEG of more than " + std::to_string(kMostScans) + " scans, expected fewer");
        at = end;
    }
}

struct FreePixels {
    void operator()(stbi_uc* pixels) const { stbi_image_free(pixels); }
};

void check_jpeg_size(std::span<const std::uint8_t> file) {
    int width = 0, height = 0, channels = 0;
    const stbi_io_callbacks callbacks = Source::callbacks();
    Source source(file);
    if (!stbi_info_from_callbacks(&callbacks, &source, &width, &height, &channels))
        refuse_picture(std::string("not a readable JPEG (stb: ") + stbi_failure_reason() + ")");
    check_picture_size(width, height);
}

PngImage decode_jpeg(std::span<const std::uint8_t> file) {
    check_jpeg_segments(file);
    check_jpeg_size(file);
    int width = 0, height = 0, channels = 0;
    const stbi_io_callbacks callbacks = Source::callbacks();
    Source source(file);
    const std::unique_ptr<stbi_uc, FreePixels> pixels(
        stbi_load_from_callbacks(&callbacks, &source, &width, &height, &channels, STBI_rgb_alpha));
    if (!pixels) refuse_picture(std::string("a damaged picture (stb: ") + stbi_failure_reason() + ")");
    if (source.is_short()) refuse_picture("the file ends within the picture, expected all of it");
    PngImage image{width, height, {}, {}};
    image.colours.reserve(pixel_count(width, height));
    for (std::size_t i = 0; i < pixel_count(width, height); ++i) {
        const stbi_uc* const rgba = pixels.get() + i * 4;
        image.colours.push_back({{rgba[0], rgba[1], rgba[2]}, rgba[3]});
    }
    return image;
}

bool begins_with(std::span<const std::uint8_t> file, std::string_view letters) {
    return file.size() >= letters.size() && std::memcmp(file.data(), letters.data(), letters.size()) == 0;
}

}  // namespace

PngImage decode_picture(std::span<const std::uint8_t> file) {
    if (begins_with(file, "\x89PNG")) return decode_png(file);
    if (begins_with(file, "BM")) return decode_bmp(file);
    if (begins_with(file, "\xff\xd8")) return decode_jpeg(file);
    if (may_be_tga(file)) return decode_tga(file);
    refuse_picture("not a readable PNG, JPEG, BMP or TGA");
}

}  // namespace oblong
