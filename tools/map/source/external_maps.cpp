#include "tools/map/source/external_maps.h"

#include <algorithm>
#include <cmath>

#include "engine/base/input_error.h"
#include "engine/io/files.h"
#include "engine/level/entity_classes.h"
#include "tools/map/source/brush.h"
#include "tools/map/source/checks.h"
#include "tools/map/source/entities.h"

namespace oblong::map {
namespace {

constexpr double kFarthestOrigin = 65536, kMostScale = 1024;
constexpr std::size_t kMostBrushes = 65536;

[[noreturn]] void refuse(const MapEntity& entity, const std::string& what) {
    throw InputError(at_line(entity.line), what);
}

// The columns of a rotation: the rotated axes.
struct Rotation {
    std::array<Point, 3> axes{axis_vector(0), axis_vector(1), axis_vector(2)};

    Point operator()(const Point& point) const { return axes[0] * point.x + axes[1] * point.y + axes[2] * point.z; }
};

// About x (roll), then y (pitch, positive down), then z (yaw).
Rotation rotation_of(const std::vector<double>& pitch_yaw_roll) {
    const Turn pitch = turn_of(std::fmod(pitch_yaw_roll[0], 360)), yaw = turn_of(std::fmod(pitch_yaw_roll[1], 360)),
               roll = turn_of(std::fmod(pitch_yaw_roll[2], 360));
    Rotation rotation;
    for (Point& axis : rotation.axes) {
        axis = {axis.x, axis.y * roll.cosine - axis.z * roll.sine, axis.y * roll.sine + axis.z * roll.cosine};
        axis = {axis.x * pitch.cosine + axis.z * pitch.sine, axis.y, axis.z * pitch.cosine - axis.x * pitch.sine};
        axis = {axis.x * yaw.cosine - axis.y * yaw.sine, axis.x * yaw.sine + axis.y * yaw.cosine, axis.z};
    }
    return rotation;
}

// The placement of an external map.
struct Placement {
    explicit Placement(const MapEntity& entity) : origin(origin_of(entity).value_or(Point{})) {
        if (largest_component(origin) > kFarthestOrigin)
            refuse(entity, "\"origin\" is too far away, expected at most 65536 on each axis");
        const auto angles = numbers_of(entity, "_external_map_angles", 3);
        rotation = rotation_of(angles.empty() ? std::vector<double>{0, number_of(entity, "_external_map_angle", 0), 0}
                                              : angles);
        auto scales = numbers_of(entity, "_external_map_scale", 3);
        if (scales.empty()) scales.assign(3, number_of(entity, "_external_map_scale", 1));
        scale = {scales[0], scales[1], scales[2]};
        for (const double each : scales)
            if (!(each >= 1 / kMostScale && each <= kMostScale))
                refuse(entity, "\"_external_map_scale\" is '" + entity.value("_external_map_scale") +
                                   "', expected 1/1024 to 1024");
    }

    Point point(const Point& p) const { return rotation({p.x * scale.x, p.y * scale.y, p.z * scale.z}) + origin; }

    // u' . point(p) + offset' = u . p + offset, for texture axes u.
    Point axis(const Point& u) const { return rotation({u.x / scale.x, u.y / scale.y, u.z / scale.z}); }

    Point origin, scale{1, 1, 1};
    Rotation rotation;
};

MapSide placed(MapSide side, const Placement& place) {
    TextureFields& texture = side.texture;
    texture.axes = texture_axes(texture, plane_of(side).normal);
    texture.has_axes = true;
    for (Point& point : side.points) point = place.point(point);
    for (std::size_t i = 0; i < 2; ++i) {
        texture.axes[i] = place.axis(texture.axes[i]);
        texture.offset[i] -= dot(texture.axes[i], place.origin) / texture.scale[i];
    }
    return side;
}

void check_brush(const MapBrush& brush) {
    for (const MapSide& side : brush.sides) {
        const auto& [a, b, c] = side.points;
        if (length(cross(a - b, c - b)) < 1e-6)
            throw InputError(
                at_line(side.line),
                "the three points of a plane coincide after scaling, expected a larger \"_external_map_scale\"");
    }
    PlaneList planes;
    TextureList textures;
    make_brush(brush, planes, textures);
}

// Reads sources within sources.
class Includer {
  public:
    Includer(const ReadExternalSource& read, Warnings& warnings) : read_(read), warnings_(warnings) {}

    void include(std::vector<MapEntity>& entities, const std::string& path) {
        paths_.push_back(path);
        for (MapEntity& entity : entities)
            if (role_of(entity) == ClassRole::ExternalMap) fill(entity, path);
        paths_.pop_back();
    }

  private:
    void fill(MapEntity& entity, const std::string& path) {
        const std::string name = entity.value("_external_map");
        if (name.empty())
            refuse(entity, "a misc_external_map without '_external_map', expected the file name of a map source");
        if (!entity.brushes.empty()) refuse(entity, "a misc_external_map with brushes, expected none, only an origin");
        const ExternalSource source = read_(name, path, entity.line);
        Warnings own;
        if (std::find(paths_.begin(), paths_.end(), source.path) != paths_.end())
            refuse(entity, "'" + name + "' includes itself, expected another map source");
        if (++count_ > kMostExternal)
            refuse(entity, "more than " + std::to_string(kMostExternal) + " map sources are included, expected fewer");
        warn_of_values(entity);
        const Placement place(entity);
        for (MapBrush& brush : naming_file(source.path, [&] { return brushes_of(source, place, own); })) {
            brush.line = entity.line;
            for (MapSide& side : brush.sides) side.line = entity.line;
            entity.brushes.push_back(std::move(brush));
        }
        for (const Warning& warning : own.take())
            warnings_.add(entity.line, "'" + name + "', line " + std::to_string(warning.line) + ": " + warning.what);
        become_its_class(entity);
    }

    std::vector<MapBrush> brushes_of(const ExternalSource& source, const Placement& place, Warnings& warnings) {
        std::vector<MapEntity> entities = parse_map(source.text, &warnings);
        include(entities, source.path);
        std::vector<MapBrush> brushes;
        for (MapEntity& entity : entities)
            for (MapBrush& brush : entity.brushes) {
                for (MapSide& side : brush.sides) side = placed(std::move(side), place);
                check_brush(brush);
                if (++brush_count_ > kMostBrushes)
                    throw InputError(at_line(brush.line), "more than " + std::to_string(kMostBrushes) +
                                                              " brushes are included, expected fewer");
                brushes.push_back(std::move(brush));
            }
        if (brushes.empty()) throw InputError("line 1", "no brushes, expected some to include");
        return brushes;
    }

    // These keys are gone when the others are checked.
    void warn_of_values(const MapEntity& entity) {
        const EntityClass* const its_class = find_entity_class(entity.value("classname"));
        for (const MapPair& pair : entity.pairs) {
            if (pair.key != "origin" && !pair.key.starts_with("_external_map")) continue;
            const EntityKey* const row = find_entity_key(*its_class, pair.key);
            const std::string expected = row == nullptr ? "" : expected_instead_of(pair.value, *row);
            if (!expected.empty())
                warnings_.add(pair.line, "'" + pair.key + "' is '" + pair.value + "', expected " + expected);
        }
    }

    static void become_its_class(MapEntity& entity) {
        const std::string its_class =
            entity.value("_external_map_classname", usual_text(entity.value("classname"), "_external_map_classname"));
        std::erase_if(entity.pairs, [](const MapPair& pair) {
            return pair.key == "classname" || pair.key == "origin" || pair.key.starts_with("_external_map");
        });
        entity.pairs.insert(entity.pairs.begin(), {"classname", its_class, entity.line});
    }

    const ReadExternalSource& read_;
    Warnings& warnings_;
    std::vector<std::string> paths_;  // from the outermost source to the current one
    int count_ = 0;
    std::size_t brush_count_ = 0;
};

}  // namespace

void include_external_maps(std::vector<MapEntity>& entities, const std::string& path, const ReadExternalSource& read,
                           Warnings& warnings) {
    Includer(read, warnings).include(entities, path);
}

}  // namespace oblong::map
