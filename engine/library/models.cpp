#include <algorithm>

#include "engine/base/text.h"
#include "engine/io/files.h"
#include "engine/library/conversions.h"
#include "engine/models/obj.h"

namespace oblong {
namespace {

constexpr std::array<std::array<std::uint32_t, 3>, 1> kOneTriangle{{{0, 1, 2}}};
constexpr std::int32_t kMostScale_256 = 4096 * 256;

void check_scale(const std::string& name, std::int32_t scale_256) {
    if (scale_256 < 1 || scale_256 > kMostScale_256)
        throw FileError(name, "scale", std::to_string(scale_256) + " 256ths, expected 1 to 1048576");
}

Skin skin_of(const Picture& picture) {
    const std::vector<std::uint8_t>& pixels = checked(picture).pixels;
    const bool has_holes = std::find(pixels.begin(), pixels.end(), kTransparent) != pixels.end();
    return {"picture", picture.width_px, picture.height_px, pixels, has_holes};
}

ObjModel read_model(const File& file, const Palette& palette, std::int32_t scale_256, const ModelOptions& options) {
    check_scale(file.name, scale_256);
    return read_parsed(file, [&](std::span<const std::uint8_t> bytes) -> ObjModel {
        if (lower_case(file.name).ends_with(".mdl"))
            return {read_mdl(bytes, convert<World>(Fixed<std::int32_t, 8>::from_raw(scale_256))), {}};
        ObjOptions obj = scaled_256(scale_256);
        obj.is_z_up = options.is_z_up;
        obj.plain = skin_of(options.picture);
        return read_obj(bytes, file.name, palette, obj);
    });
}

// Adds a vertex of a triangle to all frames. Triangles do not share vertices, so that they are flat.
std::uint32_t add_corner(Mesh& mesh, const Corner& corner) {
    const auto within = [](std::int32_t units) {
        return World::from_int(std::clamp(units, 1 - kMeshLimit, kMeshLimit - 1));
    };
    for (MeshFrame& frame : mesh.frames)
        frame.vertices.push_back({{within(corner.x), within(corner.y), within(corner.z)}, {}});
    mesh.texels.push_back({Texel::from_int(corner.u), Texel::from_int(corner.v)});
    return static_cast<std::uint32_t>(mesh.texels.size() - 1);
}

}  // namespace

PlacedMesh placed_at(const Mesh& mesh, const Pose& pose, std::int32_t frame) {
    PlacedMesh placed;
    placed.mesh = &mesh;
    placed.frame = placed.next_frame = static_cast<std::uint32_t>(std::max(frame, 0));
    placed.position = place_of(pose);
    placed.yaw = angle_from_256(pose.yaw_256);
    placed.pitch = angle_from_256(pose.pitch_256);
    placed.roll = angle_from_256(pose.roll_256);
    return placed;
}

Model::Model() : state_(new State{std::make_shared<Mesh>(), {}, false}) {
    state_->mesh->frames.emplace_back();
}

Model::Model(const File& file, const Palette& palette, std::int32_t scale_256, const ModelOptions& options) {
    ObjModel read = read_model(file, palette, scale_256, options);
    state_.reset(new State{std::make_shared<Mesh>(std::move(read.mesh)), std::move(read.warnings), false});
}

// Two triangles that face ahead.
Model Model::sprite(const Picture& picture, std::int32_t scale_256) {
    check_scale("sprite", scale_256);
    Model model;
    const std::int32_t skin = model.add_picture(picture), right = picture.width_px, bottom = picture.height_px;
    if (std::int64_t{std::max(right, bottom)} * scale_256 / 256 >= kMeshLimit)
        throw argument_error("sprite", "too large, expected sides below " + std::to_string(kMeshLimit) + " units");
    const Corner left_up{0, 0, 1, 0, 0}, right_up{0, 1, 1, right, 0}, right_down{0, 1, 0, right, bottom},
        left_down{0, 0, 0, 0, bottom};
    model.add_triangle(left_up, right_up, right_down, skin);
    model.add_triangle(left_up, right_down, left_down, skin);
    const auto units = [&](std::int64_t px_2) {
        return World::from_raw(static_cast<std::int32_t>(px_2 * scale_256 * 8));
    };
    MeshFrame& frame = model.state_->mesh->frames.front();
    for (MeshVertex& corner : frame.vertices)
        corner.position = {{},
                           units(corner.position.y == World{} ? -right : right),
                           units(corner.position.z == World{} ? 0 : 2 * bottom)};
    set_boxes(frame);
    model.state_->turns_to_eye = true;
    return model;
}

Model::~Model() = default;
Model::Model(Model&& other) noexcept = default;
Model& Model::operator=(Model&& other) noexcept = default;

std::int32_t Model::add_picture(const Picture& picture) {
    std::vector<Skin>& skins = state_->mesh->skins;
    if (checked(picture).pixels.empty())
        throw argument_error("model", "a picture without pixels, expected one or more");
    skins.push_back(skin_of(picture));
    return static_cast<std::int32_t>(skins.size()) - 1;
}

void Model::add_triangle(const Corner& a, const Corner& b, const Corner& c, std::int32_t picture) {
    Mesh& mesh = *state_->mesh;
    if (picture < 0 || as_size(picture) >= mesh.skins.size())
        throw argument_error("model",
                             "picture " + std::to_string(picture) + ", expected a number that add_picture() returned");
    const std::uint32_t first = add_corner(mesh, a);
    add_corner(mesh, b);
    add_corner(mesh, c);
    mesh.triangles.push_back({{first, first + 1, first + 2}, static_cast<std::uint32_t>(picture)});
    for (MeshFrame& frame : mesh.frames) {
        std::vector<MeshVertex> corners(frame.vertices.begin() + first, frame.vertices.end());
        set_normals(corners, kOneTriangle);
        std::copy(corners.begin(), corners.end(), frame.vertices.begin() + first);
        // The box of these corners and the one before, whose place in the list does not matter.
        MeshFrame grown;
        grown.vertices = std::move(corners);
        if (first > 0) grown.vertices.insert(grown.vertices.end(), {{frame.mins, {}}, {frame.maxs, {}}});
        set_boxes(grown);
        frame.mins = grown.mins;
        frame.maxs = grown.maxs;
        frame.parts.clear();
    }
}

Bounds Model::bounds(std::int32_t frame) const {
    const PlacedMesh placed = placed_at(*state_->mesh, {}, frame);
    if (state_->mesh->frames.empty()) return {};
    return {pose_of(frame_of(placed).mins), pose_of(frame_of(placed).maxs)};
}

std::int32_t Model::frame_count() const {
    return static_cast<std::int32_t>(state_->mesh->frames.size());
}

const std::vector<std::string>& Model::warnings() const {
    return state_->warnings;
}

}  // namespace oblong
