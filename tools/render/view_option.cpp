#include <algorithm>
#include <array>
#include <map>
#include <vector>

#include "engine/base/input_error.h"
#include "engine/base/text.h"
#include "engine/fixed/trig.h"
#include "engine/programs/arguments.h"
#include "tools/render/camera_list.h"

namespace oblong {

const char* const kViewSyntax =
    "NAME[:KEY=VALUE,...]: first-person; look-at (distance, yaw, pitch); front, top, side (width, front, back, cut); "
    "isometric, dimetric, trimetric (the same, turn); cavalier, cabinet (the same, angle, base=front|top|side); "
    "vrp (vpn, vup, cop: X/Y/Z, window=UMIN/UMAX/VMIN/VMAX, front, back, parallel=0|1)";

namespace {

/// The keys and values after a view's name. A key that is never taken is reported as unknown.
class ViewKeys {
  public:
    explicit ViewKeys(const std::string& text) {
        const std::size_t colon = text.find(':');
        name = text.substr(0, colon);
        if (colon == std::string::npos) return;
        for (const std::string& pair : split(text.substr(colon + 1), ",")) {
            const std::size_t equals = pair.find('=');
            if (equals == std::string::npos || !values_.emplace(pair.substr(0, equals), pair.substr(equals + 1)).second)
                throw UsageError("--view: '" + pair + "', expected KEY=VALUE, each key once");
        }
    }

    std::optional<std::string> take(const std::string& key) {
        const auto found = values_.extract(key);
        return found ? std::optional(found.mapped()) : std::nullopt;
    }
    std::string take(const std::string& key, const std::string& otherwise) { return take(key).value_or(otherwise); }

    std::optional<World> take_units(const std::string& key) {
        const std::optional<std::string> text = take(key);
        return text ? std::optional(units_of(key, *text)) : std::nullopt;
    }
    /// The planes that cut a view, `back` beyond `front`.
    void take_planes(std::optional<World>& front, std::optional<World>& back) {
        front = take_units("front");
        back = take_units("back");
        if (front && back && *back <= *front)
            throw UsageError("--view: nothing lies between front and back, expected a larger back");
    }
    /// Numbers separated by slashes.
    template <std::size_t Count>
    std::array<World, Count> take_list(const std::string& key, const std::string& otherwise) {
        const std::string text = take(key, otherwise);
        const std::vector<std::string> parts = split(text, "/");
        if (parts.size() != Count)
            throw UsageError("--view: " + key + "='" + text + "', expected " + std::to_string(Count) +
                             " numbers with / between");
        std::array<World, Count> list;
        std::transform(parts.begin(), parts.end(), list.begin(),
                       [&](const std::string& part) { return units_of(key, part); });
        return list;
    }
    Angle take_angle(const std::string& key, const std::string& otherwise) {
        const std::int64_t raw_32 = parse_number("--view: " + key, take(key, otherwise), 32);
        return degrees_to_angle(Degrees::from_raw(raw_32 % (std::int64_t{360} << 32) * 65536));
    }
    void expect_none_left() const {
        if (!values_.empty())
            throw UsageError("--view: '" + name + "' has no key '" + values_.begin()->first + "', expected " +
                             kViewSyntax);
    }

    std::string name;

  private:
    static World units_of(const std::string& key, const std::string& text) {
        const std::int64_t raw = parse_number("--view: " + key, text, World::kFractionBits);
        if (std::abs(raw) > std::int64_t{65536} << World::kFractionBits)
            throw UsageError("--view: " + key + "='" + text + "', expected up to 65,536 units");
        return World::from_raw(static_cast<std::int32_t>(raw));
    }

    std::map<std::string, std::string> values_;
};

/// The planes that may cut a parallel view.
struct Cuts {
    std::optional<World> front, back, above;

    explicit Cuts(ViewKeys& keys) : above(keys.take_units("cut")) { keys.take_planes(front, back); }

    ViewSpec applied_to(ViewSpec view) const {
        const Vec3<World> centre = view.eye;
        if (front) cut_front(view, centre, *front);
        if (back) cut_back(view, centre, *back);
        if (above)
            cut_above(view, saturating_convert<World>(convert<WorldWide>(centre.z) + convert<WorldWide>(*above)));
        return view;
    }
};

View width_of(ViewKeys& keys) {
    return convert<View>(keys.take_units("width").value_or(World::from_int(1024)));
}

ViewSide side_of(const std::string& name) {
    if (name == "front") return ViewSide::Front;
    if (name == "top") return ViewSide::Top;
    if (name == "side") return ViewSide::Side;
    throw UsageError("--view: base='" + name + "', expected front, top or side");
}

ViewOfCamera orthographic(ViewKeys& keys, const Basis& axes) {
    return [width = width_of(keys), cuts = Cuts(keys), axes](const Camera& camera) {
        return cuts.applied_to(orthographic_view(camera.eye, axes, width));
    };
}

ViewOfCamera axonometric(ViewKeys& keys, Axonometry kind) {
    return orthographic(keys, axonometric_axes(kind, keys.take_angle("turn", "0")));
}

ViewOfCamera oblique(ViewKeys& keys, Unit length) {
    const Basis axes = side_axes(side_of(keys.take("base", "front")));
    return [width = width_of(keys), cuts = Cuts(keys), angle = keys.take_angle("angle", "45"), axes, length](
               const Camera& camera) { return cuts.applied_to(oblique_view(camera.eye, axes, width, length, angle)); };
}

/// From a distance, toward the camera's position.
ViewOfCamera look_at_position(ViewKeys& keys) {
    const World distance = keys.take_units("distance").value_or(World::from_int(256));
    const Basis axes = view_basis(keys.take_angle("yaw", "45"), keys.take_angle("pitch", "30"), {});
    return [distance, axes](const Camera& camera) {
        const auto back = [&](World from, Unit component) {
            return saturating_convert<World>(convert<WorldWide>(from) - product<WorldWide>(distance, component));
        };
        const Vec3<World> eye{back(camera.eye.x, axes.forward.x), back(camera.eye.y, axes.forward.y),
                              back(camera.eye.z, axes.forward.z)};
        return look_at_view(eye, camera.eye, camera.field_of_view);
    };
}

/// Through a window in a plane through the camera's position.
ViewOfCamera through_window(ViewKeys& keys) {
    const auto vector = [&](const char* key, const char* otherwise) {
        const auto [x, y, z] = keys.take_list<3>(key, otherwise);
        return Vec3<World>{x, y, z};
    };
    WindowView window;
    window.normal = vector("vpn", "0/1/0");
    window.up = vector("vup", "0/0/1");
    const Vec3<World> cop = vector("cop", "0/-256/0");
    const auto [u_min, u_max, v_min, v_max] = keys.take_list<4>("window", "-256/256/-192/192");
    window.u_min = u_min;
    window.u_max = u_max;
    window.v_min = v_min;
    window.v_max = v_max;
    keys.take_planes(window.front, window.back);
    const std::string parallel = keys.take("parallel", "0");
    if (parallel != "0" && parallel != "1") throw UsageError("--view: parallel='" + parallel + "', expected 0 or 1");
    window.is_parallel = parallel == "1";
    return [window, cop](const Camera& camera) {
        WindowView placed = window;
        placed.reference_point = camera.eye;
        placed.centre_of_projection =
            saturating_convert<World>(convert<WorldWide>(camera.eye) + convert<WorldWide>(cop));
        return window_view(placed);
    };
}

ViewOfCamera view_named(ViewKeys& keys) {
    const std::string& name = keys.name;
    if (name == "first-person") return [](const Camera& camera) { return first_person_view(camera); };
    if (name == "look-at") return look_at_position(keys);
    if (name == "front" || name == "top" || name == "side") return orthographic(keys, side_axes(side_of(name)));
    if (name == "isometric") return axonometric(keys, Axonometry::Isometric);
    if (name == "dimetric") return axonometric(keys, Axonometry::Dimetric);
    if (name == "trimetric") return axonometric(keys, Axonometry::Trimetric);
    if (name == "cavalier") return oblique(keys, Unit::from_int(1));
    if (name == "cabinet") return oblique(keys, Unit::from_raw(1 << 29));
    if (name == "vrp") return through_window(keys);
    throw UsageError("--view: '" + name + "', expected " + kViewSyntax);
}

}  // namespace

ViewOfCamera parse_view(const std::string& text) {
    ViewKeys keys(text);
    ViewOfCamera view = view_named(keys);
    keys.expect_none_left();
    return view;
}

ViewSpec checked_view(const ViewOfCamera& view, const Camera& camera, const ScreenMode& mode,
                      const std::string& where) {
    ViewSpec spec;
    try {
        spec = view(camera);
    } catch (const InputError& error) {
        throw UsageError(where + ": " + error.where + ": " + error.what());
    }
    if (const std::optional<std::string> problem = problem_of(spec, mode)) throw UsageError(where + ": " + *problem);
    return spec;
}

}  // namespace oblong
