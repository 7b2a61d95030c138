#include "tools/map/light/sources.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include "engine/base/input_error.h"
#include "engine/level/entity_classes.h"
#include "tools/map/source/entities.h"

namespace oblong::map {

namespace {

constexpr double kFadeUnit = 128;  // of the inverse falloffs
constexpr double kLeastSeen = 1;   // of 255, doubled
constexpr int kFirstSwitchableStyle = 32, kStyleCount = 64;

double radians(double degrees) {
    return degrees * std::numbers::pi / 180;
}

/// What a key of lights is where it is not given.
double usual(std::string_view key) {
    return std::stod(std::string(usual_text("light", key)));
}

double value_of(const MapEntity& entity, std::string_view key) {
    return number_of(entity, key, usual(key));
}

bool is_falloff(double delay) {
    const std::span<const KeyValue> values = find_entity_key(*find_entity_class("light"), "delay")->values;
    return std::any_of(values.begin(), values.end(),
                       [&](const KeyValue& each) { return std::stod(std::string(each.value)) == delay; });
}

bool is_light(const MapEntity& entity) {
    return role_of(entity) == ClassRole::Lamp;
}

// As in id's own compiler, any other thing with a key "light" shines, where that key is not its class's own.
bool shines(const MapEntity& entity) {
    if (!entity.has("light") || !entity.brushes.empty()) return false;
    const EntityClass* const its_class = find_entity_class(entity.value("classname"));
    return its_class == nullptr || find_entity_key(*its_class, "light") == find_entity_key({}, "light");
}

Point direction_of_angles(double yaw_degrees, double pitch_degrees) {
    const double yaw = radians(yaw_degrees), pitch = radians(pitch_degrees);
    return {std::cos(yaw) * std::cos(pitch), std::sin(yaw) * std::cos(pitch), std::sin(pitch)};
}

// "yaw pitch roll", pitch positive upward.
Point direction_of_mangle(const MapEntity& entity, std::string_view key) {
    const auto angles = numbers_of(entity, key, 2);
    return direction_of_angles(angles[0], angles[1]);
}

const MapEntity* find_target(const std::vector<MapEntity>& entities, const std::string& name) {
    const auto found = std::find_if(entities.begin(), entities.end(),
                                    [&](const MapEntity& entity) { return entity.value("targetname") == name; });
    return found == entities.end() ? nullptr : &*found;
}

std::optional<Point> spot_direction(const MapEntity& entity, const Point& origin,
                                    const std::vector<MapEntity>& entities) {
    if (entity.has("mangle")) return direction_of_mangle(entity, "mangle");
    if (!entity.has("target")) return std::nullopt;
    const MapEntity* target = find_target(entities, entity.value("target"));
    if (target == nullptr) return std::nullopt;
    const Point towards = origin_of(*target).value_or(origin) - origin;
    const double distance = length(towards);
    if (distance == 0) return std::nullopt;
    return towards * (1 / distance);
}

// "light" and "_light" may be a number, or a colour and perhaps a number: "red green blue brightness".
double brightness_of(const MapEntity& entity) {
    const std::string key = entity.has("light") ? "light" : "_light";
    if (!entity.has(key)) return usual("light");
    const std::size_t words = count_words(entity.value(key));
    if (words == 3) return usual("light");
    return words < 4 ? number_of(entity, key, 0) : numbers_of(entity, key, 4).back();
}

LightSource source_of(const MapEntity& entity, const Point& origin, const std::vector<MapEntity>& entities) {
    LightSource source;
    source.origin = origin;
    source.entity = &entity;
    double brightness = brightness_of(entity);
    if (brightness == 0 && is_light(entity)) brightness = usual("light");  // as in id's compiler and its successors
    source.brightness = std::abs(brightness);
    source.is_subtracted = brightness < 0;
    if (!is_light(entity)) return source;  // its other keys are not those of lights
    source.wait = value_of(entity, "wait");
    if (source.wait <= 0) source.wait = usual("wait");
    const double delay = value_of(entity, "delay");
    source.falloff = static_cast<Falloff>(static_cast<int>(is_falloff(delay) ? delay : usual("delay")));
    source.style = static_cast<int>(value_of(entity, "style"));
    if (source.style < 0 || source.style >= kStyleCount)
        throw InputError("line " + std::to_string(entity.line),
                         "\"style\" is " + std::to_string(source.style) + ", expected 0 to 63");
    source.direction = spot_direction(entity, origin, entities);
    source.radius = std::max(value_of(entity, "radius"), 0.0);
    const double cone = value_of(entity, "angle");
    if (source.direction) source.cone_cosine = std::cos(radians((cone > 0 ? cone : usual("angle")) / 2));
    return source;
}

// The switchable styles that no light has by its key: one with a "pattern" of its own, say.
std::vector<int> styles_left_free(const std::vector<MapEntity>& entities) {
    std::set<int> taken;
    for (const MapEntity& entity : entities) {
        if (is_light(entity) && entity.has("style")) taken.insert(static_cast<int>(number_of(entity, "style", 0)));
    }
    std::vector<int> free;
    for (int style = kFirstSwitchableStyle; style < kStyleCount; ++style) {
        if (!taken.contains(style)) free.push_back(style);
    }
    return free;
}

// Kept in a float, as engines keep it.
float texel_at(const FileTexAxis& axis, const Floats& point) {
    return static_cast<float>(dot(to_point(axis.direction), to_point(point)) + static_cast<double>(axis.offset));
}

Point nearest_on_segment(const Point& point, const Point& from, const Point& to) {
    const Point along = to - from;
    const double t = std::clamp(dot(point - from, along) / dot(along, along), 0.0, 1.0);
    return from + along * t;
}

// In order.
std::vector<Floats> face_corners(const BspFile& bsp, const FileFace& face) {
    std::vector<Floats> corners;
    for (int i = 0; i < face.edge_count; ++i) {
        const int edge = item(bsp.surf_edges, face.first_surf_edge + i);
        const auto& ends = item(bsp.edges, std::abs(edge));
        corners.push_back(item(bsp.vertices, ends[edge < 0 ? 1 : 0]));
    }
    return corners;
}

// Worked out from the numbers in the file, as a reader does.
LightGrid light_grid(const BspFile& bsp, const FileFace& face) {
    const auto corners = face_corners(bsp, face);
    const FileTexInfo& texinfo = item(bsp.texinfos, face.texinfo);
    LightGrid grid;
    for (std::size_t axis = 0; axis < 2; ++axis) {
        float low = texel_at(texinfo.axes[axis], corners[0]), high = low;
        for (const auto& corner : corners) {
            low = std::min(low, texel_at(texinfo.axes[axis], corner));
            high = std::max(high, texel_at(texinfo.axes[axis], corner));
        }
        grid.first[axis] = static_cast<int>(std::floor(low / LightGrid::kStep));
        grid.count[axis] = static_cast<int>(std::ceil(high / LightGrid::kStep)) - grid.first[axis] + 1;
    }
    return grid;
}

}  // namespace

double LightSource::at_distance(double distance) const {
    const double faded = std::max(distance * wait, 1.0);
    switch (falloff) {
        case Falloff::kLinear:
            return std::max(brightness - faded, 0.0);
        case Falloff::kInverse:
            return brightness * kFadeUnit / faded;
        case Falloff::kInverseSquare:
            return brightness * (kFadeUnit / faded) * (kFadeUnit / faded);
        case Falloff::kFarther:
            return brightness * (kFadeUnit / (faded + kFadeUnit)) * (kFadeUnit / (faded + kFadeUnit));
        default:
            return brightness;
    }
}

double LightSource::range() const {
    switch (falloff) {
        case Falloff::kLinear:
            return brightness / wait;
        case Falloff::kInverse:
            return brightness * kFadeUnit / kLeastSeen / wait;
        case Falloff::kInverseSquare:
        case Falloff::kFarther:
            return kFadeUnit * std::sqrt(brightness / kLeastSeen) / wait;
        default:
            return 1e9;
    }
}

bool LightSource::shines_on(const Point& towards) const {
    return !direction || dot(*direction, towards) >= cone_cosine;
}

Lights lights_of(const std::vector<MapEntity>& entities) {
    Lights lights;
    for (const MapEntity& entity : entities) {
        const auto origin = origin_of(entity);
        if ((!is_light(entity) && !shines(entity)) || !origin) continue;
        LightSource source = source_of(entity, *origin, entities);
        if (source.brightness > 0) lights.sources.push_back(source);
    }
    const MapEntity& world = entities.front();
    lights.least = {number_of(world, "_minlight", number_of(world, "light", 0))};
    for (const MapEntity& entity : entities) {
        if (!entity.brushes.empty() && !belongs_to_world(entity))
            lights.least.push_back(std::max(lights.least.front(), number_of(entity, "_minlight", 0)));
    }
    lights.sun.brightness = number_of(world, "_sunlight", 0);
    if (world.has("_sun_mangle")) lights.sun.direction = direction_of_mangle(world, "_sun_mangle");
    return lights;
}

void assign_switchable_styles(std::vector<MapEntity>& entities) {
    const std::vector<int> free = styles_left_free(entities);
    std::vector<std::string> names;
    for (MapEntity& entity : entities) {
        const std::string name = entity.value("targetname");
        if (!is_light(entity) || name.empty() || entity.has("style")) continue;
        const auto found = std::find(names.begin(), names.end(), name);
        const auto index = static_cast<std::size_t>(found - names.begin());
        if (found == names.end()) names.push_back(name);
        if (index >= free.size())
            throw InputError("line " + std::to_string(entity.line),
                             "more than " + std::to_string(free.size()) +
                                 " names of switchable lights, expected at most " + std::to_string(free.size()));
        entity.pairs.push_back({"style", std::to_string(free[index]), entity.line});
    }
}

FaceSampler::FaceSampler(const BspFile& bsp, const FileFace& face, const Tracer& tracer)
    : tracer_(tracer), grid_(light_grid(bsp, face)) {
    const FilePlane& plane = item(bsp.planes, face.plane);
    const Point plane_normal = to_point(plane.normal);
    normal_ = face.is_back != 0 ? -plane_normal : plane_normal;
    for (const auto& corner : face_corners(bsp, face)) {
        corners_.push_back(to_point(corner) + normal_ * kLift);
        centre_ = centre_ + corners_.back();
    }
    centre_ = centre_ * (1.0 / static_cast<double>(corners_.size()));
    for (const Point& corner : corners_) radius_ = std::max(radius_, length(corner - centre_));

    // u = s . p + s0, v = t . p + t0, distance = n . p, solved for p by Cramer's rule.
    const FileTexInfo& texinfo = item(bsp.texinfos, face.texinfo);
    const Point s = to_point(texinfo.axes[0].direction), t = to_point(texinfo.axes[1].direction);
    const double determinant = dot(s, cross(t, plane_normal));
    const Point per_u = cross(t, plane_normal) * (1 / determinant);
    const Point per_v = cross(plane_normal, s) * (1 / determinant);
    const Point per_distance = cross(s, t) * (1 / determinant);
    const double first_u = LightGrid::kStep * grid_.first[0] - static_cast<double>(texinfo.axes[0].offset);
    const double first_v = LightGrid::kStep * grid_.first[1] - static_cast<double>(texinfo.axes[1].offset);
    step_u_ = per_u * LightGrid::kStep;
    step_v_ = per_v * LightGrid::kStep;
    base_ = per_u * first_u + per_v * first_v + per_distance * static_cast<double>(plane.distance) + normal_ * kLift;
}

Point FaceSampler::point_at(double u, double v) const {
    const Point point = base_ + step_u_ * u + step_v_ * v;
    const Point over_face = nearest_over_face(point);
    return tracer_.is_clear(over_face, point) ? point : over_face;
}

// Within the polygon the point itself; else on its nearest edge, and a little inward.
Point FaceSampler::nearest_over_face(const Point& point) const {
    Point nearest = point;
    double nearest_distance = -1;
    bool is_inside = true;
    for (std::size_t i = 0; i < corners_.size(); ++i) {
        const Point& from = corners_[i];
        const Point& to = corners_[(i + 1) % corners_.size()];
        if (dot(normal_, cross(to - from, point - from)) > 0) is_inside = false;
        const Point candidate = nearest_on_segment(point, from, to);
        const double distance = length(candidate - point);
        if (nearest_distance >= 0 && distance >= nearest_distance) continue;
        nearest = candidate;
        nearest_distance = distance;
    }
    if (is_inside && nearest_distance >= kInset) return point;
    const Point inward = centre_ - nearest;
    const double size = length(inward);
    return size <= kInset ? centre_ : nearest + inward * (kInset / size);
}

}  // namespace oblong::map
