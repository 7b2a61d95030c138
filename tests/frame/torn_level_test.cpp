#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <random>
#include <set>

#include "engine/platform/worker_threads.h"
#include "engine/scene/face_table.h"
#include "tests/frame/frame_fixture.h"
#include "tests/frame/holes.h"
#include "tests/support/palettes.h"
#include "tests/support/pictures.h"
#include "tests/support/point.h"
#include "tests/support/random.h"
#include "tests/support/views.h"

namespace oblong::test::torn_level_test {
namespace {

/// Where the ray through the middle of a pixel meets a plane.
Point meeting(const TrueCamera& camera, int column, int row, const LevelPlane& plane) {
    const Point ray = camera.through_pixel(column, row), normal = to_point(plane.normal);
    return camera.eye + ray * ((number_of(plane.distance) - dot(normal, camera.eye)) / dot(normal, ray));
}

/// Whether solid begins behind a place of a wall and the open ends before it; `depth` units off it.
bool is_wall_at(const Level& level, const Point& place, const TornSpan& torn, double depth) {
    const Point normal = to_point(level.planes[torn.plane].normal);
    const auto contents_off = [&](double away) {
        return level.leaves[find_leaf(level, level.world(), to_world(place + normal * away))].contents;
    };
    const double toward_eye = torn.is_back ? -depth : depth;
    return contents_off(-toward_eye) == contents::kSolid && contents_off(toward_eye) != contents::kSolid;
}

/// A texture coordinate of a place.
double texel_of(const Vec3<TexelAxis>& axis, Texel offset, const Point& place) {
    return dot(to_point(axis), place) + number_of(offset);
}

/// The shades of the light samples around a texel of a face, `u` and `v` from its least ones: those of its border
/// beyond it.
std::set<int> shades_around(const Level& level, const Face& face, double u, double v) {
    const int columns = face.texel_extent_u / 16 + 1, rows = face.texel_extent_v / 16 + 1;
    if (face.light_offset < 0) return {Colormap::kShades - 1};
    std::set<int> shades;
    for (const double off_u : {-0.25, 0.25, 16.0})
        for (const double off_v : {-0.25, 0.25, 16.0}) {
            const int column = std::clamp(static_cast<int>(std::floor((u + off_u) / 16)), 0, columns - 1),
                      row = std::clamp(static_cast<int>(std::floor((v + off_v) / 16)), 0, rows - 1);
            double light = 0;
            for (std::size_t style = 0; style < 4 && face.styles[style] != 255; ++style)
                light += level.lighting[static_cast<std::size_t>(
                    face.light_offset + (static_cast<int>(style) * rows + row) * columns + column)];
            shades.insert(static_cast<int>(shade_in_doubles(light)));
        }
    return shades;
}

/// Whether a colour is that of the texels at a place, or next to it, at any mip level, in the light there.
bool is_lit_texel_there(const Stage& stage, const Face& face, const Point& place, std::uint8_t colour) {
    const TexInfo& texinfo = stage.level.texinfos[face.texinfo];
    const MipTexture& texture = stage.level.texture_of(face);
    const double u = texel_of(texinfo.s, texinfo.s_offset, place), v = texel_of(texinfo.t, texinfo.t_offset, place);
    const auto wrapped = [](double texel, int size) {
        return (static_cast<int>(std::floor(texel)) % size + size) % size;
    };
    const std::set<int> shades = shades_around(stage.level, face, u - face.texel_min_u, v - face.texel_min_v);
    for (std::size_t mip = 0; mip < 4; ++mip)
        for (const int off_u : {-1, 0, 1})
            for (const int off_v : {-1, 0, 1}) {
                const int column = wrapped(u + off_u * 0.25, texture.width) >> mip,
                          row = wrapped(v + off_v * 0.25, texture.height) >> mip;
                const std::uint8_t own = item(texture.mips[mip], row * (texture.width >> mip) + column);
                for (const int shade : shades)
                    if (item(stage.colormap.shades, shade)[own] == colour) return true;
            }
    return false;
}

/// The demo level, with the last face of every twelfth node left out, by chance.
Stage torn_stage(std::mt19937& random) {
    Stage stage = demo_stage();
    for (Node& node : stage.level.nodes)
        if (node.faces.count > 0 && random() % 12 == 0) --node.faces.count;
    stage.models.clear();
    stage.settings.allowed_effects = EffectSet{}.with(Effect::Sky).with(Effect::Liquid);
    stage.settings.accuracy.mip_bias = -3;
    return stage;
}

Camera random_level_camera(const Level& level, std::mt19937& random) {
    return {random_open_point(level, random), random_angle(random), {}, {}};
}

/// By what the face that goes on where one is missing is chosen, the least counts: the distance of its nearest corner
/// from the middle of the leaf in front, 256 units more on another plane; infinite if it is unsuitable.
double choice_distance(const Level& level, const Face& face, const TornSpan& torn, const Point& middle) {
    const bool is_on_plane = face.plane == torn.plane && face.is_back == torn.is_back;
    const Point normal = to_point(level.planes[face.plane].normal), of_wall = to_point(level.planes[torn.plane].normal);
    if (level.texinfos[face.texinfo].material != Material::Lit) return INFINITY;
    if (!is_on_plane && std::abs(dot(normal, of_wall)) <= 0.5) return INFINITY;
    double nearest = INFINITY;
    for (const SurfEdge step : level.edges_of(face))
        nearest = std::min(nearest, length(to_point(level.vertices[level.start_of(step)]) - middle));
    return nearest + (is_on_plane ? 0 : 256);
}

/// Whether no face of the tree is nearer to a wall than the one that goes on there.
bool is_nearest_face(const Level& level, const TornSpan& torn, const Point& place) {
    // Some leaves along a wall are thin.
    const Point normal = to_point(level.planes[torn.plane].normal) * (torn.is_back ? -0.004 : 0.004);
    const LevelBox& box = level.leaves[find_leaf(level, level.world(), to_world(place + normal))].box;
    const Point middle =
        Point{box.mins[0] + box.maxs[0] + 0.0, box.mins[1] + box.maxs[1] + 0.0, box.mins[2] + box.maxs[2] + 0.0} * 0.5;
    const double found = choice_distance(level, level.faces[torn.face], torn, middle);
    const FaceIndex end = *level.world().faces.end();  // brush models, which have nodes, too, follow
    for (const Node& node : level.nodes)
        for (const FaceIndex face : node.faces)
            if (face < end && choice_distance(level, level.faces[face], torn, middle) < found - 0.01) return false;
    return true;
}

struct Tally {
    int pixels = 0, off_walls = 0, off_textures = 0, far_faces = 0;
};

/// Holds the middle pixel of each torn span against a ray in doubles.
void check_torn_spans(const Stage& stage, const Camera& camera, const Claims& claims, Tally& tally) {
    for (const TornSpan& torn : claims.torn) {
        const int column = (torn.span.first + torn.span.end) / 2, row = torn.span.y;
        const Point place = meeting(TrueCamera(camera), column, row, stage.level.planes[torn.plane]);
        ++tally.pixels;
        tally.off_walls += !is_wall_at(stage.level, place, torn, 0.125);
        tally.far_faces += tally.pixels % 64 == 0 && !is_nearest_face(stage.level, torn, place);
        tally.off_textures += !is_lit_texel_there(stage, stage.level.faces[torn.face], place,
                                                  stage.pixels[static_cast<std::size_t>(row * 320 + column)]);
    }
}

/// What no face covers is a wall where the tree says that the open ends, and shows the texture that belongs there.
TEST(TornLevel, WhereAFaceIsMissingItsWallIsDrawnWithTheTextureOfTheNextOne) {
    std::mt19937 random(19);
    Tally tally;
    for (int levels = 0; levels < 20; ++levels) {
        Stage stage = torn_stage(random);
        const auto work = counting_workspace(stage);
        EXPECT_GT(work->cache.faces.torn_edges, 20u);
        for (int frames = 0; frames < 50; ++frames) {
            const Camera camera = random_level_camera(stage.level, random);
            expect_each_pixel_once(stage, camera, *work);
            check_torn_spans(stage, camera, work->view.claims, tally);
        }
    }
    EXPECT_GT(tally.pixels, 10'000);
    EXPECT_LT(tally.off_walls * 100, tally.pixels) << tally.off_walls << " of " << tally.pixels;
    EXPECT_EQ(tally.off_textures, 0);
    EXPECT_EQ(tally.far_faces, 0);
}

/// Which face goes on does not depend on what was drawn before, nor the picture on how many threads draw it.
TEST(TornLevel, AFreshWorkspaceDrawsTheSameBytes) {
    std::mt19937 random(20);
    Stage stage = torn_stage(random);
    stage.settings = {};
    FrameWorkspace used(stage.level, stage.mode);
    WorkerThreads workers(1);
    FrameWorkspace shared(stage.level, stage.mode, &workers);
    for (int frames = 0; frames < 20; ++frames) {
        const Camera camera = random_level_camera(stage.level, random);
        FrameWorkspace fresh(stage.level, stage.mode);
        stage.draw(camera, used);
        const std::vector<std::uint8_t> pixels = stage.pixels;
        for (FrameWorkspace* other : {&fresh, &shared}) {
            stage.draw(camera, *other);
            ASSERT_TRUE(same_picture(stage.pixels, pixels)) << describe(camera, 0, 0);
        }
    }
}

/// One corner of one face moved tears the two edges that meet in it: four are walked by one face alone.
TEST(TornLevel, EveryEdgeThatOneFaceAloneWalksIsCounted) {
    Stage stage = demo_stage();
    ASSERT_EQ(make_face_table(stage.level).torn_edges, 0u);
    const Face& face = stage.level.faces[stage.level.world().faces.first];
    SurfEdge& last = stage.level.surf_edges[face.edges.first];
    const Edge torn = stage.level.edges[last.edge()];
    stage.level.vertices.push_back(stage.level.vertices[last.is_reversed() ? torn.to : torn.from] +
                                   Vec3<World>{World::from_int(3), World::from_int(1), World::from_int(2)});
    const VertexIndex moved(static_cast<std::int32_t>(stage.level.vertices.size()) - 1);
    stage.level.edges.push_back(last.is_reversed() ? Edge{torn.from, moved} : Edge{moved, torn.to});
    last = {EdgeIndex(static_cast<std::int32_t>(stage.level.edges.size()) - 1), last.is_reversed()};
    const std::size_t torn_edges = make_face_table(stage.level).torn_edges;
    // The moved ends of two edges, and those edges' other faces; more where other vertices lie on them.
    EXPECT_GE(torn_edges, 4u);
    EXPECT_LT(torn_edges, 40u);
}

// Real levels have corners of faces in the middle of other faces' edges (hard case E9). In the outlines that are drawn
// there are none left: looked for here by brute force, in doubles.

Point point_of(const Level& level, VertexIndex vertex) {
    return to_point(level.vertices[vertex]);
}

/// Whether p lies on the edge from a to b, nearer than 1/600 unit to it and farther than 1/100 from its ends.
bool is_inside_edge(const Point& a, const Point& b, const Point& p) {
    const Point along = b - a, offset = p - a;
    const double size = length(along);
    if (size == 0) return false;
    const double part = dot(offset, along) / size;
    if (part < 0.01 || part > size - 0.01) return false;
    return length(offset - along * (part / size)) < 1.0 / 600;
}

bool has_vertex_inside(const Level& level, const std::vector<VertexIndex>& by_x, VertexIndex from, VertexIndex to) {
    const Point a = point_of(level, from), b = point_of(level, to);
    const auto first = std::partition_point(
        by_x.begin(), by_x.end(), [&](VertexIndex v) { return point_of(level, v).x < std::min(a.x, b.x) - 0.01; });
    for (auto v = first; v != by_x.end() && point_of(level, *v).x <= std::max(a.x, b.x) + 0.01; ++v)
        if (is_inside_edge(a, b, point_of(level, *v))) return true;
    return false;
}

std::vector<VertexIndex> used_vertices_by_x(const Level& level, const FaceTable& table) {
    const std::set<VertexIndex> used(table.corners.begin(), table.corners.end());
    std::vector<VertexIndex> sorted(used.begin(), used.end());
    std::sort(sorted.begin(), sorted.end(),
              [&](VertexIndex a, VertexIndex b) { return point_of(level, a).x < point_of(level, b).x; });
    return sorted;
}

class MendedOutlines : public OfLevel {};

}  // namespace

TEST_P(MendedOutlines, HardCaseE9_NoCornerLiesWithinAnEdge) {
    const Stage stage = real_stage(GetParam());
    const FaceTable table = make_face_table(stage.level);
    const std::vector<VertexIndex> by_x = used_vertices_by_x(stage.level, table);
    for (const FaceIndex face : stage.level.faces.indices()) {
        const std::span<const VertexIndex> corners = table.corners_of(face);
        for (std::size_t i = 0; i < corners.size(); ++i)
            ASSERT_FALSE(has_vertex_inside(stage.level, by_x, corners[i], corners[(i + 1) % corners.size()]))
                << face.number();
    }
}

/// So that a frame has no hole: FrontToBackWalk (visibility/front_to_back.h).
TEST_P(MendedOutlines, TheFacesOfTheWorldAreAClosedSurface) {
    const Stage stage = real_stage(GetParam());
    const FaceTable table = make_face_table(stage.level);
    using Place = std::array<std::int32_t, 3>;
    const auto place_of = [&](VertexIndex vertex) {
        const Vec3<World>& p = stage.level.vertices[vertex];
        return Place{p.x.raw, p.y.raw, p.z.raw};
    };
    std::map<std::pair<Place, Place>, int> walked;  // of each edge, how often more in its direction than back
    for (const FaceIndex face : stage.level.world().faces) {
        const std::span<const VertexIndex> corners = table.corners_of(face);
        for (std::size_t i = 0; i < corners.size(); ++i) {
            const Place from = place_of(corners[i]), to = place_of(corners[(i + 1) % corners.size()]);
            ++walked[{from, to}];
            --walked[{to, from}];
        }
    }
    EXPECT_GT(walked.size(), 5000u);
    EXPECT_EQ(std::count_if(walked.begin(), walked.end(), [](const auto& edge) { return edge.second != 0; }), 0);
}

TEST_P(MendedOutlines, CornersComeInTheOrderOfTheFaceAndSomeAreNew) {
    const Stage stage = real_stage(GetParam());
    const FaceTable table = make_face_table(stage.level);
    std::size_t added = 0;
    for (const FaceIndex index : stage.level.faces.indices()) {
        const std::span<const SurfEdge> edges = stage.level.edges_of(stage.level.faces[index]);
        const std::span<const VertexIndex> corners = table.corners_of(index);
        std::size_t at = 0;  // the file's corners must all be met, in their order
        for (const SurfEdge edge : edges) {
            while (at < corners.size() && corners[at] != stage.level.start_of(edge)) ++at;
            ASSERT_LT(at, corners.size()) << index.number();
        }
        added += corners.size() - edges.size();
    }
    EXPECT_GT(added, 0u) << "these levels are known to have T-junctions";
}

OBLONG_FOR_REAL_LEVELS(MendedOutlines);
}  // namespace oblong::test::torn_level_test
