#pragma once

#include <functional>
#include <utility>

#include "engine/platform/platform.h"
#include "game/simulation/tick.h"
#include "tests/support/scripted_input.h"

namespace oblong::test {

/// A platform without a screen that is open for so many polls. Its clock advances a tick of the game a poll; what is
/// presented is not kept.
class ScriptedPlatform : public Platform {
  public:
    using Script = std::function<PlatformInput(std::int64_t poll)>;

    ScriptedPlatform(std::int64_t polls, Script script) : most_polls_(polls), script_(std::move(script)) {}

    bool is_open() const override { return polls_ < most_polls_; }
    PlatformInput poll() override { return script_(polls_++); }
    // A tick is 28,571.4 us: whenever the game begins, each poll is one, until what is rounded up makes another.
    std::uint64_t now_us() override { return static_cast<std::uint64_t>(polls_) * 28'572; }
    WindowSize window_size() const override { return {640, 400}; }
    void set_title(const char*) override {}
    void present(Framebuffer, const Palette&, const PresentRect&) override {}

  private:
    const std::int64_t most_polls_;
    std::int64_t polls_ = 0;
    Script script_;
};

/// A press of Enter, or of a gamepad's A, in a menu.
inline PlatformInput accept() {
    Controls controls;
    controls.menu.push_back(MenuAction::Accept);
    return scripted_input(controls);
}

}  // namespace oblong::test
