#pragma once

#include <map>
#include <optional>
#include <vector>

#include "tools/map/source/geometry.h"
#include "tools/map/tree/portals.h"
#include "tools/map/tree/surfaces.h"

namespace oblong::map {

/// The corners of a model's polygons, each once: points nearer than kWeldDistance are one.
class VertexPool {
  public:
    static constexpr double kWeldDistance = 1.0 / 64;

    /// The index of the vertex at or next to the point. Nearly whole coordinates become whole, others multiples of
    /// 1/4096.
    int find_or_add(const Point& point);

    const std::vector<Point>& points() const { return points_; }
    const Point& operator[](int index) const { return item(points_, index); }

    /// The vertices in the box, and perhaps some around it; in ascending order.
    std::vector<int> near_box(const Box& box) const;

  private:
    static constexpr double kCell = 64;
    using Cell = std::array<int, 3>;
    static Cell cell_of(const Point& point);

    std::vector<Point> points_;
    std::map<Cell, std::vector<int>> cells_;
};

/// A polygon as indices of vertices.
using Loop = std::vector<int>;

/// Puts a vertex into every edge on which one lies (within the weld distance), so that no vertex is in the interior of
/// an edge. Loops that enclose nothing come out empty; as their neighbours run through the same vertices, no gap opens.
void fix_t_junctions(std::vector<Loop>& loops, const VertexPool& pool);

/// The world, or a brush entity, compiled: before its numbering for the file.
struct CompiledModel {
    Box box;
    Tree tree;
    Portals portals;
    std::vector<Surface> surfaces;  ///< grouped by node
    std::vector<Loop> loops;        ///< of each surface, the corners in `vertices`
    VertexPool vertices;
    std::vector<Tree> hulls;  ///< for kPlayerBox, and kLargeBox unless it is a draft; leaves are solid or empty
};

/// Where a sealed level must not be open to the void, or nothing for a model that needs no seal.
using SealStarts = std::optional<std::vector<Point>>;

struct ModelResult {
    CompiledModel model;
    std::optional<Leak> leak;  ///< then the model is not complete
};

/// Compiles brushes into a model: with `starts`, fills what is outside of the level. What it is given must outlive it.
class ModelCompiler {
  public:
    /// Adds planes. All that it does later only reads them. `is_draft`: without a hull for kLargeBox,
    /// and with more nodes in the other one.
    ModelCompiler(const std::vector<Brush>& brushes, PlaneList& planes, const std::vector<TexInfo>& texinfos,
                  SealStarts starts, bool is_draft);

    std::size_t part_count() const { return 1 + grown_.size(); }  ///< what is drawn, and the hulls
    /// Each once, in any order, several at a time.
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
