#include <algorithm>
#include <array>
#include <string>
#include <tuple>
#include <utility>

#include "engine/accuracy/accuracy.h"
#include "engine/base/table.h"
#include "engine/fixed/root.h"
#include "engine/frame/frame_record.h"
#include "engine/frame/surface_pass.h"
#include "engine/math/soft_float.h"
#include "engine/methods/transforms.h"
#include "engine/methods/triangles.h"
#include "engine/view/screen_polygon.h"
#include "tools/probe/fields.h"
#include "tools/probe/probe.h"

namespace oblong {

namespace {

/// Moves a texture coordinate of the three corners by whole texels to start near 0, as surfaces do. Returns by how
/// much.
Texel rebase(std::array<TexturedCorner, 3>& corners, Texel TexturedCorner::*texel) {
    const Texel least = std::min({corners[0].*texel, corners[1].*texel, corners[2].*texel});
    // A texel of margin, so that no rounding is clamped at the surface's edge.
    const Texel base = Texel::from_int(floor_of(least) - 1);
    for (TexturedCorner& corner : corners) corner.*texel = corner.*texel - base;
    return base;
}

struct TexspanQuery {
    ModeAndView view;
    std::array<TexturedCorner, 3> corners;
    Texel base_u, base_v;
    Span span{};
};

TexspanQuery read_query(Fields& fields) {
    TexspanQuery query;
    query.view = fields.mode();
    for (TexturedCorner& corner : query.corners) {
        corner.position = convert<Fixed<std::int32_t, 14>>(fields.point());
        if (corner.position.z <= Fixed<std::int32_t, 14>{}) throw Unsupported{};
        corner.u = fields.texel();
        corner.v = fields.texel();
    }
    query.base_u = rebase(query.corners, &TexturedCorner::u);
    query.base_v = rebase(query.corners, &TexturedCorner::v);
    query.span.y = static_cast<std::int32_t>(fields.integer(0, query.view.mode.height_px - 1));
    query.span.first = static_cast<std::int32_t>(fields.integer(0, query.view.mode.width_px - 1));
    query.span.end = static_cast<std::int32_t>(fields.integer(query.span.first + 1, query.view.mode.width_px));
    fields.expect_end();
    return query;
}

/// The least_density() of a face that shows these texels (engine/scene/face_table.cpp), floored to 2^-15. With edges P
/// and Q from one corner, along which u changes by p and q, u rises by |p Q - q P| / |P x Q| a unit; the ratio of the
/// areas in texels and in units has the same denominator |P x Q|, which cancels.
TexelDensity least_density(const std::array<TexturedCorner, 3>& corners) {
    const auto& [a, b, c] = corners;
    const auto to_b = b.position - a.position, to_c = c.position - a.position;
    const auto change = [](Texel to, Texel from) { return SoftFloat::from(to - from); };
    const SoftFloat u_b = change(b.u, a.u), u_c = change(c.u, a.u), v_b = change(b.v, a.v), v_c = change(c.v, a.v);
    SoftFloat squares;
    for (const auto& [at_b, at_c] : {std::pair{u_b, u_c}, {v_b, v_c}})
        for (const auto& [b_along, c_along] : {std::pair{to_b.x, to_c.x}, {to_b.y, to_c.y}, {to_b.z, to_c.z}}) {
            const SoftFloat part = at_b * SoftFloat::from(c_along) - at_c * SoftFloat::from(b_along);
            squares = squares + part * part;
        }
    if (squares.is_zero()) return {};
    const SoftFloat area = u_b * v_c - u_c * v_b;
    const std::optional<std::int64_t> square = fixed_of(area * area / squares, 30);
    if (!square) return TexelDensity::from_int(1 << 16);
    return TexelDensity::from_raw(std::int64_t{2} * integer_root(static_cast<std::uint64_t>(*square)));
}

/// The view of a frame whose eye is at the origin, the world's axes being those of viewspace.
ViewContext view_of(const Projection& projection) {
    ViewContext view;
    view.axes = view.rays = y_up_basis({}, {}, {});
    view.projection = projection;
    view.frustum = make_frustum(view.axes, projection);
    view.grid = SubpixelGrid::of_bits(Screen::kFractionBits);
    return view;
}

/// The triangle as a frame claims it: the nearest and farthest z of its part in view.
VisibleFace claimed_by_frame(const TexspanQuery& query, const Projection& projection) {
    std::vector<Vec3<World>> corners;
    VisibleFace claimed;
    claimed.nearest_z = View::highest();
    for (const TexturedCorner& corner : query.corners) {
        corners.push_back(convert<World>(corner.position));
        claimed.nearest_z = std::min(claimed.nearest_z, convert<View>(corner.position.z));
        claimed.farthest_z = std::max(claimed.farthest_z, convert<View>(corner.position.z));
    }
    ScreenPolygon polygon;
    if (project_polygon(corners, view_of(projection), polygon))
        std::tie(claimed.nearest_z, claimed.farthest_z) = polygon.z_range();
    return claimed;
}

/// The contents of the row's pixels, recorded from a frame's own drawing. No pixels are written: the surface has no
/// texels.
class RowSampler {
  public:
    RowSampler(const TexspanQuery& query, const Accuracy& accuracy)
        : query_(query),
          accuracy_(accuracy),
          projection_(frame_lens(query.view)),
          claimed_(claimed_by_frame(query, projection_)),
          density_(least_density(query.corners)) {
        // A projection that is not drawable has blocks of single pixels.
        if (is_drawable(projection_)) pixel_width_ = make_inverse_projection(projection_).least_pixel_width;
        surface_.limits = make_texel_limits(65535, 65535, 0);
        surface_.origin_u = static_cast<std::int32_t>(floor_of(query.base_u));
        surface_.origin_v = static_cast<std::int32_t>(floor_of(query.base_v));
        surface_.kernel = [](std::span<const TexelBlock>, const SurfaceView&, std::uint8_t*) {};
        surface_.is_wrapped_by_masks = false;  // so that divided pixels also use that kernel
        record_.pixels.resize(as_size(query.span.end));
    }

    /// Samples a part of the row.
    void sample(const Span& part) {
        const auto exact = make_triangle_gradients(query_.corners, projection_, {(part.first + part.end) / 2, part.y});
        if (!exact) throw Unsupported{};
        const TextureGradients gradients = rounded_to(*exact, accuracy_.inverse_z_bits, accuracy_.over_z_bits);
        SpanScratch scratch(part.end - part.first);
        // With a pitch of 0 every row is the recorded one.
        const Framebuffer out{nullptr, query_.view.mode.width_px, query_.view.mode.height_px, 0};
        const SpanTexturing texturing = make_span_texturing(accuracy_);
        TexturedFace face{claimed_, surface_, {}, {gradients, {}, {}}, {}};
        face.texels_per_pixel = texels_across(claimed_.nearest_z, density_, pixel_width_);
        set_cutting(face, {&part, 1}, texturing);
        draw_textured(face, {&part, 1}, {texturing, out, scratch, {nullptr, &record_, nullptr}});
    }

    std::string text() const {
        std::string text;
        for (std::int32_t column = query_.span.first; column < query_.span.end; ++column) {
            const PixelRecord& pixel = item(record_.pixels, column);
            text += (text.empty() ? "" : " ") + format_fixed(pixel.u) + ' ' + format_fixed(pixel.v);
        }
        return text;
    }

  private:
    const TexspanQuery& query_;
    const Accuracy& accuracy_;
    Projection projection_;
    VisibleFace claimed_;
    TexelDensity density_;
    WidthAtOne pixel_width_;
    FaceSurface surface_;
    FrameRecord record_;
};

std::string sample_span(const TexspanQuery& query, const Accuracy& accuracy) {
    // Gradients lose half a step a pixel away from their anchor. Pixels with their own divisions are sampled in short
    // parts, each with an anchor. Others depend on their neighbours: rows wider than any frame are sampled in parts of
    // a frame's width, affine spans as a whole.
    constexpr std::int32_t kShortPart_px = 512;
    const std::int32_t longest_px = accuracy.texturing == Texturing::Affine  ? query.view.mode.width_px
                                    : accuracy.texturing == Texturing::Exact ? kShortPart_px
                                                                             : kLargestMode_px;
    RowSampler sampler(query, accuracy);
    for (std::int32_t first = query.span.first; first < query.span.end; first += longest_px)
        sampler.sample({query.span.y, first, std::min(first + longest_px, query.span.end)});
    return sampler.text();
}

}  // namespace

std::string answer_texspan(Fields& fields, const Accuracy& accuracy) {
    Accuracy exact = accuracy;
    exact.texturing = Texturing::Exact;
    return sample_span(read_query(fields), exact);
}

std::string answer_texspanq(Fields& fields, const Accuracy& accuracy) {
    const std::string_view name = fields.text();
    for (const DialSetting& setting : dial_named("perspective")->settings) {
        if (name != setting.name) continue;
        Accuracy named = accuracy;
        named.texturing = static_cast<Texturing>(setting.value);
        return sample_span(read_query(fields), named);
    }
    throw Unsupported{};
}

std::string answer_modes(Fields& fields, const Accuracy&) {
    fields.expect_end();
    const std::span<const DialSetting> settings = dial_named("perspective")->settings;
    std::string text;
    for (auto setting = settings.rbegin(); setting != settings.rend(); ++setting)
        text += (text.empty() ? "" : " ") + std::string(setting->name);
    return text;
}

}  // namespace oblong
