#include "tools/accuracy/progress.h"

#include <cstdio>

namespace oblong {

Progress::~Progress() {
    if (shown_ >= 0) std::fputc('\n', stderr);
}

void Progress::begin(const std::string& what, std::size_t steps, int from, int to) {
    what_ = what;
    steps_ = steps == 0 ? 1 : steps;
    done_ = 0;
    from_ = from;
    to_ = to;
    shown_ = -1;
    show();
}

void Progress::step() {
    ++done_;
    show();
}

void Progress::show() {
    const int percent = from_ + static_cast<int>(done_ * static_cast<std::size_t>(to_ - from_) / steps_);
    if (!is_shown_ || percent == shown_) return;
    shown_ = percent;
    constexpr const char* kBar = "#########################";
    std::fprintf(stderr, "\r[%-25.*s] %3d %% %-40s", percent / 4, kBar, percent, what_.c_str());
    std::fflush(stderr);
}

}  // namespace oblong
