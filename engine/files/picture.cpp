#include "engine/files/picture.h"

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <numeric>
#include <string>

#include "engine/base/input_error.h"
#include "engine/base/table.h"
#include "engine/view/screen.h"

// Only this file uses stb: for formats other than PNG, since libpng also detects damage.
#define STB_IMAGE_IMPLEMENTATION
#define STBI_ONLY_BMP
#define STBI_ONLY_JPEG
#define STBI_ONLY_TGA
#define STBI_NO_STDIO
#define STBI_NO_SIMD  // the same colours on every machine
#define STBI_MAX_DIMENSIONS 4096
// Zeroed memory: a JPEG without tables is decoded with what is in their place.
#define STBI_MALLOC(size) std::calloc(1, size)
#define STBI_REALLOC std::realloc
#define STBI_FREE std::free
#include <stb/stb_image.h>

namespace oblong {
namespace {

constexpr const char* kFormats = "PNG, JPEG, BMP or TGA";

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

/// Checks the counts of a JPEG's Huffman tables (ISO/IEC 10918-1, B.2.4.2): more than 256 codes would be written past
/// the end of stb 2.27's table. All bytes that stb could take for the marker are checked.
void check_huffman_tables(std::span<const std::uint8_t> file) {
    constexpr std::size_t kLengths = 16, kMostCodes = 256;
    for (std::size_t marker = 0; marker + 4 < file.size(); ++marker) {
        if (file[marker] != 0xff || file[marker + 1] != 0xc4) continue;
        const std::size_t segment_end = marker + 2 + std::size_t{file[marker + 2]} * 256 + file[marker + 3];
        std::size_t table = marker + 4;
        while (table < segment_end && table + 1 < file.size()) {
            const auto counts = file.subspan(table + 1, std::min(kLengths, file.size() - table - 1));
            const auto codes = std::accumulate(counts.begin(), counts.end(), std::size_t{0});
            if (codes > kMostCodes)
                throw InputError("image",
                                 "a Huffman table of " + std::to_string(codes) + " codes, expected 256 at most");
            table += 1 + kLengths + codes;
        }
    }
}

struct FreePixels {
    void operator()(stbi_uc* pixels) const { stbi_image_free(pixels); }
};

void check_size(std::span<const std::uint8_t> file) {
    int width = 0, height = 0, channels = 0;
    const stbi_io_callbacks callbacks = Source::callbacks();
    Source source(file);
    if (!stbi_info_from_callbacks(&callbacks, &source, &width, &height, &channels))
        throw InputError("image", std::string("not a readable ") + kFormats + " (stb: " + stbi_failure_reason() + ")");
    if (width < 1 || height < 1 || width > STBI_MAX_DIMENSIONS || height > STBI_MAX_DIMENSIONS)
        throw InputError("image",
                         std::to_string(width) + "x" + std::to_string(height) + " pixels, expected 1 to 4096 a side");
}

PngImage decode_by_stb(std::span<const std::uint8_t> file) {
    check_huffman_tables(file);
    check_size(file);
    int width = 0, height = 0, channels = 0;
    const stbi_io_callbacks callbacks = Source::callbacks();
    Source source(file);
    const std::unique_ptr<stbi_uc, FreePixels> pixels(
        stbi_load_from_callbacks(&callbacks, &source, &width, &height, &channels, STBI_rgb_alpha));
    if (!pixels) throw InputError("image", std::string("a damaged picture (stb: ") + stbi_failure_reason() + ")");
    if (source.is_short()) throw InputError("image", "the file ends within the picture, expected all of it");
    PngImage image{width, height, {}, {}};
    image.colours.reserve(pixel_count(width, height));
    for (std::size_t i = 0; i < pixel_count(width, height); ++i) {
        const stbi_uc* const rgba = pixels.get() + i * 4;
        image.colours.push_back({{rgba[0], rgba[1], rgba[2]}, rgba[3]});
    }
    return image;
}

bool is_png(std::span<const std::uint8_t> file) {
    constexpr std::uint8_t kSignature[] = {0x89, 'P', 'N', 'G'};
    return file.size() >= std::size(kSignature) &&
           std::equal(std::begin(kSignature), std::end(kSignature), file.begin());
}

}  // namespace

PngImage decode_picture(std::span<const std::uint8_t> file) {
    return is_png(file) ? decode_png(file) : decode_by_stb(file);
}

}  // namespace oblong
