#include <memory>
#include <vector>

#include "engine/accuracy/accuracy.h"
#include "engine/frame/surface_pass.h"
#include "engine/raster/exact_spans.h"
#include "engine/view/view_context.h"
#include "engine/view/views.h"
#include "engine/visibility/eye.h"
#include "tools/bench/benchmarks.h"

namespace oblong {
namespace {

/// A face that owns pixels of a frame, as input for texturing, without a cutting.
struct TexturedInput {
    std::vector<Span> spans;
    TexturedFace face;
};

/// The input of each stage of a frame; only of the world's faces, without doors and lifts.
struct StageInputs {
    ViewContext view;
    LeafIndex leaf;                                   ///< of the eye
    std::vector<FaceIndex> visited;                   ///< returned by the walk
    std::vector<std::vector<ScreenVertex>> polygons;  ///< of the visited faces in view
    std::vector<ScanlineExtents> rows;                ///< of the polygons
    std::vector<TexturedInput> walls;                 ///< the faces that own pixels and have a surface
    std::int64_t pixels = 0;                          ///< of the walls
};

/// Collects the faces of a frame until no pixel is free, with the results of each stage.
void collect_geometry(const BenchLevel& level, FrameWorkspace& work, StageInputs& inputs) {
    work.view.visible.see_from(level.level, inputs.leaf);
    work.view.claiming->vertices.start_frame();
    work.view.claiming->span_buffer.reset();
    SpanList owned;
    FrontToBackWalk walk(level.level, inputs.view, work.view.visible, nullptr, work.view.claiming->span_buffer,
                         work.view.claiming->walk);
    VisibleFace visible;
    while (walk.next(visible)) {
        inputs.visited.push_back(visible.face);
        if (!project_face(work.cache.faces.corners_of(visible.face), inputs.view, work.view.claiming->vertices,
                          work.view.claiming->polygon))
            continue;
        scan_convex(work.view.claiming->polygon.vertices, work.view.claiming->rows);
        work.view.claiming->span_buffer.claim(work.view.claiming->rows, owned);
        inputs.polygons.emplace_back(work.view.claiming->polygon.vertices.begin(),
                                     work.view.claiming->polygon.vertices.end());
        inputs.rows.push_back(work.view.claiming->rows);
    }
}

/// Collects the walls of the last frame drawn in the workspace.
void collect_walls(const BenchLevel& level, FrameWorkspace& work, StageInputs& inputs) {
    const InverseProjection inverse_projection = make_inverse_projection(inputs.view.projection);
    for (const VisibleFace& claimed : work.view.claims.list(FaceList::Walls)) {
        const FaceIndex face = claimed.face;
        const auto spans = work.view.claims.spans_of(claimed);
        const Vec3<World> offset = work.cache.brush_models.offset_of(claimed.fragment);
        const int mip = work.cache.surfaces.mip_level(face, claimed.nearest_z, inputs.view.projection.x, 0);
        TexturedInput wall{{spans.begin(), spans.end()}, {claimed, {}, {}, {}, {}}};
        wall.face.surface = work.cache.surfaces.get(face, mip, {work.view.light.styles, TextureIndex::none(), offset});
        wall.face.cutting.gradients = make_face_gradients(level.level, level.level.faces[face], wall.face.surface,
                                                          offset, claimed.inverse_z, inputs.view, inverse_projection);
        wall.face.texels_per_pixel =
            texels_across(claimed.nearest_z, convert<TexelDensity>(work.cache.faces[face].least_density),
                          inverse_projection.least_pixel_width);
        inputs.walls.push_back(std::move(wall));
        for (const Span& span : spans) inputs.pixels += span.end - span.first;
    }
}

/// The stages' inputs for a camera's frame. The walls' texels are in `work`.
StageInputs collect_stage_inputs(const BenchLevel& level, const Camera& camera, const ScreenMode& mode,
                                 FrameWorkspace& work) {
    ViewSpec spec = first_person_view(camera);
    const PlacedEye eye = place_eye(level.level, spec.eye);
    spec.eye = eye.position;
    StageInputs inputs;
    inputs.view = make_view_context(spec, mode);
    inputs.leaf = eye.leaf;

    std::vector<std::uint8_t> pixels(pixel_count(mode.width_px, mode.height_px));
    draw_frame(level.scene(), camera, mode, {}, work, {pixels.data(), mode.width_px, mode.height_px, mode.width_px});
    collect_walls(level, work, inputs);
    collect_geometry(level, work, inputs);
    return inputs;
}

/// The stages' inputs for some cameras of a level; one iteration of a benchmark does one stage of all frames.
struct StageFrames {
    const BenchLevel& level;
    ScreenMode mode;
    FrameWorkspace work;
    std::vector<StageInputs> frames;
    std::vector<std::uint8_t> pixels;

    StageFrames(const BenchLevel& of_level, const ScreenMode& of_mode)
        : level(of_level),
          mode(of_mode),
          work(of_level.level, of_mode),
          pixels(pixel_count(of_mode.width_px, of_mode.height_px)) {
        constexpr std::size_t kMostCameras = 12;
        const std::size_t step = (level.cameras.size() + kMostCameras - 1) / kMostCameras;
        for (std::size_t i = 0; i < level.cameras.size(); i += step)
            frames.push_back(collect_stage_inputs(level, level.cameras[i], mode, work));
    }

    Framebuffer out() { return {pixels.data(), mode.width_px, mode.height_px, mode.width_px}; }
    /// The sum of size_of(frame) over all frames.
    template <class Size>
    std::int64_t sum(Size size_of) const {
        std::int64_t total = 0;
        for (const StageInputs& frame : frames) total += static_cast<std::int64_t>(size_of(frame));
        return total;
    }
};

using SharedFrames = std::shared_ptr<StageFrames>;

/// The tree with no pixel claimed: all faces in view that are potentially visible from the eye's leaf.
void time_walk(benchmark::State& state, const SharedFrames& stages) {
    FrameWorkspace& work = stages->work;
    std::int64_t faces = 0;
    for (auto _ : state) {
        faces = 0;
        for (const StageInputs& frame : stages->frames) {
            work.view.visible.see_from(stages->level.level, frame.leaf);
            work.view.claiming->span_buffer.reset();
            FrontToBackWalk walk(stages->level.level, frame.view, work.view.visible, nullptr,
                                 work.view.claiming->span_buffer, work.view.claiming->walk);
            VisibleFace face;
            while (walk.next(face) && !walk.is_second_walk()) ++faces;
        }
    }
    show_time_per("face", faces, state);
}

void time_polygons(benchmark::State& state, const SharedFrames& stages) {
    FrameWorkspace& work = stages->work;
    for (auto _ : state)
        for (const StageInputs& frame : stages->frames) {
            work.view.claiming->vertices.start_frame();
            for (const FaceIndex face : frame.visited)
                benchmark::DoNotOptimize(project_face(work.cache.faces.corners_of(face), frame.view,
                                                      work.view.claiming->vertices, work.view.claiming->polygon));
        }
    show_time_per("face", stages->sum([](const StageInputs& frame) { return frame.visited.size(); }), state);
}

void time_scan(benchmark::State& state, const SharedFrames& stages) {
    for (auto _ : state)
        for (const StageInputs& frame : stages->frames)
            for (const auto& polygon : frame.polygons) scan_convex(polygon, stages->work.view.claiming->rows);
    show_time_per("face", stages->sum([](const StageInputs& frame) { return frame.polygons.size(); }), state);
}

void time_coverage(benchmark::State& state, const SharedFrames& stages) {
    SpanBuffer& buffer = stages->work.view.claiming->span_buffer;
    SpanList owned;
    std::int64_t spans = 0;
    for (auto _ : state) {
        spans = 0;
        for (const StageInputs& frame : stages->frames) {
            buffer.reset();
            owned.clear();
            for (const ScanlineExtents& rows : frame.rows) buffer.claim(rows, owned);
            spans += std::ssize(owned);
        }
    }
    show_time_per("face", stages->sum([](const StageInputs& frame) { return frame.rows.size(); }), state);
    show_time_per("span", spans, state);
}

/// Draws nothing, so that only cutting spans into blocks is timed.
void drop_blocks(std::span<const TexelBlock> blocks, const EffectTexels&, std::uint8_t*) {
    benchmark::DoNotOptimize(blocks.data());
}

void time_spans(benchmark::State& state, const SharedFrames& stages, Preset preset, EffectKernel kernel) {
    const SpanTexturing texturing = make_span_texturing(accuracy_of(preset));
    SpanScratch scratch(stages->mode.width_px);
    for (auto _ : state)
        for (const StageInputs& frame : stages->frames)
            for (const TexturedInput& wall : frame.walls) {
                TexturedFace face = wall.face;
                face.effect.kernel = kernel;
                set_cutting(face, wall.spans, texturing);
                draw_textured(face, wall.spans, {texturing, stages->out(), scratch});
            }
    show_time_per("pixel", stages->sum([](const StageInputs& frame) { return frame.pixels; }), state);
}

void time_exact_spans(benchmark::State& state, const SharedFrames& stages) {
    for (auto _ : state)
        for (const StageInputs& frame : stages->frames)
            for (const TexturedInput& wall : frame.walls)
                draw_exact_spans(wall.spans, wall.face.cutting, wall.face.surface.view, &best_kernels(), stages->out());
    show_time_per("pixel", stages->sum([](const StageInputs& frame) { return frame.pixels; }), state);
}

}  // namespace

void register_stage_benchmarks(const BenchLevel& level, const ScreenMode& mode) {
    const auto stages = std::make_shared<StageFrames>(level, mode);
    benchmark::RegisterBenchmark("stage/walk", time_walk, stages);
    benchmark::RegisterBenchmark("stage/transform_clip_project", time_polygons, stages);
    benchmark::RegisterBenchmark("stage/edge_scan", time_scan, stages);
    benchmark::RegisterBenchmark("stage/coverage", time_coverage, stages);
    for (const Preset preset : {Preset::Year1996, Preset::Bounded}) {
        const std::string name(name_of(preset));
        benchmark::RegisterBenchmark(("stage/span_cutting/" + name).c_str(), time_spans, stages, preset, drop_blocks);
        benchmark::RegisterBenchmark(("stage/spans/" + name).c_str(), time_spans, stages, preset, nullptr);
    }
    benchmark::RegisterBenchmark("stage/spans/exact", time_exact_spans, stages);
}

}  // namespace oblong
