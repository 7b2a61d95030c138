#include <algorithm>
#include <array>
#include <string>

#include "engine/accuracy/dials.h"
#include "engine/geometry/triangle_gradients.h"
#include "engine/raster/texture_blocks.h"
#include "tools/probe/decimal.h"
#include "tools/probe/queries.h"

namespace oblong {

namespace {

/// A texture coordinate of the three corners, moved by whole texels to where surfaces begin: at 0.
struct RebasedTexels {
    Texel base;
    std::array<Texel, 3> moved;

    explicit RebasedTexels(const std::array<Texel, 3>& texels) {
        // A texel of margin, so that no rounding is clamped at the surface's edge.
        base = Texel::from_int(floor_of(*std::min_element(texels.begin(), texels.end())) - 1);
        for (std::size_t i = 0; i < 3; ++i) moved[i] = texels[i] - base;
    }
};

struct TexspanQuery {
    ModeAndView view;
    std::array<TexturedCorner, 3> corners;
    Texel base_u, base_v;
    Span span{};
};

TexspanQuery read_query(Fields& fields) {
    TexspanQuery query;
    query.view = fields.mode();
    std::array<Texel, 3> u_texels, v_texels;
    for (std::size_t i = 0; i < 3; ++i) {
        query.corners[i].position = convert<Fixed<std::int32_t, 14>>(fields.point());
        if (query.corners[i].position.z <= Fixed<std::int32_t, 14>{}) throw Unsupported{};
        u_texels[i] = fields.texel();
        v_texels[i] = fields.texel();
    }
    const RebasedTexels u(u_texels), v(v_texels);
    for (std::size_t i = 0; i < 3; ++i) {
        query.corners[i].u = u.moved[i];
        query.corners[i].v = v.moved[i];
    }
    query.base_u = u.base;
    query.base_v = v.base;
    query.span.y = static_cast<std::int32_t>(fields.integer(0, query.view.mode.height_px - 1));
    query.span.first = static_cast<std::int32_t>(fields.integer(0, query.view.mode.width_px - 1));
    query.span.end = static_cast<std::int32_t>(fields.integer(query.span.first + 1, query.view.mode.width_px));
    fields.expect_end();
    return query;
}

void append_texels(const TexelBlock& block, const TexspanQuery& query, std::string& text) {
    for (std::int64_t i = 0; i < block.count; ++i) {
        if (!text.empty()) text += ' ';
        text += format_fixed(query.base_u + Texel::from_raw(block.u_16 + i * block.u_step_16)) + ' ';
        text += format_fixed(query.base_v + Texel::from_raw(block.v_16 + i * block.v_step_16));
    }
}

/// Samples a part of the row that the query asks for.
void append_part(const TexspanQuery& query, const Projection& projection, const Span& part, const Accuracy& accuracy,
                 std::string& text) {
    const PixelPosition middle{(part.first + part.end) / 2, part.y};
    const auto exact = make_triangle_gradients(query.corners, projection, middle);
    if (!exact) throw Unsupported{};
    const TextureGradients gradients = rounded_to(*exact, accuracy.inverse_z_bits, accuracy.over_z_bits);
    const BlockRule rule = make_block_rule(accuracy);
    const BlockThresholds thresholds = make_block_thresholds(rule, gradients.inverse_z.per_column);
    BlockList blocks(part.end - part.first);
    block_cutter(accuracy)({&part, 1}, query.view.mode.width_px,
                           {gradients, make_texel_limits(65535, 65535, 0), thresholds, rule.texel_bound_256}, blocks);
    for (const TexelBlock& block : blocks.waiting()) append_texels(block, query, text);
}

std::string sample_span(const TexspanQuery& query, const Accuracy& accuracy) {
    // Gradients lose half a step a pixel away from their anchor. Rows wider than any frame's are sampled in parts with
    // an anchor each; an affine span has to stay whole.
    constexpr std::int32_t kLongestPart_px = 512;
    const std::int32_t longest_px =
        accuracy.texturing == Texturing::Affine ? query.view.mode.width_px : kLongestPart_px;
    const Projection projection = frame_lens(query.view);
    std::string text;
    for (std::int32_t first = query.span.first; first < query.span.end; first += longest_px)
        append_part(query, projection, {query.span.y, first, std::min(first + longest_px, query.span.end)}, accuracy,
                    text);
    return text;
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

std::string answer_modes(Fields& fields) {
    fields.expect_end();
    const std::span<const DialSetting> settings = dial_named("perspective")->settings;
    std::string text;
    for (auto setting = settings.rbegin(); setting != settings.rend(); ++setting)
        text += (text.empty() ? "" : " ") + std::string(setting->name);
    return text;
}

}  // namespace oblong
