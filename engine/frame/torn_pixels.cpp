#include "engine/frame/torn_pixels.h"

#include <algorithm>
#include <optional>

#include "engine/base/table.h"
#include "engine/fixed/arithmetic.h"
#include "engine/frame/claim_faces.h"
#include "engine/frame/continued_face.h"
#include "engine/frame/frame_context.h"
#include "engine/frame/frame_record.h"
#include "engine/frame/workspace.h"
#include "engine/level/side.h"
#include "engine/raster/perspective.h"
#include "engine/scene/light_styles.h"
#include "engine/surface/coloured_surface.h"
#include "engine/view/gradients.h"

namespace oblong {

namespace {

/// Traces rays through pixels.
class Rays {
  public:
    explicit Rays(const FrameContext& frame)
        : frame_(frame),
          level_(frame.scene.level),
          directions_(make_view_directions(frame.view.ray_directions(), frame.view.projection)) {
        const Vec3<World>& eye = frame.view.eye;
        const World farthest = std::max({absolute(eye.x), absolute(eye.y), absolute(eye.z)});
        reach_ = std::min(World::from_int(1 << 18), World::highest() - farthest);
    }

    WallHit hit_at(std::int32_t column, std::int32_t row) const {
        const Vec3<World> to = far_end(column, row);
        WallHit hit;
        walk_line(level_, level_.world().root, start(to), to, {},
                  [&](LeafIndex leaf, std::optional<NodeIndex> entered, const Vec3<World>& place) {
                      if (level_.leaves[leaf].is_open()) {
                          hit.open_leaf = leaf;
                          return false;
                      }
                      if (!entered || hit.open_leaf == LeafIndex::none())
                          return false;  // starts inside a mirror's wall
                      hit.node = *entered;
                      hit.is_sky = level_.leaves[leaf].contents == contents::kSky;
                      hit.place = place;
                      return true;
                  });
        return hit;
    }

  private:
    Vec3<World> far_end(std::int32_t column, std::int32_t row) const {
        const Vec3<DirectionPart> way = directions_.at(column, row);
        const DirectionPart longest = std::max({absolute(way.x), absolute(way.y), absolute(way.z)});
        const auto part = [&](DirectionPart along) { return product_over<World>(along, reach_, longest); };
        return frame_.view.eye + Vec3<World>{part(way.x), part(way.y), part(way.z)};
    }

    /// The eye, or where the ray leaves the mirror.
    Vec3<World> start(const Vec3<World>& to) const {
        Vec3<World> from = frame_.view.eye;
        for (const WalkLimit& limit : frame_.limits) {
            const PlaneDistance first = plane_distance(limit.plane, from - limit.offset),
                                last = plane_distance(limit.plane, to - limit.offset);
            if ((first < PlaneDistance{}) != (last < PlaneDistance{})) from = between(from, to, first, first - last);
        }
        return from;
    }

    const FrameContext& frame_;
    const Level& level_;
    ViewDirections directions_;
    World reach_;
};

/// Assigns a span to what is behind it.
void claim(const Span& span, const WallHit& hit, const FrameContext& frame, ViewScratch& scratch) {
    const Level& level = frame.scene.level;
    Claims& claims = scratch.claims;
    if (hit.node == NodeIndex::none()) return claims.void_spans.push_back(span);
    const PlaneIndex plane = level.nodes[hit.node].plane;
    const bool is_back = plane_distance(level.planes[plane], frame.view.eye) < PlaneDistance{};
    const FaceIndex face = continued_face(hit, is_back, level, frame.cache.continued_faces);
    if (face == FaceIndex::none()) return claims.void_spans.push_back(span);
    if (!hit.is_sky) return claims.torn.push_back({span, plane, is_back, face, hit.place});
    claims.spans.push_back(span);
    VisibleFace sky{.face = face, .bounds = {span.first, span.end, span.y, span.y + 1}};
    add_claimed(sky, claims.spans.size() - 1, frame, claims);
}

/// The same for a span with known ends, halved until both ends show the same wall.
void claim_between(const Span& span, const WallHit& first, const WallHit& last, const Rays& rays,
                   const FrameContext& frame, ViewScratch& scratch) {
    if (first.is_same_wall(last)) return claim(span, first, frame, scratch);
    const std::int32_t middle = (span.first + span.end) / 2;
    claim_between({span.y, span.first, middle}, first, rays.hit_at(middle - 1, span.y), rays, frame, scratch);
    claim_between({span.y, middle, span.end}, rays.hit_at(middle, span.y), last, rays, frame, scratch);
}

/// The face with the continued texture, on the wall's plane.
Face wall_of(const TornSpan& torn, const Level& level) {
    Face wall = level.faces[torn.face];
    wall.plane = torn.plane;
    wall.is_back = torn.is_back;
    return wall;
}

/// A multiple of a texture's size about 32,768 texels before the place, so that texels counted from there are positive.
std::int32_t origin_near(const Vec3<TexelAxis>& axis, Texel offset, const Vec3<World>& place, std::int32_t size) {
    return static_cast<std::int32_t>(floor_of(texel_along(axis, place) + offset) / size - 32'768 / size) * size;
}

/// Draws texels of a wall without a face: the texture repeats, and the light is that at the face's border.
class TornDrawing {
  public:
    TornDrawing(const TornSpan& torn, const FrameContext& frame, const ViewScratch& scratch)
        : level_(frame.scene.level),
          face_(level_.faces[torn.face]),
          texture_(level_.texture_of(face_)),
          styles_(scratch.light.styles),
          colormap_(frame.cache.surfaces.colormap()),
          cube_(frame.cache.surfaces.colour_cube()),
          brightness_100_(frame.settings.brightness_100) {
        const TexInfo& texinfo = level_.texinfos[face_.texinfo];
        surface_.origin_u = origin_near(texinfo.s, texinfo.s_offset, torn.place, texture_.width);
        surface_.origin_v = origin_near(texinfo.t, texinfo.t_offset, torn.place, texture_.height);
        const PlaneInverseZ inverse_z = inverse_z_of(torn, frame);
        const InverseZ nearest = std::max({inverse_z.at(torn.span.first, torn.span.y),
                                           inverse_z.at(torn.span.end - 1, torn.span.y), InverseZ::ulp()});
        surface_.mip = frame.cache.surfaces.mip_level(torn.face, reciprocal<View>(nearest), frame.view.projection.x,
                                                      frame.accuracy().mip_bias);
        gradients_ = make_face_gradients(level_, wall_of(torn, level_), surface_, {}, inverse_z, frame.view,
                                         frame.inverse_projection);
    }

    std::uint8_t colour_at(std::int32_t column, std::int32_t row) const {
        const Perspective at = Perspective::at(gradients_, column, row);
        const Depth<DividedReciprocal, PerspectiveRange::MayOverflow> depth(at.inverse_z, {});
        const std::int64_t u = floor_of(depth.times(at.u_over_z)), v = floor_of(depth.times(at.v_over_z));
        const int mip = surface_.mip;
        const std::int64_t width = texture_.width >> mip, height = texture_.height >> mip;
        const std::uint8_t texel = oblong::item(oblong::item(texture_.mips, mip), v % height * width + u % width);
        const auto light_8 = [&](std::optional<int> channel) { return light_at(u << mip, v << mip, channel); };
        if (cube_) return coloured_texel(*cube_, texel, {light_8(0), light_8(1), light_8(2)});
        const std::int32_t shade =
            level_.lighting.empty() ? Colormap::kOwnShade : shade_of(light_8(std::nullopt)) >> 16;
        return oblong::item(oblong::item(colormap_.shades, shade), texel);
    }

  private:
    std::int32_t light_at(std::int64_t u, std::int64_t v, std::optional<int> channel) const {
        const auto within = [](std::int64_t texel, std::int32_t extent) {
            return std::clamp<std::int64_t>(texel, 0, extent);
        };
        const std::int32_t light_8 = light_8_of_sample(
            level_, face_, within(u + surface_.origin_u - face_.texel_min_u, face_.texel_extent_u),
            within(v + surface_.origin_v - face_.texel_min_v, face_.texel_extent_v), styles_, channel);
        return brightened(light_8, brightness_100_);
    }

    const Level& level_;
    const Face& face_;
    const MipTexture& texture_;
    const LightStyles& styles_;
    const Colormap& colormap_;
    const ColourCube* cube_;
    std::int32_t brightness_100_;
    FaceSurface surface_;
    TextureGradients gradients_;
};

}  // namespace

void claim_torn_pixels(const FrameContext& frame, ViewScratch& scratch) {
    SpanList free;
    scratch.claiming->span_buffer.claim_rest(free);
    const bool shows_void = frame.view.shows_void || !scratch.visible.is_from_open();
    std::optional<Rays> rays;
    if (!shows_void) rays.emplace(frame);
    for (const Span& span : free)
        if (shows_void)
            scratch.claims.void_spans.push_back(span);
        else
            claim_between(span, rays->hit_at(span.first, span.y), rays->hit_at(span.end - 1, span.y), *rays, frame,
                          scratch);
}

void draw_torn_pixels(const FrameContext& frame, ViewScratch& scratch) {
    fill_spans(scratch.claims.void_spans, 0, frame.out);
    for (const TornSpan& torn : scratch.claims.torn) {
        observe_spans({.face = torn.face}, {&torn.span, 1}, frame.out, frame.observers);
        const TornDrawing drawing(torn, frame, scratch);
        std::uint8_t* const row = frame.out.row(torn.span.y);
        for (std::int32_t x = torn.span.first; x < torn.span.end; ++x) row[x] = drawing.colour_at(x, torn.span.y);
    }
}

PlaneInverseZ inverse_z_of(const TornSpan& torn, const FrameContext& frame) {
    const Level& level = frame.scene.level;
    return make_face_inverse_z(level, wall_of(torn, level), {}, frame.view, frame.inverse_projection);
}

}  // namespace oblong
