#include <exception>
#include <utility>

#include "engine/frame/frame_record.h"
#include "engine/io/files.h"
#include "engine/measure/texel_error.h"
#include "engine/reference/level.h"
#include "engine/view/views.h"
#include "game/lab/error_meter.h"

namespace oblong {
namespace {

// Adds the models that own pixels.
void note_in_sight(const FrameRecord& record, std::size_t models, std::vector<bool>& in_sight) {
    in_sight.resize(models);
    for (const PixelRecord& pixel : record.pixels)
        if (!pixel.model.is_none()) in_sight[as_size(pixel.model.number())] = true;
}

// Whether those in sight are where they were.
bool stand_still(std::span<const PlacedModel> before, std::span<const PlacedModel> now,
                 const std::vector<bool>& in_sight) {
    if (before.size() != now.size()) return false;
    for (std::size_t i = 0; i < now.size(); ++i)
        if (in_sight[i] && before[i] != now[i]) return false;
    return true;
}

class ReferenceMeter final : public ErrorMeter {
  public:
    ReferenceMeter(const std::string& level_file, const GameLevel& level) : level_(level) {
        try {
            reference_ = reference::read_level(read_file(level_file));
        } catch (const std::exception& error) {
            problem_ = error.what();
        }
    }

    std::string problem_of(const GameView& view) const override {
        return problem_.empty() && view.other ? "only the player's own view is measured" : problem_;
    }

    std::vector<TexelError> measure(const GameView& view, const Settings& settings, GameRenderer& renderer) override {
        if (!problem_of(view).empty()) return {};
        const std::vector<PlacedModel> models = placed_models(level_, view.state);
        TexelErrorMeter meter(reference_, models, view.camera, renderer.mode(), settings.correct_aspect);
        return meter.measure(renderer.draw_and_record(view, settings));
    }

    std::optional<std::int64_t> count_wrong_faces(const GameView& view, const Settings& settings,
                                                  GameRenderer& renderer) override {
        if (!problem_of(view).empty()) return std::nullopt;
        std::vector<PlacedModel> models = placed_models(level_, view.state);
        const ViewSpec shown = first_person_view(view.camera, SineMethod::NearestStep);
        const FrameRecord record = renderer.draw_and_record(view, settings);
        note_in_sight(record, models.size(), in_sight_);
        if (view_ != shown || !stand_still(models_, models, in_sight_) || corrects_aspect_ != settings.correct_aspect) {
            view_ = shown;
            models_ = std::move(models);
            in_sight_.clear();
            corrects_aspect_ = settings.correct_aspect;
            faces_.clear();
            return std::nullopt;
        }
        if (faces_.empty()) faces_ = true_faces(reference_, models, view.camera, renderer.mode(), corrects_aspect_);
        return wrong_faces(record, faces_);
    }

  private:
    const GameLevel& level_;
    reference::Level reference_;
    std::string problem_;  // with the file
    // Of the last call of count_wrong_faces().
    ViewSpec view_;
    std::vector<PlacedModel> models_;
    std::vector<bool> in_sight_;  // of these, since the view is this one
    bool corrects_aspect_ = false;
    std::vector<std::int32_t> faces_;  // that pixels should show; empty: not found yet
};

}  // namespace

std::unique_ptr<ErrorMeter> open_reference_meter(const std::string& level_file, const GameLevel& level) {
    return std::make_unique<ReferenceMeter>(level_file, level);
}

}  // namespace oblong
