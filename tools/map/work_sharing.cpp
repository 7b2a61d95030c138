#include "tools/map/work_sharing.h"

#include <atomic>
#include <cstdio>
#include <exception>
#include <mutex>

#include "engine/io/system.h"

namespace oblong::map {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point time) {
    return std::chrono::duration<double>(Clock::now() - time).count();
}

class Items final : public SharedWork {
  public:
    Items(const std::function<void(std::size_t)>& do_item, Progress* progress)
        : do_item_(do_item), progress_(progress) {}

    void do_item(std::uint32_t item, int worker) override {
        try {
            do_item_(item);
        } catch (...) {
            const std::lock_guard lock(mutex_);
            if (!error_ || item < failed_) {
                error_ = std::current_exception();
                failed_ = item;
            }
        }
        ++done_;
        if (worker == 0) tell();
    }

    void finish() {
        tell();
        if (error_) std::rethrow_exception(error_);
    }

  private:
    void tell() {
        const std::size_t done = done_;
        if (progress_ != nullptr && done > told_) progress_->step(done - told_);
        told_ = done;
    }

    const std::function<void(std::size_t)>& do_item_;
    Progress* progress_;
    std::atomic<std::size_t> done_ = 0;
    std::size_t told_ = 0;
    std::mutex mutex_;  // guards error_ and failed_
    std::uint32_t failed_ = 0;
    std::exception_ptr error_;
};

}  // namespace

void WorkSharing::for_each(std::size_t count, const std::function<void(std::size_t)>& do_item) const {
    Items items(do_item, progress_);
    if (workers_ == nullptr) {
        for (std::size_t i = 0; i < count; ++i) items.do_item(static_cast<std::uint32_t>(i), 0);
    } else {
        workers_->begin(items);
        for (std::size_t i = 0; i < count; ++i) workers_->add_item();
        workers_->finish_items();
        workers_->end();
    }
    items.finish();
}

ProgressLine::ProgressLine(std::string program)
    : start_(Clock::now()), program_(std::move(program)), is_terminal_(is_shown_on_terminal()) {
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
    std::fprintf(stderr, "%s%s: %s %3.0f %%, %.0f s left%s", is_terminal_ ? "\r" : "", program_.c_str(), stage_.c_str(),
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
    if (times_.empty() || times_.back().first != stage_) times_.emplace_back(stage_, 0);
    times_.back().second += seconds_since(stage_start_);
}

std::string ProgressLine::times() {
    end_stage();
    std::string text;
    for (const auto& [stage, seconds] : times_) {
        char number[32];
        std::snprintf(number, sizeof number, " %.1f s", seconds);
        text += (text.empty() ? "" : ", ") + stage + number;
    }
    stage_.clear();
    return text;
}

}  // namespace oblong::map
