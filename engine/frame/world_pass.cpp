#include "engine/frame/world_pass.h"

#include <algorithm>
#include <array>

#include "engine/base/range_probe.h"
#include "engine/fixed/wide.h"
#include "engine/raster/fill.h"

namespace oblong {

namespace {

/// The mip level for a polygon whose nearest texels are 1, 0.4 and 0.2 pixels wide at the ends of levels 0, 1 and 2:
/// Quake's thresholds.
int mip_level(std::int64_t nearest_z_16, std::int64_t density_16, const ProjectionAxis& axis) {
    const std::int64_t texels_per_pixel_times_lens_16 = mul_shift(nearest_z_16, density_16, 16, Rounding::Floor);
    const std::int64_t lens_16 = axis.coarse_16;
    note_range<Quantity::MipProduct>(texels_per_pixel_times_lens_16);
    return (texels_per_pixel_times_lens_16 > lens_16) + (texels_per_pixel_times_lens_16 * 2 > lens_16 * 5) +
           (texels_per_pixel_times_lens_16 > lens_16 * 5);
}

/// Texture coordinates of the eye, 16.16, from the world's origin.
std::int64_t eye_texel_16(const Vec3<TexelAxis>& axis, TexelOffset offset, const Vec3<World>& eye) {
    const std::int64_t sum_35 = std::int64_t{axis.x.raw} * eye.x.raw + std::int64_t{axis.y.raw} * eye.y.raw +
                                std::int64_t{axis.z.raw} * eye.z.raw;
    note_range<Quantity::EyeTexelSum>(sum_35);
    const std::int64_t texel_16 = rounded_shift(sum_35, 19, Rounding::NearestHalfUp) + offset.raw;
    note_range<Quantity::EyeTexel>(texel_16);
    return texel_16;
}

std::int32_t floor_to_multiple(std::int32_t value, std::int32_t size) {
    const std::int32_t rest = value % size;
    return value - (rest < 0 ? rest + size : rest);
}

/// A surface as one face shows it: its texels, and the texel of mip level 0 that its first column and row are.
struct FaceSurface {
    SurfaceView view;
    std::int32_t origin_u = 0, origin_v = 0;
    TexelLimits limits;
    BlockKernel kernel;
};

class FacePainter {
  public:
    FacePainter(const FrameContext& frame, FrameWorkspace& work) : frame_(frame), work_(work) {}

    /// A face of the world.
    void paint_world_face(std::int32_t index) {
        if (work_.counts) ++work_.counts->faces_visited;
        if (make_face_outline(work_.faces.corners_of(index), frame_.view, work_.vertices, work_.outline))
            paint_outline(index, {});
    }

    /// The parts of brush models in a leaf.
    void paint_fragments(std::int32_t leaf) {
        if (!work_.brush_models.has_any_in(leaf)) return;
        for (const Fragment* fragment :
             work_.brush_models.front_to_back_in(leaf, frame_.scene.level, frame_.view.eye)) {
            if (work_.counts) ++work_.counts->faces_visited;
            if (make_polygon_outline(work_.brush_models.corners_of(*fragment), frame_.view, work_.outline))
                paint_outline(fragment->face, frame_.scene.models[static_cast<std::size_t>(fragment->placed)].offset);
        }
    }

  private:
    void paint_outline(std::int32_t index, const Vec3<World>& offset) {
        work_.owned.clear();
        claim_outline(work_.outline, work_.rows, work_.coverage, work_.owned);
        if (work_.owned.empty()) return;
        const FaceKind kind = work_.faces.kinds[static_cast<std::size_t>(index)];
        if (work_.counts) count_face(kind);
        const bool is_left_out = (kind == FaceKind::Sky && !frame_.plan.effects.has(Effect::Sky)) ||
                                 (kind == FaceKind::Liquid && !frame_.plan.effects.has(Effect::Liquid));
        if (is_left_out) return paint_flat(index);
        if (kind == FaceKind::Lit || kind == FaceKind::Liquid) return paint_owned(index, kind, offset);
        work_.sky_spans.insert(work_.sky_spans.end(), work_.owned.begin(), work_.owned.end());
        if (work_.counts) count_owned();
    }

    /// What an effect would have drawn, in one colour of its texture.
    void paint_flat(std::int32_t index) {
        const Level& level = frame_.scene.level;
        const Face& face = level.faces[static_cast<std::size_t>(index)];
        const TexInfo& texinfo = level.texinfos[static_cast<std::size_t>(face.texinfo)];
        fill_spans(work_.owned, level.textures[static_cast<std::size_t>(texinfo.miptex)].mips[3][0], frame_.out);
        if (work_.counts) count_owned();
    }

    void paint_owned(std::int32_t index, FaceKind kind, const Vec3<World>& offset) {
        const Level& level = frame_.scene.level;
        const Face& face = level.faces[static_cast<std::size_t>(index)];
        const auto texinfo = static_cast<std::size_t>(face.texinfo);
        const int mip = mip_level(work_.outline.nearest_z_16, work_.faces.density_16[texinfo], frame_.view.lens.x);
        const FaceSurface surface = kind == FaceKind::Lit ? lit_surface(index, face, mip) : liquid_surface(face, mip);
        const TextureGradients gradients = gradients_of(face, surface, mip, offset);
        const BlockLadder ladder =
            make_block_ladder(frame_.block_rule, static_cast<std::int64_t>(gradients.inverse_z_44.per_column));
        for (const Span& span : work_.owned) {
            if (!work_.blocks.has_room_for(span.end - span.first)) draw_waiting(surface);
            const std::int32_t divisions = append_blocks(span, frame_.out.pitch, gradients, frame_.block_rule, ladder,
                                                         surface.limits, work_.blocks);
            if (work_.counts) work_.counts->divisions += divisions;
        }
        draw_waiting(surface);
    }

    void draw_waiting(const FaceSurface& surface) {
        surface.kernel(work_.blocks.waiting(), surface.view, frame_.out.pixels);
        if (work_.counts) count_writes();
        work_.blocks.clear();
    }

    FaceSurface lit_surface(std::int32_t index, const Face& face, int mip) {
        FaceSurface surface;
        surface.view = lit_surface_of(frame_.scene.level, index, mip, frame_.scene.colormap, frame_.scene.light_styles,
                                      work_.surfaces, work_.corner_shades);
        surface.origin_u = face.texel_min_u;
        surface.origin_v = face.texel_min_v;
        surface.limits = make_texel_limits(std::max(face.texel_extent_u >> mip, 1),
                                           std::max(face.texel_extent_v >> mip, 1), frame_.view.lens.width_px);
        surface.kernel = work_.kernel;
        return surface;
    }

    FaceSurface liquid_surface(const Face& face, int mip) {
        const Level& level = frame_.scene.level;
        const TexInfo& texinfo = level.texinfos[static_cast<std::size_t>(face.texinfo)];
        const MipTexture& texture = level.textures[static_cast<std::size_t>(texinfo.miptex)];
        FaceSurface surface;
        surface.view = tile_of(texture, mip);
        surface.origin_u = floor_to_multiple(face.texel_min_u, texture.width);
        surface.origin_v = floor_to_multiple(face.texel_min_v, texture.height);
        surface.limits = make_texel_limits(65535, 65535, frame_.view.lens.width_px);
        surface.kernel = is_tile_packable(surface.view) ? work_.kernel : draw_blocks_any_size;
        return surface;
    }

    TextureGradients gradients_of(const Face& face, const FaceSurface& surface, int mip,
                                  const Vec3<World>& offset) const {
        const Level& level = frame_.scene.level;
        const LevelPlane& plane = level.planes[static_cast<std::size_t>(face.plane)];
        const TexInfo& texinfo = level.texinfos[static_cast<std::size_t>(face.texinfo)];
        const Vec3<World> eye = frame_.view.eye - offset;
        const std::int64_t distance_42 = plane_distance_42(plane, eye);
        TexturedPlane textured;
        textured.normal = face.is_back ? -plane.normal : plane.normal;
        // Edge-on, or turned round by rounding to the screen: a sliver, whose texels any steep view of the plane
        // serves.
        constexpr std::int64_t kLeastDistance_42 = std::int64_t{1} << 30;
        textured.eye_distance =
            PlaneDistance::from_raw(std::max(face.is_back ? -distance_42 : distance_42, kLeastDistance_42));
        textured.s = texinfo.s;
        textured.t = texinfo.t;
        textured.eye_u_16 = eye_texel_16(texinfo.s, texinfo.s_offset, eye) - std::int64_t{surface.origin_u} * 65536;
        textured.eye_v_16 = eye_texel_16(texinfo.t, texinfo.t_offset, eye) - std::int64_t{surface.origin_v} * 65536;
        textured.mip = mip;
        return make_texture_gradients(textured, frame_.view.axes, frame_.gradient_lens);
    }

    void count_face(FaceKind kind) {
        FrameCounts& counts = *work_.counts;
        ++counts.faces_drawn;
        counts.spans += static_cast<std::int64_t>(work_.owned.size());
        std::int64_t pixels = 0;
        for (const Span& span : work_.owned) pixels += span.end - span.first;
        if (kind == FaceKind::Sky) counts.effect_pixels[static_cast<std::size_t>(Effect::Sky)] += pixels;
        if (kind == FaceKind::Liquid) counts.effect_pixels[static_cast<std::size_t>(Effect::Liquid)] += pixels;
    }

    void count_writes() {
        for (const TexelBlock& block : work_.blocks.waiting())
            count_run(block.pixel, static_cast<std::uint32_t>(block.count));
    }

    void count_owned() {
        for (const Span& span : work_.owned)
            count_run(static_cast<std::uint32_t>(span.y * frame_.out.pitch + span.first),
                      static_cast<std::uint32_t>(span.end - span.first));
    }

    void count_run(std::uint32_t pixel, std::uint32_t count) {
        for (std::uint32_t i = pixel; i < pixel + count; ++i) {
            std::uint8_t& writes = work_.counts->writes[i];
            writes = static_cast<std::uint8_t>(std::min(writes + 1, 255));
        }
    }

    const FrameContext& frame_;
    FrameWorkspace& work_;
};

}  // namespace

void draw_world(const FrameContext& frame, FrameWorkspace& work) {
    const Level& level = frame.scene.level;
    work.vertices.start_frame();
    work.coverage.reset();
    work.sky_spans.clear();
    work.brush_models.start_frame();

    FacePainter painter(frame, work);
    const bool has_models = frame.plan.effects.has(Effect::BrushModels);
    walk_front_to_back(
        level, frame.view.eye, frame.view.frustum, work.visible,
        both_sides_distance_42(frame.settings.accuracy.subpixel_bits), work.walk,
        [&](std::int32_t leaf) {
            if (has_models) painter.paint_fragments(leaf);
        },
        [&](std::int32_t face) { painter.paint_world_face(face); },
        [&](const LevelBox& box) {
            const std::optional<ScreenRectangle> rectangle = rectangle_of(box, frame.view);
            return rectangle && !work.coverage.may_be_free(*rectangle);
        },
        [&] { return work.coverage.is_full(); });
}

}  // namespace oblong
