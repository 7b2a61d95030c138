#include "tools/map/source/textures.h"

#include <algorithm>
#include <numbers>

#include "engine/base/input_error.h"
#include "engine/base/text.h"
#include "engine/io/wad.h"
#include "tools/map/source/brush.h"

namespace oblong::map {

namespace {

// Standard maps project a texture along the coordinate axis that the side faces most; of equal ones, z is before x, and
// x before y. Rows of a texture run down.
std::array<Point, 2> standard_axes(const Point& normal) {
    const double x = std::abs(normal.x), y = std::abs(normal.y), z = std::abs(normal.z);
    if (z >= x && z >= y) return {Point{1, 0, 0}, Point{0, -1, 0}};
    if (x >= y) return {Point{0, 1, 0}, Point{0, 0, -1}};
    return {Point{1, 0, 0}, Point{0, 0, -1}};
}

// Rotates the axes in the plane of their two world axes (in the order x, y, z, except that u's is first).
std::array<Point, 2> rotated(const std::array<Point, 2>& axes, double degrees) {
    const Turn turn = turn_of(degrees);
    const auto carrier = [](const Point& axis) { return axis.x != 0 ? 0 : axis.y != 0 ? 1 : 2; };
    const int first = carrier(axes[0]), second = carrier(axes[1]);
    std::array<Point, 2> result = axes;
    for (Point& axis : result) {
        const double u = axis[first], v = axis[second];
        axis[first] = turn.cosine * u - turn.sine * v;
        axis[second] = turn.sine * u + turn.cosine * v;
    }
    return result;
}

constexpr std::string_view kFrames = "0123456789abcdefghij";

// What is wrong with a texture of a WAD, which the engine could not draw; empty: nothing.
std::string fault_of(const std::string& miptex) {
    try {
        parse_miptex({reinterpret_cast<const std::uint8_t*>(miptex.data()), miptex.size()});
    } catch (const InputError& error) {
        return error.where + " of the WAD: " + error.what();
    }
    return "";
}

// Null: no WAD has it.
const std::string* find_in(const std::vector<Wad>& wads, const std::string& name) {
    for (const Wad& wad : wads)
        if (const std::string* const found = wad.find(name)) return found;
    return nullptr;
}

std::string fault_of_missing(const std::string& name, const std::vector<Wad>& wads) {
    NearestName nearest(name);
    for (const Wad& wad : wads) wad.add_names(nearest);
    return "texture '" + name + "' is not in any of the WAD files" + nearest.text() +
           ", expected its WAD in worldspawn's 'wad' or in --wad";
}

// The engine's own, for textures without texels; other engines draw it, too. Skies are two squares.
std::string make_checkerboard(std::string name) {
    constexpr std::size_t kNameSize = 16, kSize = 64;
    constexpr char kLight = 15, kDark = 0;
    std::string miptex, texels;
    const auto put = [&](std::size_t number) {
        for (int shift = 0; shift < 32; shift += 8) miptex += static_cast<char>(number >> shift & 255);
    };
    const std::size_t width = contents_of_texture(name) == contents::kSky ? 2 * kSize : kSize;
    name.resize(kNameSize - 1);
    miptex = name + '\0';
    put(width);
    put(kSize);
    for (std::size_t square = kSize / 8, mip = 0; mip < 4; ++mip, square /= 2) {
        put(kNameSize + 6 * 4 + texels.size());
        for (std::size_t i = 0; i < width * kSize >> 2 * mip; ++i)
            texels += (i % (width >> mip) / square + i / (width >> mip) / square) % 2 == 0 ? kLight : kDark;
    }
    return miptex + texels;
}

// The engine reads no more; a surface of more would be cut into very many faces.
void check_density(const std::array<Point, 2>& axes, const MapSide& side) {
    constexpr double kMost = 255;
    for (const Point& axis : axes)
        if (largest_component(axis) > kMost)
            throw InputError(
                at_line(side.line),
                "texture '" + side.texture.name + "' has more than 255 texels a unit, expected a larger texture scale");
}

bool is_animated(const std::string& name) {
    return name.size() > 2 && name[0] == '+';
}

constexpr std::size_t kFramesOfRow = 10;

// "+0lamp, +2lamp" without "+1lamp": Quake stops at such a level.
void warn_of_gap(const TextureUse& use, const std::vector<Wad>& wads, Warnings& warnings) {
    for (std::size_t row = 0; row < kFrames.size(); row += kFramesOfRow) {
        std::string missing;
        for (std::string name = use.name; const char frame : kFrames.substr(row, kFramesOfRow)) {
            name[1] = frame;
            if (name != use.name && find_in(wads, name) == nullptr) {
                if (missing.empty()) missing = name;
                continue;
            }
            if (missing.empty()) continue;
            warnings.add(use.line, "the animation of '" + use.name + "' has '" + name + "' but no '" + missing +
                                       "', expected frames without gaps");
            break;
        }
    }
}

// Clouds left, stars right.
void warn_of_sky(const TextureUse& use, const std::string& texture, Warnings& warnings) {
    const MipTexture sky = parse_miptex({reinterpret_cast<const std::uint8_t*>(texture.data()), texture.size()});
    if (contents_of_texture(use.name) == contents::kSky && sky.width != 2 * sky.height)
        warnings.add(use.line, "the sky '" + use.name + "' has " + std::to_string(sky.width) + "x" +
                                   std::to_string(sky.height) + " texels, expected two squares side by side");
}

}  // namespace

Turn turn_of(double degrees) {
    const double quarters = degrees / 90;
    if (quarters == std::floor(quarters)) {
        const int quarter = static_cast<int>(quarters) & 3;
        return {quarter == 0 ? 1.0 : quarter == 2 ? -1.0 : 0.0, quarter == 1 ? 1.0 : quarter == 3 ? -1.0 : 0.0};
    }
    const double radians = degrees * std::numbers::pi / 180;
    return {std::cos(radians), std::sin(radians)};
}

std::array<Point, 2> texture_axes(const TextureFields& fields, const Point& normal) {
    return fields.has_axes ? fields.axes : rotated(standard_axes(normal), fields.rotation_degrees);
}

int TextureList::find_or_add(const MapSide& side, const Point& normal) {
    const TextureFields& fields = side.texture;
    if (is_undrawn_texture(fields.name)) return -1;
    TexInfo wanted;
    wanted.axes = texture_axes(fields, normal);
    for (std::size_t i = 0; i < 2; ++i) wanted.axes[i] = wanted.axes[i] * (1 / fields.scale[i]);
    check_density(wanted.axes, side);
    wanted.offset = fields.offset;
    wanted.texture = find_or_add_name({fields.name, side.line});
    wanted.light = fields.light;
    wanted.is_special = contents_of_texture(fields.name) != contents::kSolid;
    const auto known = std::find(texinfos_.begin(), texinfos_.end(), wanted);
    const auto index = static_cast<int>(known - texinfos_.begin());
    if (known == texinfos_.end()) texinfos_.push_back(wanted);
    return index;
}

int TextureList::find_or_add_name(const TextureUse& use) {
    for (std::size_t i = 0; i < names_.size(); ++i)
        if (names_[i].name == use.name) return static_cast<int>(i);
    names_.push_back(use);
    return static_cast<int>(names_.size()) - 1;
}

Wad::Wad(const std::string& bytes) {
    const std::span file(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size());
    for (const WadTexture& texture : read_wad(file)) {
        std::string miptex(texture.miptex.begin(), texture.miptex.end());
        constexpr std::size_t kNameSize = 16;
        if (!has_own_name(texture))
            miptex.replace(0, kNameSize, texture.name + std::string(kNameSize - texture.name.size(), '\0'));
        textures_.emplace(lower_case(texture.name), std::move(miptex));
    }
}

const std::string* Wad::find(const std::string& name) const {
    const auto found = textures_.find(name);
    return found == textures_.end() ? nullptr : &found->second;
}

void Wad::add_names(NearestName& nearest) const {
    for (const auto& [name, bytes] : textures_) nearest.add(name);
}

std::vector<std::string> collect_textures(const std::vector<TextureUse>& uses, const std::vector<Wad>& wads,
                                          Warnings& warnings) {
    std::vector<std::string> textures, names;
    const auto add = [&](const TextureUse& use, const std::string* texture) {
        const std::string fault = texture == nullptr ? fault_of_missing(use.name, wads) : fault_of(*texture);
        if (!fault.empty()) warnings.add(use.line, fault + ": a checkerboard is shown");
        textures.push_back(fault.empty() ? *texture : make_checkerboard(use.name));
        names.push_back(use.name);
    };
    for (const TextureUse& use : uses) {
        add(use, find_in(wads, use.name));
        warn_of_sky(use, textures.back(), warnings);
        if (is_animated(use.name)) warn_of_gap(use, wads, warnings);
    }
    for (const TextureUse& use : uses) {
        if (!is_animated(use.name)) continue;
        for (std::string name = use.name; const char frame : kFrames) {
            name[1] = frame;
            const std::string* texture = find_in(wads, name);
            if (texture != nullptr && std::find(names.begin(), names.end(), name) == names.end())
                add({name, use.line}, texture);
        }
    }
    return textures;
}

}  // namespace oblong::map
