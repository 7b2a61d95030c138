#include "tests/map/map_source.h"

#include <cmath>
#include <numbers>

namespace oblong::test {
namespace {

std::string text_of(const Whole& point) {
    return "( " + std::to_string(point[0]) + " " + std::to_string(point[1]) + " " + std::to_string(point[2]) + " ) ";
}

void put_u32(std::string& bytes, std::size_t value) {
    for (int i = 0; i < 4; ++i) bytes.push_back(static_cast<char>(value >> (8 * i) & 255));
}

void put_name(std::string& bytes, std::string name) {
    name.resize(16);
    bytes += name;
}

std::string miptex(const std::string& name, char colour) {
    std::string bytes;
    put_name(bytes, name);
    put_u32(bytes, 16);
    put_u32(bytes, 16);
    std::size_t offset = 40;
    for (std::size_t size : {256u, 64u, 16u, 4u}) {
        put_u32(bytes, offset);
        offset += size;
    }
    return bytes + std::string(256 + 64 + 16 + 4, colour);
}

Whole rounded(double x, double y, double z) {
    return {static_cast<int>(std::lround(x)), static_cast<int>(std::lround(y)), static_cast<int>(std::lround(z))};
}

double turn(int part, int of) {
    return 2 * std::numbers::pi * part / of;
}

}  // namespace

std::string brush(const std::vector<std::array<Whole, 3>>& sides, std::string_view texture) {
    std::string text = "{\n";
    for (const auto& points : sides) {
        for (const Whole& point : points) text += text_of(point);
        text += std::string(texture) + " 0 0 0 1 1\n";
    }
    return text + "}\n";
}

std::string box(const Whole& mins, const Whole& maxs, std::string_view texture) {
    const auto [x, y, z] = mins;
    const auto [X, Y, Z] = maxs;
    return brush({{{{x, y, Z}, {x, Y, Z}, {X, Y, Z}}},
                  {{{x, y, z}, {X, y, z}, {X, Y, z}}},
                  {{{x, y, z}, {x, Y, z}, {x, Y, Z}}},
                  {{{X, y, z}, {X, y, Z}, {X, Y, Z}}},
                  {{{x, y, z}, {x, y, Z}, {X, y, Z}}},
                  {{{x, Y, z}, {X, Y, z}, {X, Y, Z}}}},
                 texture);
}

std::string room(const Whole& mins, const Whole& maxs, int thick, std::string_view texture) {
    const auto [x, y, z] = mins;
    const auto [X, Y, Z] = maxs;
    const int t = thick;
    return box({x - t, y - t, z - t}, {X + t, Y + t, z}, texture) +
           box({x - t, y - t, Z}, {X + t, Y + t, Z + t}, texture) + box({x - t, y, z}, {x, Y, Z}, texture) +
           box({X, y, z}, {X + t, Y, Z}, texture) + box({x - t, y - t, z}, {X + t, y, Z}, texture) +
           box({x - t, Y, z}, {X + t, Y + t, Z}, texture);
}

std::string prism(const Whole& centre, int radius, int height, int side_count, std::string_view texture) {
    const auto [x, y, z] = centre;
    std::vector<std::array<Whole, 3>> sides = {{{{x, y, z + height}, {x, y + 8, z + height}, {x + 8, y, z + height}}},
                                               {{{x, y, z}, {x + 8, y, z}, {x, y + 8, z}}}};
    const auto corner = [&, cx = x, cy = y](int i, int at_z) {
        return rounded(cx + radius * std::cos(turn(i, side_count)), cy + radius * std::sin(turn(i, side_count)), at_z);
    };
    for (int i = 0; i < side_count; ++i) sides.push_back({corner(i, z), corner(i, z + height), corner(i + 1, z)});
    for (std::size_t i = 2; i < sides.size(); ++i) std::swap(sides[i][1], sides[i][2]);
    for (std::size_t i = 2; i < sides.size(); ++i) std::swap(sides[i][0], sides[i][1]);
    return brush(sides, texture);
}

std::string ball(const Whole& centre, int radius, int rings, int sectors, std::string_view texture) {
    std::vector<std::array<Whole, 3>> sides;
    const auto corner = [&](int ring, int sector) {
        const double height = std::numbers::pi * ring / rings;
        return rounded(centre[0] + radius * std::sin(height) * std::cos(turn(sector, sectors)),
                       centre[1] + radius * std::sin(height) * std::sin(turn(sector, sectors)),
                       centre[2] + radius * std::cos(height));
    };
    for (int ring = 0; ring < rings; ++ring) {
        for (int sector = 0; sector < sectors; ++sector) {
            if (ring == 0) {
                sides.push_back({corner(0, 0), corner(1, sector + 1), corner(1, sector)});
            } else {
                sides.push_back({corner(ring, sector), corner(ring, sector + 1), corner(ring + 1, sector)});
            }
        }
    }
    return brush(sides, texture);
}

std::string entity(std::string_view class_name, const std::vector<std::array<std::string, 2>>& pairs,
                   std::string_view brushes) {
    std::string text = "{\n\"classname\" \"" + std::string(class_name) + "\"\n";
    for (const auto& [key, value] : pairs) text += "\"" + key + "\" \"" + value + "\"\n";
    return text + std::string(brushes) + "}\n";
}

std::string entity_at(std::string_view class_name, const Whole& origin,
                      const std::vector<std::array<std::string, 2>>& pairs) {
    auto all = pairs;
    all.push_back(
        {"origin", std::to_string(origin[0]) + " " + std::to_string(origin[1]) + " " + std::to_string(origin[2])});
    return entity(class_name, all);
}

std::string level(std::string_view brushes, std::string_view entities) {
    return entity("worldspawn", {}, brushes) + std::string(entities);
}

std::string wad_bytes(const std::vector<std::string>& names) {
    std::string bytes = "WAD2", directory;
    put_u32(bytes, names.size());
    put_u32(bytes, 0);
    for (std::size_t i = 0; i < names.size(); ++i) {
        const std::string texture = miptex(names[i], static_cast<char>(i + 1));
        put_u32(directory, bytes.size());
        put_u32(directory, texture.size());
        put_u32(directory, texture.size());
        directory += std::string("D\0\0\0", 4);
        put_name(directory, names[i]);
        bytes += texture;
    }
    std::string place;
    put_u32(place, bytes.size());
    return bytes.replace(8, 4, place) + directory;
}

map::BspFile compile(std::string_view text, const map::CompileOptions& options) {
    const std::vector<map::Wad> wads{
        map::Wad(wad_bytes({"wall", "floor", "other", "*water", "*lava", "sky", "+0lamp", "+1lamp"}))};
    return map::compile_map(text, wads, options);
}

}  // namespace oblong::test
