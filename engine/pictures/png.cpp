#include <png.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>

#include "engine/pictures/bitmaps.h"

namespace oblong {
namespace {

/// libpng's state of reading a file, row by row: its simplified interface for reading puts interlaced pixels of 16 bits
/// in wrong places in some versions. An error of libpng jumps out of its functions: steps have no destructors.
class PngReader {
  public:
    explicit PngReader(std::span<const std::uint8_t> file)
        : left_(file),
          png_(png_create_read_struct(PNG_LIBPNG_VER_STRING, this, fail, ignore)),
          info_(png_create_info_struct(png_)) {
        png_set_read_fn(png_, this, take);
    }
    ~PngReader() { png_destroy_read_struct(&png_, &info_, nullptr); }
    PngReader(const PngReader&) = delete;
    PngReader& operator=(const PngReader&) = delete;

    template <class Steps>
    void run(const char* fault, const Steps& steps) {
        if (setjmp(png_jmpbuf(png_)) != 0) refuse_picture(std::string(fault) + " (libpng: " + message_ + ")");
        steps(png_, info_);
    }

    /// From here on libpng reads the rows of a picture.
    void begin_rows(std::uint32_t height) { height_ = height; }

  private:
    /// Compressed bytes that may follow the last row: libpng inflates all to find their end, a thousand times as many.
    static constexpr std::size_t kMostBehindRows_bytes = 1 << 14;

    bool is_behind_rows() const {
        constexpr int kPasses = 7;  // of an interlaced picture
        const bool is_behind =
            png_get_current_row_number(png_) >= height_ || png_get_current_pass_number(png_) >= kPasses;
        return height_ > 0 && is_behind;
    }
    [[noreturn]] static void fail(png_structp png, png_const_charp message) {
        std::snprintf(static_cast<PngReader*>(png_get_error_ptr(png))->message_, sizeof message_, "%s", message);
        png_longjmp(png, 1);
    }
    static void ignore(png_structp, png_const_charp) {}
    static void take(png_structp png, png_bytep to, std::size_t count) {
        PngReader& self = *static_cast<PngReader*>(png_get_io_ptr(png));
        if (count > self.left_.size()) png_error(png, "the file ends here");
        if (self.is_behind_rows() && (self.behind_rows_bytes_ += count) > kMostBehindRows_bytes)
            png_error(png, "too much data behind the picture's rows");
        std::copy_n(self.left_.begin(), count, to);
        self.left_ = self.left_.subspan(count);
    }

    std::span<const std::uint8_t> left_;
    std::uint32_t height_ = 0;
    std::size_t behind_rows_bytes_ = 0;
    char message_[128] = "";
    png_structp png_;
    png_infop info_;
};

/// What a file says of its picture, and the rows as libpng gives them: indices, or 3 or 4 samples of 8 or 16 bits.
struct PngRows {
    std::uint32_t width = 0, height = 0;
    std::size_t row_bytes = 0;
    int type = 0, depth = 0, channels = 0, palette_size = 0, alphas_size = 0;
    png_colorp palette = nullptr;
    png_bytep alphas = nullptr;
    double gamma = 0;  ///< 0: none, so that samples are of sRGB
    std::vector<std::uint8_t> bytes;

    bool is_indexed() const { return type == PNG_COLOR_TYPE_PALETTE; }
};

PngRows read_rows(PngReader& reader) {
    PngRows rows;
    static constexpr png_byte kSkipped[] = "zTXt\0iTXt\0tEXt\0sPLT";  // else the first two are inflated
    reader.run("not a readable PNG", [&](png_structp png, png_infop info) {
        png_set_keep_unknown_chunks(png, PNG_HANDLE_CHUNK_NEVER, kSkipped, sizeof kSkipped / 5);
        png_read_info(png, info);
        png_get_IHDR(png, info, &rows.width, &rows.height, &rows.depth, &rows.type, nullptr, nullptr, nullptr);
    });
    check_picture_size(rows.width, rows.height);
    reader.run("a damaged PNG", [&](png_structp png, png_infop info) {
        png_get_gAMA(png, info, &rows.gamma);
        png_get_PLTE(png, info, &rows.palette, &rows.palette_size);
        if (rows.is_indexed()) {
            png_get_tRNS(png, info, &rows.alphas, &rows.alphas_size, nullptr);
            png_set_packing(png);
        } else {
            png_set_expand(png);
            png_set_gray_to_rgb(png);
        }
        png_set_interlace_handling(png);
        png_read_update_info(png, info);
        rows.row_bytes = png_get_rowbytes(png, info);
        rows.depth = png_get_bit_depth(png, info);
        rows.channels = png_get_channels(png, info);
    });
    rows.bytes.resize(rows.row_bytes * rows.height);
    std::vector<png_bytep> starts;
    for (std::size_t y = 0; y < rows.height; ++y) starts.push_back(&rows.bytes[y * rows.row_bytes]);
    reader.begin_rows(rows.height);
    reader.run("a damaged PNG", [&](png_structp png, png_infop) { png_read_image(png, starts.data()); });
    return rows;
}

/// Converts samples of 16 bits to 8 bits of sRGB.
class SrgbOfSamples {
  public:
    explicit SrgbOfSamples(double gamma) : gamma_(gamma) {
        constexpr double kSrgb = 1 / 2.2, kAlike = 0.05;
        is_srgb_ = gamma == 0 || std::abs(gamma / kSrgb - 1) < kAlike;
        if (is_srgb_) return;
        for (std::uint32_t i = 0; i < 65'536; ++i) {
            const double light = std::pow(i / 65'535.0, 1 / gamma_);
            const double value = light <= 0.0031308 ? light * 12.92 : 1.055 * std::pow(light, 1 / 2.4) - 0.055;
            of_light_.push_back(static_cast<std::uint8_t>(value * 255 + 0.5));
        }
    }
    static std::uint8_t of_alpha(std::uint32_t sample) { return static_cast<std::uint8_t>((sample + 128) / 257); }
    std::uint8_t operator()(std::uint32_t sample) const { return is_srgb_ ? of_alpha(sample) : of_light_[sample]; }

  private:
    double gamma_;
    bool is_srgb_ = true;
    std::vector<std::uint8_t> of_light_;
};

std::vector<Rgba8> colours_of(const PngRows& rows) {
    const SrgbOfSamples srgb(rows.gamma);
    std::vector<Rgba8> colours;
    for (int i = 0; rows.is_indexed() && i < rows.palette_size; ++i) {
        const png_color& colour = rows.palette[i];
        colours.push_back({{srgb(colour.red * 257u), srgb(colour.green * 257u), srgb(colour.blue * 257u)},
                           i < rows.alphas_size ? rows.alphas[i] : std::uint8_t{255}});
    }
    if (rows.is_indexed()) return colours;
    colours.reserve(std::size_t{rows.width} * rows.height);
    const auto bytes = static_cast<std::size_t>(rows.depth / 8), channels = static_cast<std::size_t>(rows.channels);
    for (std::size_t at = 0; at < rows.bytes.size(); at += channels * bytes) {
        const auto sample = [&](std::size_t i) {
            const std::uint8_t* const big_endian = &rows.bytes[at + i * bytes];
            return big_endian[0] * 256u + big_endian[bytes - 1];  // of 8 bits, times 257
        };
        colours.push_back({{srgb(sample(0)), srgb(sample(1)), srgb(sample(2))},
                           channels > 3 ? srgb.of_alpha(sample(3)) : std::uint8_t{255}});
    }
    return colours;
}

}  // namespace

PngImage decode_png(std::span<const std::uint8_t> file) {
    PngReader reader(file);
    PngRows rows = read_rows(reader);
    PngImage image{static_cast<std::int32_t>(rows.width), static_cast<std::int32_t>(rows.height), {}, colours_of(rows)};
    if (rows.is_indexed()) image.indices = std::move(rows.bytes);
    for (const std::uint8_t index : image.indices) palette_colour(image.colours, index);
    return image;
}

std::vector<std::uint8_t> encode_indexed_png(std::span<const std::uint8_t> pixels, std::int32_t width_px,
                                             std::int32_t height_px, const Palette& palette) {
    check_pixels_to_write(pixels.size(), width_px, height_px);
    std::vector<std::uint8_t> colormap;
    for (const Rgb8& colour : palette.colours) colormap.insert(colormap.end(), {colour.red, colour.green, colour.blue});
    // libpng's simplified interface needs no jumps: a failing call returns 0 and leaves a message. It frees its memory.
    png_image image{};
    image.version = PNG_IMAGE_VERSION;
    image.width = static_cast<png_uint_32>(width_px);
    image.height = static_cast<png_uint_32>(height_px);
    image.format = PNG_FORMAT_RGB_COLORMAP;
    image.colormap_entries = 256;
    png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(image);
    std::vector<std::uint8_t> file(size);
    if (png_image_write_to_memory(&image, file.data(), &size, 0, pixels.data(), 0, colormap.data()) == 0)
        refuse_picture(std::string("the picture could not be compressed (libpng: ") + image.message + ")");
    file.resize(size);
    return file;
}

}  // namespace oblong
