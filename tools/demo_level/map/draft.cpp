#include "tools/demo_level/map/draft.h"

#include <sstream>

namespace oblong::map_source {
namespace {

std::string words(const Point& point) {
    std::ostringstream text;
    text.precision(15);
    text << point.x << ' ' << point.y << ' ' << point.z;
    return text.str();
}

void write_face(const BrushFace& face, std::ostream& out) {
    for (const Point& point : face.points) out << "( " << words(point) << " ) ";
    const Placement& placement = face.placement;
    out << placement.texture << ' ' << placement.offset_u << ' ' << placement.offset_v << " 0 " << placement.scale_u
        << ' ' << placement.scale_v << '\n';
}

void write_brush(const Brush& brush, std::ostream& out) {
    out << "{\n";
    for (const BrushFace& face : brush.faces) write_face(face, out);
    out << "}\n";
}

}  // namespace

Draft::Draft(std::vector<std::pair<std::string, std::string>> world_pairs) {
    world_pairs.insert(world_pairs.begin(), {"classname", "worldspawn"});
    entities_.push_back({std::move(world_pairs), {}});
    entities_.push_back({{{"classname", "func_detail"}}, {}});
}

void Draft::add_point(const std::string& classname, const Point& origin,
                      std::vector<std::pair<std::string, std::string>> more) {
    MapEntity entity{{{"classname", classname}, {"origin", words(origin)}}, {}};
    entity.pairs.insert(entity.pairs.end(), more.begin(), more.end());
    add_entity(std::move(entity));
}

void Draft::add_light(const Point& origin, int brightness, int style, int lamp_radius) {
    std::vector<std::pair<std::string, std::string>> more{{"light", std::to_string(brightness)}, {"wait", "1.5"}};
    if (style != 0) more.emplace_back("style", std::to_string(style));
    if (lamp_radius != 0) more.emplace_back("radius", std::to_string(lamp_radius));
    add_point("light", origin, more);
}

void write_map(const Draft& draft, std::ostream& out) {
    for (const MapEntity& entity : draft.entities()) {
        out << "{\n";
        for (const auto& [key, value] : entity.pairs) out << '"' << key << "\" \"" << value << "\"\n";
        for (const Brush& brush : entity.brushes) write_brush(brush, out);
        out << "}\n";
    }
}

}  // namespace oblong::map_source
