#include "game/view/shown_view.h"

#include <algorithm>

#include "engine/level/trace.h"

namespace oblong {

namespace {

/// Of the isometric view: its width in units, and how far above the eye the level is cut off.
constexpr View kIsometricWidth = View::from_int(1024);
constexpr World kSectionAboveEye = World::from_int(40);

/// The distance of the surface in the middle of the picture, 16 to 4,096 units.
World distance_ahead(const Camera& camera, const Level& level) {
    constexpr World kNearest = World::from_int(16), kFarthest = World::from_int(4096);
    const Vec3<Unit> forward = view_basis(camera.yaw, camera.pitch, camera.roll).forward;
    const auto far_along = [&](World from, Unit component) {
        return saturating_convert<World>(convert<WorldWide>(from) + product<WorldWide>(kFarthest, component));
    };
    const Vec3<World> far{far_along(camera.eye.x, forward.x), far_along(camera.eye.y, forward.y),
                          far_along(camera.eye.z, forward.z)};
    const TraceResult hit = trace_hull(level, level.world(), Hull::Point, camera.eye, far);
    return std::clamp(product<World>(kFarthest, hit.fraction), kNearest, kFarthest);
}

ViewSpec isometric_view(const Camera& camera) {
    ViewSpec view = orthographic_view(camera.eye, axonometric_axes(Axonometry::Isometric), kIsometricWidth);
    cut_above(view, saturating_convert<World>(convert<WorldWide>(camera.eye.z) + convert<WorldWide>(kSectionAboveEye)));
    return view;
}

}  // namespace

std::optional<ViewSpec> other_view(bool is_isometric, std::int32_t zoom_degrees, const Camera& camera,
                                   const Level& level) {
    if (is_isometric) return isometric_view(camera);
    if (zoom_degrees == 0) return std::nullopt;
    const Degrees zoom = Degrees::from_int(zoom_degrees);
    ViewSpec view = first_person_view(dolly_zoomed(camera, distance_ahead(camera, level), zoom));
    if (zoom < camera.field_of_view) cut_front(view, camera.eye, World{});
    return view;
}

}  // namespace oblong
