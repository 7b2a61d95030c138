#pragma once

#include <chrono>
#include <cstddef>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "engine/base/workers.h"

namespace oblong::map {

/// Receives the progress of long work, always in the thread that began it.
class Progress {
  public:
    virtual ~Progress() = default;
    virtual void begin(const char* stage, std::size_t steps) = 0;
    virtual void step(std::size_t steps) = 0;  ///< `steps` more are done
};

/// Shares items of work among threads. The result does not depend on the number of threads.
class WorkSharing {
  public:
    /// Either may be null; without workers the caller does all work, in order.
    WorkSharing(Workers* workers, Progress* progress) : workers_(workers), progress_(progress) {}

    /// Begins a stage of `items` items, in one or more for_each().
    void begin(const char* stage, std::size_t items) const {
        if (progress_ != nullptr) progress_->begin(stage, items);
    }

    /// Calls do_item(0) to do_item(count - 1), each once, in any order, several at a time. After all have ended,
    /// rethrows the exception of the failed item with the lowest number.
    void for_each(std::size_t count, const std::function<void(std::size_t)>& do_item) const;

  private:
    Workers* workers_;
    Progress* progress_;
};

/// Shows a program's progress and its stage's remaining seconds on standard error: from its second second on, on a
/// terminal as one line that is overwritten, else as a line every five seconds.
class ProgressLine final : public Progress {
  public:
    explicit ProgressLine(std::string program);
    ~ProgressLine() override { clear(); }

    void begin(const char* stage, std::size_t steps) override;
    void step(std::size_t steps) override;
    void clear();  ///< removes the line before other output

    /// "tree 0.3 s, visibility 2.1 s, light 4.0 s": the times of the stages; ends the last one.
    std::string times();

  private:
    void end_stage();

    std::chrono::steady_clock::time_point start_, stage_start_, last_shown_;
    std::string program_;
    std::vector<std::pair<std::string, double>> times_;  // stages, seconds
    std::string stage_;
    std::size_t steps_ = 1, done_ = 0;
    bool is_terminal_, is_shown_ = false;
};

}  // namespace oblong::map
