#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "tests/support/bsp_writer.h"

/// MDL files as Quake's modelgen writes them, field by field.
namespace oblong::test {

using MdlFile = std::vector<std::uint8_t>;

struct MdlPlace {
    std::int32_t on_seam, s, t;
};
struct MdlTriangle {
    std::int32_t is_front, a, b, c;
};
struct MdlStep {
    std::uint8_t x, y, z;
};
/// With times, a group of that many frames.
struct MdlFrames {
    std::vector<std::vector<MdlStep>> frames;
    std::vector<float> times = {};
};
struct MdlSkins {
    std::vector<std::uint8_t> fills;  ///< the texel of all places of each skin
    std::vector<float> times = {};
};

struct MdlModel {
    std::vector<float> scale = {1, 1, 1}, origin = {0, 0, 0};
    std::int32_t skin_width = 8, skin_height = 4;
    std::vector<MdlSkins> skins;
    std::vector<MdlPlace> places;
    std::vector<MdlTriangle> triangles;
    std::vector<MdlFrames> frames;
};

inline void put_frame(MdlFile& file, const std::vector<MdlStep>& steps) {
    ByteWriter(file).number(8, 0).text("stand1").text(std::string(10, '\0'));
    for (const MdlStep& step : steps) file.insert(file.end(), {step.x, step.y, step.z, 0});
}

inline void put_skins(MdlFile& file, const MdlModel& model, const MdlSkins& skins) {
    ByteWriter(file).i32(skins.times.empty() ? 0 : 1);
    if (!skins.times.empty()) ByteWriter(file).i32(static_cast<std::int64_t>(skins.times.size()));
    for (const float time : skins.times) ByteWriter(file).f32(time);
    for (const std::uint8_t fill : skins.fills)
        file.insert(file.end(), static_cast<std::size_t>(model.skin_width * model.skin_height), fill);
}

inline void put_frames(MdlFile& file, const MdlFrames& frames) {
    ByteWriter(file).i32(frames.times.empty() ? 0 : 1);
    if (!frames.times.empty()) ByteWriter(file).i32(static_cast<std::int64_t>(frames.times.size())).number(8, 0);
    for (const float time : frames.times) ByteWriter(file).f32(time);
    for (const auto& steps : frames.frames) put_frame(file, steps);
}

/// Offsets of the header's counts.
inline constexpr std::size_t kMdlVersion = 4, kMdlScale = 8, kMdlOrigin = 20, kMdlSkins = 48, kMdlSkinWidth = 52,
                             kMdlSkinHeight = 56, kMdlVertices = 60, kMdlTriangles = 64, kMdlFrames = 68,
                             kMdlHeaderSize = 84;

inline MdlFile write_mdl(const MdlModel& model) {
    MdlFile file = {'I', 'D', 'P', 'O'};
    ByteWriter(file).i32(6);
    for (const float part : model.scale) ByteWriter(file).f32(part);
    for (const float part : model.origin) ByteWriter(file).f32(part);
    ByteWriter(file).number(16, 0).i32(std::ssize(model.skins)).i32(model.skin_width).i32(model.skin_height);
    ByteWriter(file).i32(std::ssize(model.places)).i32(std::ssize(model.triangles)).i32(std::ssize(model.frames));
    ByteWriter(file).number(12, 0);
    for (const MdlSkins& skins : model.skins) put_skins(file, model, skins);
    for (const MdlPlace& place : model.places)
        for (const std::int32_t part : {place.on_seam, place.s, place.t}) ByteWriter(file).i32(part);
    for (const MdlTriangle& triangle : model.triangles)
        for (const std::int32_t part : {triangle.is_front, triangle.a, triangle.b, triangle.c})
            ByteWriter(file).i32(part);
    for (const MdlFrames& frames : model.frames) put_frames(file, frames);
    return file;
}

/// A tetrahedron with its right angles at the origin, legs of 100 units; a frame alone, then a group of two frames, in
/// which it is half as large; a skin alone and a group of two. The last triangle is on the skin's back half.
inline MdlModel tetrahedron_model() {
    const std::vector<MdlStep> large = {{0, 0, 0}, {100, 0, 0}, {0, 100, 0}, {0, 0, 100}},
                               small = {{0, 0, 0}, {50, 0, 0}, {0, 50, 0}, {0, 0, 50}};
    MdlModel model;
    model.skins = {{{7}}, {{8, 9}, {0.5F, 0.75F}}};
    model.places = {{0, 0, 0}, {0x20, 2, 1}, {0, 3, 3}, {0, 1, 2}};
    model.triangles = {{1, 0, 1, 2}, {1, 0, 2, 3}, {1, 0, 3, 1}, {0, 1, 3, 2}};
    model.frames = {{{large}}, {{large, small}, {0.1F, 0.3F}}};
    return model;
}

}  // namespace oblong::test
