#pragma once

#include <cstdint>
#include <optional>
#include <unordered_map>
#include <vector>

#include "tools/map/source/geometry.h"
#include "tools/map/tree/portals.h"
#include "tools/map/tree/surfaces.h"

namespace oblong::map {

/// The corners of a model's polygons, each once: points nearer than kWeldDistance are merged.
class VertexPool {
  public:
    static constexpr double kWeldDistance = 1.0 / 64;

    /// The index of the vertex at the point or within kWeldDistance, which is added if missing. Nearly whole
    /// coordinates become whole, others multiples of 1/4096.
    int find_or_add(const Point& point);

    const std::vector<Point>& points() const { return points_; }
    const Point& operator[](int index) const { return item(points_, index); }

    /// Appends the vertices in the box, and possibly some around it.
    void add_near(const Box& box, std::vector<int>& found) const;

  private:
    static constexpr double kCell = 64;
    using Cell = std::array<int, 3>;
    static Cell cell_of(const Point& point);
    static std::uint64_t key_of(int x, int y, int z);

    std::vector<Point> points_;
    std::unordered_map<std::uint64_t, std::vector<int>> cells_;  // by key_of() a cell
    std::vector<int> near_;                                      // memory for reuse
};

/// The compiled world or brush entity, before its numbering for the file.
struct CompiledModel {
    Box box;
    Tree tree;
    Portals portals;
    std::vector<Surface> surfaces;  ///< grouped by node
    VertexPool vertices;
    std::vector<Tree> hulls;  ///< for kPlayerBox, and, except in drafts, kLargeBox; leaves are solid or empty
};

/// Points that must be sealed from the void; none for a model that needs no seal.
using SealStarts = std::optional<std::vector<Point>>;

struct ModelResult {
    CompiledModel model;
    std::optional<Leak> leak;  ///< then the model is not complete, or with its outside in a draft
};

/// Compiles brushes into a model: with `starts`, fills the outside of the level. Its arguments must outlive it.
class ModelCompiler {
  public:
    /// Adds planes; later functions only read them. `is_draft`: without a hull for kLargeBox, and with more nodes in
    /// the other one.
    ModelCompiler(const std::vector<Brush>& brushes, PlaneList& planes, const std::vector<TexInfo>& texinfos,
                  SealStarts starts, bool is_draft);

    std::size_t part_count() const { return 1 + grown_.size(); }  ///< the drawn part, and the hulls
    /// Call it once for each part, in any order, also in parallel.
    void do_part(std::size_t part);

    ModelResult& result() { return result_; }

  private:
    void make_drawn(const Box& outer);

    const std::vector<Brush>& brushes_;
    std::vector<std::vector<Brush>> grown_;  // of the hulls
    const PlaneList& planes_;
    const std::vector<TexInfo>& texinfos_;
    SealStarts starts_;
    bool is_draft_;
    ModelResult result_;
};

}  // namespace oblong::map
