#pragma once

#include <cstddef>
#include <functional>

#include "engine/base/workers.h"

namespace oblong::map {

/// Receives a compilation's progress, always in the thread that compiles.
class CompileProgress {
  public:
    virtual ~CompileProgress() = default;
    virtual void begin(const char* stage, std::size_t steps) = 0;
    virtual void step(std::size_t steps) = 0;  ///< `steps` more are done
};

/// Shares items of work among threads. The result does not depend on the number of threads.
class WorkSharing {
  public:
    /// Either may be null; without workers the caller does all work.
    WorkSharing(Workers* workers, CompileProgress* progress) : workers_(workers), progress_(progress) {}

    /// Begins a stage of `items` items, in one or more for_each().
    void begin(const char* stage, std::size_t items) const {
        if (progress_ != nullptr) progress_->begin(stage, items);
    }

    /// Calls do_item(0) to do_item(count - 1), each once, in any order, several at a time. After all have ended,
    /// rethrows the exception of the failed item with the lowest number.
    void for_each(std::size_t count, const std::function<void(std::size_t)>& do_item) const;

  private:
    Workers* workers_;
    CompileProgress* progress_;
};

}  // namespace oblong::map
