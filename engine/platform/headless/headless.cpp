#include "engine/platform/headless/headless.h"

#include <utility>

namespace oblong {

HeadlessPlatform::HeadlessPlatform(std::int64_t frames, std::int64_t polls_per_second, Script script, FrameSink sink)
    : frames_(frames), polls_per_second_(polls_per_second), script_(std::move(script)), sink_(std::move(sink)) {}

std::uint64_t HeadlessPlatform::now_us() {
    return static_cast<std::uint64_t>((polls_ * 1'000'000 + polls_per_second_ - 1) / polls_per_second_);
}

void HeadlessPlatform::present(Framebuffer picture, const Palette& palette, const PresentRect&) {
    ++presented_;
    sink_(picture, palette);
}

}  // namespace oblong
