#pragma once

#include "engine/platform/platform.h"

namespace oblong::test {

/// A platform for tests to override what they ask of it: nobody is there, and nothing is seen.
struct SilentPlatform : Platform {
    bool is_open() const override { return true; }
    PlatformInput poll() override { return {}; }
    std::uint64_t now_us() override { return 0; }
    WindowSize window_size() const override { return {}; }
    void set_title(const char*) override {}
    void present(Framebuffer, const Palette&, const PresentRect&) override {}
};

}  // namespace oblong::test
