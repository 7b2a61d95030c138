#include "engine/programs/crosshair.h"

#include <cstdio>

#include "engine/draw/drawing.h"
#include "engine/io/doubles.h"
#include "engine/math/basis.h"

namespace oblong {

namespace {

std::string entity_text(const Level& level, ModelIndex model) {
    std::string text = "model " + std::to_string(model.number());
    const Entity* entity = entity_of(level, model);
    if (!entity) return text;
    text += " of " + entity->value("classname");
    const std::string name = entity->value("targetname");
    return name.empty() ? text : text + " \"" + name + "\"";
}

}  // namespace

std::optional<PickedFace> pick_ahead(const Level& level, std::span<const PlacedModel> models, const Camera& camera) {
    return pick_face(level, models, camera.eye, view_basis(camera.yaw, camera.pitch, camera.roll).forward);
}

std::string describe_picked(const Level& level, std::span<const PlacedModel> models,
                            const std::optional<PickedFace>& picked) {
    if (!picked) return "Nothing ahead";
    const Face& face = level.faces[picked->face];
    const LevelPlane& plane = level.planes[face.plane];
    const auto toward_front = [&face](Unit part) {
        const double value = number_of(part);
        return face.is_back && value != 0 ? -value : value;
    };
    char text[200];
    std::snprintf(text, sizeof text,
                  "%.16s, %.2f units ahead at %.1f %.1f %.1f\nface %d, plane %d (%.2f %.2f %.2f), %s",
                  level.texture_of(face).name.c_str(), number_of(picked->distance), number_of(picked->world_point.x),
                  number_of(picked->world_point.y), number_of(picked->world_point.z), picked->face.number(),
                  face.plane.number(), toward_front(plane.normal.x), toward_front(plane.normal.y),
                  toward_front(plane.normal.z), picked->model.is_none() ? "world" : "");
    if (picked->model.is_none()) return text;
    return text + entity_text(level, item(models, picked->model.number()).model);
}

void draw_crosshair(Framebuffer canvas, TextColours colours) {
    constexpr std::int32_t kFree_px = 2, kArm_px = 4;
    const std::int32_t x = canvas.width_px / 2, y = canvas.height_px / 2;
    for (const std::int32_t shadow : {1, 0}) {
        const std::uint8_t colour = shadow != 0 ? colours.dark : colours.bright;
        fill_area(canvas, {x - kFree_px - kArm_px + shadow, y + shadow, kArm_px, 1}, colour);
        fill_area(canvas, {x + kFree_px + 1 + shadow, y + shadow, kArm_px, 1}, colour);
        fill_area(canvas, {x + shadow, y - kFree_px - kArm_px + shadow, 1, kArm_px}, colour);
        fill_area(canvas, {x + shadow, y + kFree_px + 1 + shadow, 1, kArm_px}, colour);
    }
}

}  // namespace oblong
