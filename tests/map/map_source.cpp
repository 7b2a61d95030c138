#include "tests/map/map_source.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <sstream>

#include "engine/level/bsp_read.h"
#include "tests/support/refusal.h"
#include "tests/support/script.h"
#include "tools/map/source/checks.h"

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

std::string miptex(const StripedTexture& texture) {
    std::string bytes, texels;
    put_name(bytes, texture.name);
    put_u32(bytes, texture.width);
    put_u32(bytes, texture.height);
    for (int mip = 0; mip < 4; ++mip) {
        const std::uint32_t width = texture.width >> mip, height = texture.height >> mip;
        put_u32(bytes, 40 + texels.size());
        for (std::uint32_t i = 0; i < width * height; ++i)
            texels += static_cast<char>(i % width * 8 / width % 2 == 0 ? texture.first : texture.second);
    }
    return bytes + texels;
}

Whole rounded(double x, double y, double z) {
    return {static_cast<int>(std::lround(x)), static_cast<int>(std::lround(y)), static_cast<int>(std::lround(z))};
}

double turn(int part, int of) {
    return 2 * std::numbers::pi * part / of;
}

std::string side_text(const std::array<Point, 3>& points, std::string_view tail) {
    std::string text;
    for (const Point& point : points) {
        char numbers[96];
        std::snprintf(numbers, sizeof numbers, "( %.6f %.6f %.6f ) ", point.x, point.y, point.z);
        text += numbers;
    }
    return text + std::string(tail) + "\n";
}

Point random_point(std::mt19937& random) {
    return {random_between(random, -1, 1), random_between(random, -1, 1), random_between(random, -1, 1)};
}

Point unit(const Point& vector) {
    return vector * (1 / length(vector));
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

std::string boxes(const std::string& corners) {
    std::string all;
    std::istringstream numbers(corners);
    for (Whole low, high; numbers >> low[0] >> low[1] >> low[2] >> high[0] >> high[1] >> high[2];)
        all += box(low, high);
    return all;
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
    for (int i = 0; i < side_count; ++i) sides.push_back({corner(i + 1, z), corner(i, z), corner(i, z + height)});
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

std::string entity(std::string_view class_name, const Keys& pairs, std::string_view brushes) {
    std::string text = "{\n\"classname\" \"" + std::string(class_name) + "\"\n";
    for (const auto& [key, value] : pairs) text += "\"" + key + "\" \"" + value + "\"\n";
    return text + std::string(brushes) + "}\n";
}

std::string entity_at(std::string_view class_name, const Whole& origin, const Keys& pairs) {
    auto all = pairs;
    all.push_back(
        {"origin", std::to_string(origin[0]) + " " + std::to_string(origin[1]) + " " + std::to_string(origin[2])});
    return entity(class_name, all);
}

std::string entities_of(const std::string& text) {
    std::string all, its_class;
    std::vector<int> numbers;
    Keys pairs;
    for (const std::string& word : words_of(replaced(replaced(text, "\n", " "), "'", "\"") + " +")) {
        const std::size_t equals = word.find('=');
        if (word == "+") {
            const auto corner = [&](std::size_t i) {
                return Whole{numbers.at(i), numbers.at(i + 1), numbers.at(i + 2)};
            };
            all += numbers.size() == 3 ? entity_at(its_class, corner(0), pairs)
                                       : entity(its_class, pairs, numbers.empty() ? "" : box(corner(0), corner(3)));
            numbers.clear(), pairs.clear(), its_class.clear();
        } else if (its_class.empty()) {
            its_class = word;
        } else if (equals == std::string::npos) {
            numbers.push_back(std::stoi(word));
        } else {
            pairs.push_back({word.substr(0, equals), word.substr(equals + 1)});
        }
    }
    return all;
}

std::string level(std::string_view brushes, std::string_view entities) {
    return entity("worldspawn", {}, brushes) + std::string(entities);
}

std::string wad_bytes(const std::vector<std::string>& names) {
    std::vector<StripedTexture> textures;
    for (const std::string& name : names) {
        const auto colour = static_cast<std::uint8_t>(textures.size() + 1);
        textures.push_back({name, colour, colour});
    }
    return wad_bytes(textures);
}

std::string wad_bytes(const std::vector<StripedTexture>& textures) {
    std::string bytes = "WAD2", directory;
    put_u32(bytes, textures.size());
    put_u32(bytes, 0);
    for (const StripedTexture& each : textures) {
        const std::string texture = miptex(each);
        put_u32(directory, bytes.size());
        put_u32(directory, texture.size());
        put_u32(directory, texture.size());
        directory += std::string("D\0\0\0", 4);
        put_name(directory, each.name);
        bytes += texture;
    }
    std::string place;
    put_u32(place, bytes.size());
    return bytes.replace(8, 4, place) + directory;
}

map::BspFile compile(std::string_view text, const map::CompileOptions& options) {
    return compile(map::parse_map(text), options);
}

map::BspFile compile(std::vector<map::MapEntity> entities, const map::CompileOptions& options) {
    const std::vector<map::Wad> wads{map::Wad(
        wad_bytes({"wall", "floor", "other", "*water", "*lava", "sky", "+0lamp", "+1lamp", "mirror", "{bars"}))};
    return map::compile_map(std::move(entities), wads, options);
}

Frame random_frame(std::mt19937& random) {
    const Point first = unit(random_point(random) + Point{0, 0, 2});
    const Point second = unit(cross(first, random_point(random) + Point{0, 2, 0}));
    return {first, second, cross(first, second)};
}

std::string TurnedBox::text(std::string_view tail) const {
    std::string sides;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const Point u = frame[(axis + 1) % 3] * 50, v = frame[(axis + 2) % 3] * 50;
        for (const double sign : {1.0, -1.0}) {
            const Point at = centre + frame[axis] * (sign * half[axis]);
            sides += sign > 0 ? side_text({at, at + v, at + u}, tail) : side_text({at, at + u, at + v}, tail);
        }
    }
    return "{\n" + sides + "}\n";
}

std::string turned_room(const TurnedBox& inside) {
    constexpr double kHalfWall = 8;
    std::string walls;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        for (const double sign : {1.0, -1.0}) {
            TurnedBox wall = inside;
            wall.centre = inside.centre + inside.frame[axis] * (sign * (inside.half[axis] + kHalfWall));
            wall.half[axis] = kHalfWall;
            for (std::size_t wider = 0; wider < axis; ++wider) wall.half[wider] += 2 * kHalfWall;
            walls += wall.text();
        }
    }
    return walls;
}

std::string replaced(std::string text, const std::string& part, const std::string& by) {
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + by.size()))
        text.replace(at, part.size(), by);
    return text;
}

std::string complaint_of(const std::string& source) {
    const std::string said = refusal([&] { compile(source, {}); });
    return said.empty() ? "none" : said;
}

void expect_complaint(const std::string& source, const std::string& part) {
    EXPECT_NE(complaint_of(source).find(part), std::string::npos) << complaint_of(source);
}

std::string bytes_of(const std::string& source) {
    return map::to_bytes(compile(source, {true}));
}

Level engine_level(const std::string& bytes) {
    return read_bsp({reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()});
}

Level engine_level(const map::BspFile& bsp) {
    return engine_level(map::to_bytes(bsp));
}

std::string plain_room() {
    return room({0, 0, 0}, {256, 256, 128});
}

std::string lights_of_plain_room() {
    return entity_at("info_player_start", {64, 64, 40}) + entity_at("light", {128, 128, 100});
}

std::vector<std::string> taken(map::Warnings& warnings) {
    std::vector<std::string> said;
    for (const map::Warning& warning : warnings.take())
        said.push_back("line " + std::to_string(warning.line) + ": " + warning.what);
    return said;
}

std::vector<std::string> said_of(const std::string& source) {
    map::Warnings warnings;
    compile(source, {.is_fast = true, .warnings = &warnings});
    return taken(warnings);
}

std::vector<std::string> said_of_source(const std::string& source) {
    map::Warnings warnings;
    map::find_warnings(map::parse_map(source), warnings);
    return taken(warnings);
}

}  // namespace oblong::test
