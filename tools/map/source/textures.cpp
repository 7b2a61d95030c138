#include "tools/map/source/textures.h"

#include <algorithm>
#include <numbers>

#include "engine/base/input_error.h"
#include "engine/base/text.h"
#include "engine/files/wad.h"
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

// The engine would refuse a level with a texture of another size, or without its texels.
void check_texture(const std::string& miptex, int line) {
    try {
        parse_miptex({reinterpret_cast<const std::uint8_t*>(miptex.data()), miptex.size()});
    } catch (const InputError& error) {
        throw InputError(at_line(line), error.where + " of the WAD: " + error.what());
    }
}

// Null: no WAD has it.
const std::string* find_in(const std::vector<Wad>& wads, const TextureUse& use) {
    for (const Wad& wad : wads) {
        const std::string* const found = wad.find(use.name);
        if (found == nullptr) continue;
        check_texture(*found, use.line);
        return found;
    }
    return nullptr;
}

[[noreturn]] void throw_missing(const TextureUse& use, const std::vector<Wad>& wads) {
    NearestName nearest(use.name);
    for (const Wad& wad : wads) wad.add_names(nearest);
    throw InputError(at_line(use.line), "texture '" + use.name + "' is not in any of the WAD files" + nearest.text() +
                                            ": add its WAD to worldspawn's 'wad', or see --wad");
}

// The engine reads no more; a surface of more would be cut into very many faces.
void check_density(const std::array<Point, 2>& axes, const MapSide& side) {
    constexpr double kMost = 255;
    for (const Point& axis : axes)
        if (std::max({std::abs(axis.x), std::abs(axis.y), std::abs(axis.z)}) > kMost)
            throw InputError(
                at_line(side.line),
                "texture '" + side.texture.name + "' has more than 255 texels a unit, expected a larger texture scale");
}

bool is_animated(const std::string& name) {
    return name.size() > 2 && name[0] == '+';
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
    wanted.smooth_degrees = fields.smooth_degrees;
    wanted.is_special = contents_of_texture(fields.name) != contents::kSolid;
    for (std::size_t i = 0; i < texinfos_.size(); ++i) {
        if (texinfos_[i] == wanted) return static_cast<int>(i);
    }
    texinfos_.push_back(wanted);
    return static_cast<int>(texinfos_.size()) - 1;
}

int TextureList::find_or_add_name(const TextureUse& use) {
    for (std::size_t i = 0; i < names_.size(); ++i) {
        if (names_[i].name == use.name) return static_cast<int>(i);
    }
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

std::vector<std::string> collect_textures(const std::vector<TextureUse>& uses, const std::vector<Wad>& wads) {
    std::vector<std::string> textures, names;
    for (const TextureUse& use : uses) {
        const std::string* texture = find_in(wads, use);
        if (texture == nullptr) throw_missing(use, wads);
        textures.push_back(*texture);
        names.push_back(use.name);
    }
    for (const TextureUse& use : uses) {
        for (const char frame : kFrames) {
            std::string name = use.name;
            if (!is_animated(name)) break;
            name[1] = frame;
            const std::string* texture = find_in(wads, {name, use.line});
            if (texture == nullptr || std::find(names.begin(), names.end(), name) != names.end()) continue;
            textures.push_back(*texture);
            names.push_back(name);
        }
    }
    return textures;
}

}  // namespace oblong::map
