#pragma once

#include <array>
#include <cstdint>
#include <random>
#include <string>
#include <string_view>
#include <vector>

#include "engine/level/level.h"
#include "tests/support/random.h"
#include "tools/map/compile.h"

/// Writes small map sources, and compiles them with textures made up on the spot.
namespace oblong::test {

using map::Point;
using Whole = std::array<int, 3>;
using Keys = std::vector<std::array<std::string, 2>>;

/// A brush of planes, each through three points that run clockwise seen from outside, with one texture.
std::string brush(const std::vector<std::array<Whole, 3>>& sides, std::string_view texture = "wall");

/// The box between two corners.
std::string box(const Whole& mins, const Whole& maxs, std::string_view texture = "wall");

/// Boxes of "wall", six numbers each.
std::string boxes(const std::string& corners);

/// Six walls, `thick` units, around the space between two corners.
std::string room(const Whole& mins, const Whole& maxs, int thick = 16, std::string_view texture = "wall");

/// An upright prism on a regular polygon with corners rounded to whole units.
std::string prism(const Whole& centre, int radius, int height, int side_count, std::string_view texture = "wall");

/// A convex ball of one brush: `rings` times `sectors` planes, three points of each rounded to whole units.
std::string ball(const Whole& centre, int radius, int rings, int sectors, std::string_view texture = "wall");

/// An entity with pairs "key" "value", and perhaps brushes.
std::string entity(std::string_view class_name, const Keys& pairs, std::string_view brushes = "");
std::string entity_at(std::string_view class_name, const Whole& origin, const Keys& pairs = {});

/// Entities in one line: "light 1 2 3 style=4 + func_door 0 0 0 8 8 8 message=\"Not yet\"": three numbers are an
/// origin, six the corners of a brush.
std::string entities_of(const std::string& text);

/// The worldspawn of these brushes, and then entities.
std::string level(std::string_view brushes, std::string_view entities = "");

/// A WAD2 of 16 x 16 textures of one colour.
std::string wad_bytes(const std::vector<std::string>& names);

/// A texture of upright stripes, an eighth of its width each: `first`, `second`, `first` ...
struct StripedTexture {
    std::string name;
    std::uint8_t first = 0, second = 0;
    std::uint32_t width = 16, height = 16;
};
/// A WAD2 of these.
std::string wad_bytes(const std::vector<StripedTexture>& textures);

/// Compiles with a WAD that has wall, floor, other, *water, *lava, sky, mirror, {bars and an animated +0lamp, +1lamp.
map::BspFile compile(std::string_view text, const map::CompileOptions& options = {});
map::BspFile compile(std::vector<map::MapEntity> entities, const map::CompileOptions& options);

/// What follows a side's points.
inline constexpr std::string_view kStandardTail = "wall 0 0 0 1 1", kValveTail = "wall [ 1 0 0 0 ] [ 0 -1 0 0 ] 0 1 1";

/// Three directions at right angles, of length 1.
using Frame = std::array<Point, 3>;
Frame random_frame(std::mt19937& random);

/// A box around `centre`, `half` of its extents along the frame's directions, with points of six decimals.
struct TurnedBox {
    Point centre;
    std::array<double, 3> half;
    Frame frame;

    double volume() const { return 8 * half[0] * half[1] * half[2]; }
    std::string text(std::string_view tail = kStandardTail) const;
};

/// A room of six such boxes around the inside of `inside`: walls of 16 units that overlap nowhere.
std::string turned_room(const TurnedBox& inside);

/// `text` with every `part` replaced.
std::string replaced(std::string text, const std::string& part, const std::string& by);

/// What the compiler says of a source that it refuses, "WHERE: WHAT", or "none"; and that it says `part`.
std::string complaint_of(const std::string& source);
void expect_complaint(const std::string& source, const std::string& part);

/// The bytes of the level.
std::string bytes_of(const std::string& source);
/// As the engine reads them.
Level engine_level(const std::string& bytes);
Level engine_level(const map::BspFile& bsp);

/// A room without anything in it, and a start and a light in it.
std::string plain_room();
std::string lights_of_plain_room();

/// "line N: WHAT" each.
std::vector<std::string> taken(map::Warnings& warnings);
/// What is said while a source is compiled fast, and what of it is said of the source alone.
std::vector<std::string> said_of(const std::string& source);
std::vector<std::string> said_of_source(const std::string& source);

}  // namespace oblong::test
