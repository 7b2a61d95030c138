#include <algorithm>

#include "engine/io/files.h"
#include "engine/library/conversions.h"
#include "engine/mesh/draw_mesh.h"
#include "engine/models/obj.h"
#include "engine/view/views.h"

namespace oblong {
namespace {

constexpr std::array<std::array<std::uint32_t, 3>, 1> kOneTriangle{{{0, 1, 2}}};
constexpr std::int32_t kMostScale_256 = 4096 * 256;

ObjModel read_model(const std::string& file, const Palette& palette, std::int32_t scale_256) {
    if (scale_256 < 1 || scale_256 > kMostScale_256)
        throw FileError(file, "scale", std::to_string(scale_256) + " 256ths, expected 1 to 1048576");
    if (!file.ends_with(".mdl") && !file.ends_with(".MDL")) return read_obj(file, palette, scaled_256(scale_256));
    return {read_parsed(file,
                        [&](std::span<const std::uint8_t> bytes) {
                            return read_mdl(bytes, convert<World>(Fixed<std::int32_t, 8>::from_raw(scale_256)));
                        }),
            {}};
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

Model::Model() : state_(new State{std::make_shared<Mesh>(), {}}) {
    state_->mesh->frames.emplace_back();
}

Model::Model(const std::string& file, const Palette& palette, std::int32_t scale_256) {
    ObjModel read = read_model(file, palette, scale_256);
    state_ = new State{std::make_shared<Mesh>(std::move(read.mesh)), std::move(read.warnings)};
}

Model::~Model() {
    delete state_;
}

std::int32_t Model::add_picture(const Picture& picture) {
    std::vector<Skin>& skins = state_->mesh->skins;
    const std::vector<std::uint8_t>& pixels = checked(picture).pixels;
    if (pixels.empty()) throw argument_error("model", "a picture without pixels, expected one or more");
    const bool has_holes = std::find(pixels.begin(), pixels.end(), kTransparent) != pixels.end();
    skins.push_back({"picture", picture.width_px, picture.height_px, pixels, has_holes});
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

std::int32_t Model::frame_count() const {
    return static_cast<std::int32_t>(state_->mesh->frames.size());
}

const std::vector<std::string>& Model::warnings() const {
    return state_->warnings;
}

struct Stage::State {
    State(const Palette& palette, const ScreenMode& its_mode)
        : mode(checked(its_mode)),
          colormap(make_colormap(palette, palette.colours.size())),
          depth(mode.width_px, mode.height_px),
          scratch(mode.height_px) {}

    ScreenMode mode;
    Colormap colormap;
    ViewContext view;
    MeshLight light;
    DepthBuffer depth;
    MeshScratch scratch;
};

Stage::Stage(const Palette& palette, ScreenMode mode) : state_(new State(palette, mode)) {
    look({});
}

Stage::~Stage() {
    delete state_;
}

void Stage::look(const Pose& eye, std::int32_t field_of_view) {
    State& state = *state_;
    state.view = make_view_context(first_person_view(camera_of(eye, field_of_view)), state.mode);
    state.depth.start_frame();
    state.depth.want({0, state.mode.width_px, 0, state.mode.height_px});
    state.depth.clear();
}

void Stage::set_light(std::int32_t ambient_256, std::int32_t from_side_256, std::int32_t x, std::int32_t y,
                      std::int32_t z) {
    const auto strength = [](std::int32_t light_256) {
        return static_cast<std::int32_t>(
            std::clamp<std::int64_t>(std::int64_t{light_256} * kFullLight / 256, 0, MeshLight::kMostLight));
    };
    const auto along = [](std::int32_t units) { return World::from_int(std::clamp(units, -100'000, 100'000)); };
    state_->light.ambient = strength(ambient_256);
    state_->light.directional = {normalised(Vec3<World>{along(x), along(y), along(z)}), strength(from_side_256)};
}

void Stage::draw(const Model& model, const Pose& pose, Framebuffer canvas, std::int32_t frame) {
    State& state = *state_;
    check_size(canvas, state.mode);
    const MeshDrawing drawing{state.view, state.colormap, state.light, nullptr, false};
    draw_mesh(placed_at(*model.state_->mesh, pose, frame), drawing,
              {state.depth, canvas, {0, canvas.width_px, 0, canvas.height_px}}, state.scratch);
}

}  // namespace oblong
