#include <algorithm>
#include <array>
#include <bit>
#include <cstdlib>
#include <vector>

#include "engine/base/table.h"
#include "engine/pictures/bitmaps.h"

namespace oblong {
namespace {

constexpr std::size_t kFileHeadBytes = 14, kMostBmpHeadBytes = 124;
constexpr std::uint32_t kCoreBytes = 12, kInfoBytes = 40, kOs2Bytes = 64;  ///< sizes of a head
constexpr std::uint32_t kNotPacked = 0, kBitFields = 3, kAlphaBitFields = 6;

/// What is read of the heads of all versions, which differ in what follows the first 16 bytes.
struct BmpHead {
    std::uint32_t pixels_at = 0, bytes = 0, packing = 0, colours_used = 0;
    std::int64_t width = 0, height = 0;
    std::uint32_t bits = 0;
    bool is_from_top = false;
    std::array<std::uint32_t, 4> masks{};  ///< red, green, blue, alpha; of 16 and 32 bits
};

/// The parts of colours of 16 or 32 bits: masks of the file, or else the usual ones.
std::array<std::uint32_t, 4> bmp_masks(const BmpHead& head, LittleEndianReader fields, LittleEndianReader after) {
    if (head.packing == kNotPacked)
        return head.bits == 16 ? std::array{31u << 10, 31u << 5, 31u, 0u}
                               : std::array{0xffu << 16, 0xffu << 8, 0xffu, 0xffu << 24};
    const bool has_alpha = head.bytes > kInfoBytes + 12 || head.packing == kAlphaBitFields;
    LittleEndianReader& in = head.bytes == kInfoBytes ? after : fields;
    std::array<std::uint32_t, 4> masks{};
    for (std::size_t i = 0; i < (has_alpha ? 4u : 3u); ++i) masks[i] = little_endian_u32(take_of_picture(in, 4).data());
    return masks;
}

BmpHead read_bmp_head(LittleEndianReader& in) {
    BmpHead head;
    head.pixels_at = little_endian_u32(take_of_picture(in, 4).data());
    head.bytes = little_endian_u32(take_of_picture(in, 4).data());
    if (head.bytes != kCoreBytes && (head.bytes < 16 || head.bytes > kMostBmpHeadBytes))
        refuse_picture("a BMP whose head has " + std::to_string(head.bytes) +
                       " bytes, expected 12 (OS/2) or 16 to 124");
    std::vector<std::uint8_t> bytes(kMostBmpHeadBytes);
    const auto of_file = take_of_picture(in, head.bytes - 4);
    std::copy(of_file.begin(), of_file.end(), bytes.begin());
    LittleEndianReader fields(bytes);
    const bool is_core = head.bytes == kCoreBytes;
    head.width = is_core ? fields.next<std::uint16_t>() : fields.next<std::int32_t>();
    head.height = is_core ? fields.next<std::uint16_t>() : fields.next<std::int32_t>();
    head.is_from_top = head.height < 0;
    head.height = std::abs(head.height);
    check_picture_size(head.width, head.height);
    fields.next<std::uint16_t>();  // planes
    head.bits = fields.next<std::uint16_t>();
    if (!is_core) head.packing = fields.next<std::uint32_t>();
    fields.take(3 * 4);  // the size of the pixels, the size of a pixel
    if (!is_core) head.colours_used = fields.next<std::uint32_t>();
    const bool has_fields = head.bits == 16 || head.bits == 32, may_have = has_fields && head.bytes != kOs2Bytes;
    const bool is_packed =
        head.packing != kNotPacked && !(may_have && (head.packing == kBitFields || head.packing == kAlphaBitFields));
    if (is_packed)
        refuse_picture("a BMP compressed by way " + std::to_string(head.packing) +
                       (head.packing == 1 || head.packing == 2 ? " (run lengths)" : "") + ", expected none");
    fields.take(4);  // important colours
    if (has_fields) head.masks = bmp_masks(head, fields, in);
    return head;
}

std::vector<Rgba8> bmp_palette(const BmpHead& head, LittleEndianReader in) {
    if (head.bits > 8) return {};
    const std::size_t entry = head.bytes == kCoreBytes ? 3 : 4, most = std::size_t{1} << head.bits;
    const std::size_t room = head.pixels_at > in.offset() ? (head.pixels_at - in.offset()) / entry : 0;
    const std::size_t used = head.colours_used > 0 ? head.colours_used : most;
    std::vector<Rgba8> palette;
    while (palette.size() < std::min({most, used, room})) {
        const auto bgr = take_of_picture(in, entry);
        palette.push_back({{bgr[2], bgr[1], bgr[0]}});
    }
    return palette;
}

std::uint8_t masked(std::uint32_t pixel, std::uint32_t mask) {
    const int shift = std::countr_zero(mask);
    return mask == 0 ? std::uint8_t{0} : of_8_bits((pixel & mask) >> shift, mask >> shift);
}

Rgba8 bmp_pixel(const BmpHead& head, std::span<const Rgba8> palette, std::span<const std::uint8_t> row, std::size_t x) {
    if (head.bits <= 8) {
        const std::size_t bit = x * head.bits;
        return palette_colour(palette, row[bit / 8] >> (8 - head.bits - bit % 8) & ((1u << head.bits) - 1));
    }
    const std::uint8_t* const at = &row[x * head.bits / 8];
    if (head.bits == 24) return {{at[2], at[1], at[0]}};
    const std::uint32_t pixel = head.bits == 16 ? at[0] | std::uint32_t{at[1]} << 8 : little_endian_u32(at);
    const auto& [red, green, blue, alpha] = head.masks;
    return {{masked(pixel, red), masked(pixel, green), masked(pixel, blue)},
            alpha == 0 ? std::uint8_t{255} : masked(pixel, alpha)};
}

}  // namespace

PngImage decode_bmp(std::span<const std::uint8_t> file) {
    LittleEndianReader in(file, std::min<std::size_t>(10, file.size()));
    const BmpHead head = read_bmp_head(in);
    constexpr std::array<std::uint32_t, 7> kBits{1, 2, 4, 8, 16, 24, 32};
    if (std::find(kBits.begin(), kBits.end(), head.bits) == kBits.end())
        refuse_picture("a BMP of " + std::to_string(head.bits) + " bits a pixel, expected 1, 2, 4, 8, 16, 24 or 32");
    const std::vector<Rgba8> palette = bmp_palette(head, in);
    if (head.pixels_at < kFileHeadBytes + head.bytes)
        refuse_picture("pixels at offset " + std::to_string(head.pixels_at) + ", expected them after the head");
    LittleEndianReader pixels(file, std::min<std::size_t>(head.pixels_at, file.size()));
    PngImage image{static_cast<std::int32_t>(head.width), static_cast<std::int32_t>(head.height), {}, {}};
    image.colours.resize(pixel_count(image.width_px, image.height_px));
    const std::size_t width = as_size(image.width_px), row_bytes = (width * head.bits + 31) / 32 * 4;
    for (std::int32_t i = 0; i < image.height_px; ++i) {
        const auto row = take_of_picture(pixels, row_bytes);
        const std::size_t y = as_size(head.is_from_top ? i : image.height_px - 1 - i);
        for (std::size_t x = 0; x < width; ++x) image.colours[y * width + x] = bmp_pixel(head, palette, row, x);
    }
    // A fourth byte that no mask makes alpha is alpha where any is set.
    const auto is_clear = [](const Rgba8& pixel) { return pixel.alpha == 0; };
    const bool is_all_clear = std::all_of(image.colours.begin(), image.colours.end(), is_clear);
    if (head.bits == 32 && head.packing == kNotPacked && is_all_clear)
        for (Rgba8& pixel : image.colours) pixel.alpha = 255;
    return image;
}

}  // namespace oblong
