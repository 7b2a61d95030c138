#include "tools/accuracy/measured_level.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "engine/base/input_error.h"
#include "engine/level/bsp_read.h"
#include "engine/visibility/eye.h"
#include "tools/accuracy/configurations.h"

namespace oblong {

MeasuredLevel make_measured_level(const std::string& name, const std::string& about, std::span<const std::uint8_t> file,
                                  std::vector<Camera> cameras) {
    MeasuredLevel measured{name, about, read_bsp(file), {}, {}, std::move(cameras)};
    try {
        measured.exact = reference::read_level(file);
    } catch (const std::runtime_error& error) {  // not refused by the engine's reader
        throw InputError("the reference's reading", error.what());
    }
    measured.models = models_at_rest(measured.level);
    for (std::size_t i = 0; i < measured.cameras.size(); ++i) {
        const PlacedEye eye = place_eye(measured.level, measured.cameras[i].eye);
        if (measured.level.leaves[eye.leaf].contents == contents::kSolid)
            throw InputError("camera " + std::to_string(i + 1), "in a wall or outside, expected an eye in the open");
        measured.cameras[i].eye = eye.position;
    }
    return measured;
}

LevelFrames::LevelFrames(const MeasuredLevel& level, const Colormap& colormap)
    : level_(level), colormap_(colormap), pixels_(pixel_count(kMeasuredMode.width_px, kMeasuredMode.height_px)) {}

FrameWorkspace& LevelFrames::workspace_for(const Accuracy& accuracy) {
    const auto known = std::find_if(lightings_.begin(), lightings_.end(), [&](const Lighting& lighting) {
        return has_same_surfaces(lighting.accuracy, accuracy);
    });
    if (known != lightings_.end()) return *known->work;
    lightings_.push_back({accuracy, std::make_unique<FrameWorkspace>(level_.level, kMeasuredMode)});
    return *lightings_.back().work;
}

void LevelFrames::draw(const Camera& camera, const Accuracy& accuracy, EffectSet effects) {
    Settings settings;
    settings.accuracy = accuracy;
    settings.allowed_effects = effects;
    settings.correct_aspect = corrects_aspect_;
    const Framebuffer out{pixels_.data(), kMeasuredMode.width_px, kMeasuredMode.height_px, kMeasuredMode.width_px};
    draw_frame({level_.level, colormap_, level_.models}, camera, kMeasuredMode, settings, workspace_for(accuracy), out);
}

void LevelFrames::forget_surfaces(const Accuracy& accuracy) {
    workspace_for(accuracy).cache.surfaces.clear();
}

const FrameRecord& LevelFrames::record(const Camera& camera, const Accuracy& accuracy) {
    FrameWorkspace& work = workspace_for(accuracy);
    work.observers.record = &record_;
    draw(camera, accuracy);
    work.observers.record = nullptr;
    return record_;
}

FrameCounts LevelFrames::count(const Camera& camera, const Accuracy& accuracy) {
    FrameWorkspace& work = workspace_for(accuracy);
    FrameCounts counts;
    work.observers.counts = &counts;
    draw(camera, accuracy);
    work.observers.counts = nullptr;
    return counts;
}

}  // namespace oblong
