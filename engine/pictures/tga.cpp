#include <algorithm>
#include <array>
#include <vector>

#include "engine/base/table.h"
#include "engine/pictures/bitmaps.h"

namespace oblong {
namespace {

constexpr std::size_t kTgaHeadBytes = 18;
constexpr std::uint8_t kMapped = 1, kTrueColour = 2, kGrey = 3, kPacked = 8;  ///< kinds; the last is added to them
constexpr std::uint8_t kFromRight = 0x10, kFromTop = 0x20, kInterleaved = 0xc0;

struct TgaHead {
    std::uint8_t id_bytes, map_type, kind;
    std::uint16_t map_first, map_count;
    std::uint8_t map_bits;
    std::int32_t width, height;
    std::uint8_t bits, flags;
};

TgaHead read_tga_head(LittleEndianReader& in) {
    TgaHead head{};
    head.id_bytes = in.next<std::uint8_t>();
    head.map_type = in.next<std::uint8_t>();
    head.kind = in.next<std::uint8_t>();
    head.map_first = in.next<std::uint16_t>();
    head.map_count = in.next<std::uint16_t>();
    head.map_bits = in.next<std::uint8_t>();
    in.take(4);  // the place on a screen
    head.width = in.next<std::uint16_t>();
    head.height = in.next<std::uint16_t>();
    head.bits = in.next<std::uint8_t>();
    head.flags = in.next<std::uint8_t>();
    return head;
}

bool is_colour_size(std::uint8_t bits) {
    return bits == 15 || bits == 16 || bits == 24 || bits == 32;
}

Rgba8 tga_colour(std::span<const std::uint8_t> at) {
    if (at.size() == 4) return {{at[2], at[1], at[0]}, at[3]};
    if (at.size() == 3) return {{at[2], at[1], at[0]}};
    const std::uint32_t pixel = at[0] | std::uint32_t{at[1]} << 8;
    const auto part = [&](int shift) { return of_8_bits(pixel >> shift & 31, 31); };
    return {{part(10), part(5), part(0)}};
}

/// Reads pixels one by one, those of a run again and again.
class TgaPixels {
  public:
    TgaPixels(const TgaHead& head, LittleEndianReader& in) : head_(head), in_(in) {
        take_of_picture(in, head.id_bytes);
        for (std::size_t i = 0; head.map_type == 1 && i < head.map_count; ++i) {
            const auto entry = take_of_picture(in, (head.map_bits + std::size_t{7}) / 8);
            if (kind() == kMapped) map_.push_back(tga_colour(entry));
        }
    }

    Rgba8 next() {
        if ((head_.kind & kPacked) == 0) return read();
        if (left_ == 0) {
            const std::uint8_t packet = take_of_picture(in_, 1)[0];
            left_ = (packet & 127) + 1;
            is_run_ = packet > 127;
            if (is_run_) run_ = read();
        }
        --left_;
        return is_run_ ? run_ : read();
    }

  private:
    std::uint8_t kind() const { return head_.kind & ~kPacked; }
    Rgba8 read() {
        const auto at = take_of_picture(in_, (head_.bits + std::size_t{7}) / 8);
        if (kind() == kGrey) return {{at[0], at[0], at[0]}, at.size() > 1 ? at[1] : std::uint8_t{255}};
        if (kind() == kTrueColour) return tga_colour(at);
        return palette_colour(map_, (at.size() > 1 ? at[0] | at[1] << 8 : at[0]) - head_.map_first);
    }

    const TgaHead& head_;
    LittleEndianReader& in_;
    std::vector<Rgba8> map_;
    Rgba8 run_;
    int left_ = 0;
    bool is_run_ = false;
};

}  // namespace

bool may_be_tga(std::span<const std::uint8_t> file) {
    if (file.size() < kTgaHeadBytes) return false;
    LittleEndianReader in(file);
    const TgaHead head = read_tga_head(in);
    const std::uint8_t kind = head.kind & ~kPacked;
    const bool is_grey_size = head.bits == 8 || head.bits == 16;
    return head.map_type <= 1 && (kind == kMapped ? head.map_type == 1 && is_colour_size(head.map_bits) && is_grey_size
                                  : kind == kTrueColour ? is_colour_size(head.bits)
                                                        : kind == kGrey && is_grey_size);
}

PngImage decode_tga(std::span<const std::uint8_t> file) {
    LittleEndianReader in(file);
    const TgaHead head = read_tga_head(in);
    check_picture_size(head.width, head.height);
    if ((head.flags & kInterleaved) != 0) refuse_picture("a TGA whose rows are interleaved, expected them in order");
    TgaPixels pixels(head, in);
    PngImage image{head.width, head.height, {}, {}};
    image.colours.resize(pixel_count(head.width, head.height));
    for (std::int32_t i = 0; i < head.height; ++i)
        for (std::int32_t j = 0; j < head.width; ++j) {
            const std::int32_t y = (head.flags & kFromTop) != 0 ? i : head.height - 1 - i;
            const std::int32_t x = (head.flags & kFromRight) != 0 ? head.width - 1 - j : j;
            item(image.colours, y * head.width + x) = pixels.next();
        }
    return image;
}

}  // namespace oblong
