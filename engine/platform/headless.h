#pragma once

#include <functional>
#include <utility>

#include "engine/platform/platform.h"

namespace oblong {

/// A platform without a screen: scripted input, a clock that advances one tick a poll, frames passed to a callback.
class HeadlessPlatform final : public Platform {
  public:
    /// The input at each poll, counted from 0.
    using Script = std::function<PlatformInput(std::int64_t poll)>;
    using FrameSink = std::function<void(Framebuffer, const Palette&)>;

    /// Open for `frames` pictures. Its clock advances 1/`polls_per_second` s a poll (rounded up to the microsecond, so
    /// that poll n is never before tick n).
    HeadlessPlatform(std::int64_t frames, std::int64_t polls_per_second, Script script, FrameSink sink)
        : frames_(frames), polls_per_second_(polls_per_second), script_(std::move(script)), sink_(std::move(sink)) {}

    bool is_open() const override { return presented_ < frames_; }
    PlatformInput poll() override { return script_(polls_++); }
    std::uint64_t now_us() override {
        return static_cast<std::uint64_t>((polls_ * 1'000'000 + polls_per_second_ - 1) / polls_per_second_);
    }
    WindowSize window_size() const override { return {1600, 1200}; }
    void set_title(const char*) override {}
    void present(Framebuffer picture, const Palette& palette, const PresentRect&) override {
        ++presented_;
        sink_(picture, palette);
    }

  private:
    std::int64_t frames_, polls_per_second_;
    std::int64_t polls_ = 0, presented_ = 0;
    Script script_;
    FrameSink sink_;
};

}  // namespace oblong
