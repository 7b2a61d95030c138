#include "engine/reference/colour.h"

#include <algorithm>
#include <cmath>

namespace oblong::reference {

namespace {

constexpr double kFullLight = 128, kBrightest = 2, kCell = 16;  ///< of a lightmap: value; times that; texels
constexpr int kFirstFullbright = 224;

int wrapped(double texel, int size) {
    const auto whole = static_cast<std::int64_t>(std::floor(texel));
    return static_cast<int>(((whole % size) + size) % size);
}

double sample(const Level& level, const Face& face, int column, int row, std::size_t channel) {
    const std::int64_t count = std::int64_t{face.light_columns} * face.light_rows;
    int sum = 0;
    for (int style = 0; style < face.style_count(); ++style) {
        const auto at = static_cast<std::size_t>(face.light_offset + style * count + row * face.light_columns + column);
        sum += level.coloured_lighting.empty() ? level.lighting[at] : level.coloured_lighting[3 * at + channel];
    }
    return std::min(sum / kFullLight, kBrightest);
}

/// A position between samples, clamped to the face.
struct Cell {
    int from, to;
    double fraction;
};

Cell cell_at(double texel, int first, int count) {
    const double place = std::clamp((texel - first) / kCell, 0.0, count - 1.0);
    const int from = static_cast<int>(place);
    return {from, std::min(from + 1, count - 1), place - from};
}

double between(double from, double to, double fraction) {
    return from + (to - from) * fraction;
}

}  // namespace

Rgb light_at(const Level& level, const Face& face, double u, double v) {
    if (level.lighting.empty()) return {1, 1, 1};
    if (face.light_offset < 0) return {};
    const Cell across = cell_at(u, face.first_u, face.light_columns), down = cell_at(v, face.first_v, face.light_rows);
    const auto along_row = [&](int row, std::size_t channel) {
        return between(sample(level, face, across.from, row, channel), sample(level, face, across.to, row, channel),
                       across.fraction);
    };
    const auto of_channel = [&](std::size_t channel) {
        return between(along_row(down.from, channel), along_row(down.to, channel), down.fraction);
    };
    return {of_channel(0), of_channel(1), of_channel(2)};
}

Rgb true_colour(const Level& level, const Face& face, double u, double v, const Palette& palette) {
    const Texture& texture = level.texture_of(face);
    const int column = wrapped(u, texture.width), row = wrapped(v, texture.height);
    const std::uint8_t texel = texture.texels[static_cast<std::size_t>(row * texture.width + column)];
    const bool is_lit = face.material == Material::Lit && texel < kFirstFullbright;
    const Rgb light = is_lit ? light_at(level, face, u, v) : Rgb{1, 1, 1}, &full = palette[texel];
    return {std::min(full.red * light.red, 255.0), std::min(full.green * light.green, 255.0),
            std::min(full.blue * light.blue, 255.0)};
}

std::vector<ColourPixel> draw_colours(const Level& level, std::span<const PlacedModel> models, const View& view,
                                      const Palette& palette, int samples_per_axis) {
    const double weight = 1.0 / (samples_per_axis * samples_per_axis);
    std::vector<ColourPixel> picture(static_cast<std::size_t>(view.width_px) *
                                     static_cast<std::size_t>(view.height_px));
    std::vector<int> faces;  // of the first rays
    const auto step = [&](int i) { return (2 * i + 1) * (kRayUnit / 2) / samples_per_axis - kRayUnit / 2; };
    for (int i = 0; i < samples_per_axis * samples_per_axis; ++i) {
        const RayShift shift{step(i % samples_per_axis), step(i / samples_per_axis)};
        const Frame frame = draw(level, models, view, shift);
        for (std::size_t at = 0; at < picture.size(); ++at) {
            const Pixel& pixel = frame.pixels[at];
            if (i == 0) faces.push_back(pixel.face);
            if (pixel.face != faces[at]) picture[at].is_border = true;
            if (pixel.face < 0 || level.face(pixel.face).material != Material::Lit) {
                picture[at].is_excluded = true;
                continue;
            }
            const Rgb colour = true_colour(level, level.face(pixel.face), pixel.u, pixel.v, palette);
            Rgb& mean = picture[at].colour;
            mean = {mean.red + colour.red * weight, mean.green + colour.green * weight,
                    mean.blue + colour.blue * weight};
        }
    }
    return picture;
}

}  // namespace oblong::reference
