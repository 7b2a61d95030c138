#pragma once

#include <ostream>
#include <string>
#include <utility>
#include <vector>

#include "tools/demo_level/map/brush.h"

namespace oblong::map_source {

/// An entity of a .map: keys with values, and the brushes it is made of (none: a point).
struct MapEntity {
    std::vector<std::pair<std::string, std::string>> pairs;
    std::vector<Brush> brushes;
};

/// A level while it is built: the first entity is the world, the second its details.
class Draft {
  public:
    explicit Draft(std::vector<std::pair<std::string, std::string>> world_pairs);

    void add(Brush brush) { entities_.front().brushes.push_back(std::move(brush)); }
    void add_box(const Box& box, const Skin& skin) { add(make_box(box, skin)); }
    /// For what hides little (columns, lamps, trees): the compiler need not work out what is seen past it.
    void add_detail(Brush brush) { entities_[1].brushes.push_back(std::move(brush)); }
    /// A hair's breadth less on every side than said.
    void add_detail_box(const Box& box, const Skin& skin) { add_detail(make_box(within(box), skin)); }
    /// A hair's breadth less at both of its ends.
    void add_detail_prism(const Outline& outline, double low, double high, const Skin& skin) {
        add_detail(extrude(outline, low + kHairsbreadth, high - kHairsbreadth, skin));
    }
    /// A point entity; `more` are pairs after classname and origin.
    void add_point(const std::string& classname, const Point& origin,
                   std::vector<std::pair<std::string, std::string>> more = {});
    /// Light that fades to nothing within `brightness` / 1.5 units; `style` is one of Quake's, 0 for steady. Nothing
    /// within `lamp_radius` throws a shadow in it: the lamp's own body.
    void add_light(const Point& origin, int brightness, int style = 0, int lamp_radius = 0);
    void add_entity(MapEntity entity) { entities_.push_back(std::move(entity)); }

    const std::vector<MapEntity>& entities() const { return entities_; }

  private:
    std::vector<MapEntity> entities_;
};

/// Quake's .map format.
void write_map(const Draft& draft, std::ostream& out);

}  // namespace oblong::map_source
