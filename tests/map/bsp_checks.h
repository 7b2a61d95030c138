#pragma once

#include <string>
#include <vector>

#include "tools/map/source/geometry.h"
#include "tools/map/tree/bsp_file.h"

/// Checks of a compiled level by brute force, in doubles, from the numbers of the file alone.
namespace oblong::test {

std::vector<map::Point> corners_of(const map::BspFile& bsp, const map::FileFace& face);

/// The plane's normal and distance, turned to the side that the face faces.
struct FacingPlane {
    map::Point normal;
    double distance = 0;
};
FacingPlane facing_plane(const map::BspFile& bsp, const map::FileFace& face);

inline const FacingPlane kFloor{{0, 0, 1}, 0};

/// The sample of a style of the face that lies in the plane, at a place that is a whole number of steps of 16 in both
/// directions of its texture; the texture lies as Standard maps lay it. -1: there is none.
int light_at(const map::BspFile& bsp, const FacingPlane& plane, const map::Point& place, std::size_t style = 0);

/// The leaf of the world that a point is in.
int leaf_at(const map::BspFile& bsp, const map::Point& point);

/// The contents at a point for the mover of hull 0 (a point), 1 or 2, in a model.
int contents_at(const map::BspFile& bsp, int model, int hull, const map::Point& point);

/// How often directed edges of the world's faces lack one in the opposite direction. 0: the surface is closed.
int open_edges(const map::BspFile& bsp);

/// What goes wrong along random lines of sight, each from a random point of a leaf that is not solid to where the tree
/// says that the first solid (or sky) is. Empty: nothing. Else the first fault in words:
/// no face there (a hole), a wall in the way where there is nothing, a leaf or the face not in the visible set.
std::string first_fault_of_rays(const map::BspFile& bsp, int ray_count, unsigned seed);

/// The set of leaves that a leaf may see, from the visibility lump.
std::vector<bool> visible_leaves(const map::BspFile& bsp, int leaf);

}  // namespace oblong::test
