#include "tools/map/progress_line.h"

#include <unistd.h>

#include <cstdio>

namespace oblong::map {

ProgressLine::ProgressLine() : start_(Clock::now()), is_terminal_(isatty(STDERR_FILENO) != 0) {
    stage_start_ = last_shown_ = start_;
}

void ProgressLine::begin(const char* stage, std::size_t steps) {
    end_stage();
    stage_ = stage;
    steps_ = steps == 0 ? 1 : steps;
    done_ = 0;
    stage_start_ = Clock::now();
}

void ProgressLine::step(std::size_t steps) {
    done_ += steps;
    const bool is_due = seconds_since(last_shown_) > (is_terminal_ ? 0.2 : 5);
    if (!is_due || seconds_since(start_) < 1) return;
    last_shown_ = Clock::now();
    const double share = static_cast<double>(done_) / static_cast<double>(steps_);
    std::fprintf(stderr, "%soblong-map: %s %3.0f %%, %.0f s left%s", is_terminal_ ? "\r" : "", stage_.c_str(),
                 share * 100, seconds_since(stage_start_) * (1 / share - 1), is_terminal_ ? "\x1b[K" : "\n");
    std::fflush(stderr);
    is_shown_ = true;
}

void ProgressLine::clear() {
    if (is_terminal_ && is_shown_) std::fputs("\r\x1b[K", stderr);
    is_shown_ = false;
}

void ProgressLine::end_stage() {
    if (stage_.empty()) return;
    const double seconds = seconds_since(stage_start_);
    if (times_.empty() || times_.back().stage != stage_)
        times_.push_back({stage_, seconds});
    else
        times_.back().seconds += seconds;
}

std::string ProgressLine::times() {
    end_stage();
    std::string text;
    for (const StageTime& time : times_) {
        char seconds[32];
        std::snprintf(seconds, sizeof seconds, " %.1f s", time.seconds);
        text += (text.empty() ? "" : ", ") + time.stage + seconds;
    }
    stage_.clear();
    return text;
}

double ProgressLine::seconds_since(Clock::time_point time) {
    return std::chrono::duration<double>(Clock::now() - time).count();
}

}  // namespace oblong::map
