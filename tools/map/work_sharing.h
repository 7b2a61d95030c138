#pragma once

#include <cstddef>
#include <functional>

#include "engine/base/workers.h"

namespace oblong::map {

/// Is told how far a compilation is, always by the thread that compiles.
class CompileProgress {
  public:
    virtual ~CompileProgress() = default;
    virtual void begin(const char* stage, std::size_t steps) = 0;
    virtual void step(std::size_t steps) = 0;  ///< that many more are done
};

/// Shares work in items among threads. What is made does not depend on how many there are.
class WorkSharing {
  public:
    /// Without workers the caller does all; either may be null.
    WorkSharing(Workers* workers, CompileProgress* progress) : workers_(workers), progress_(progress) {}

    /// A stage of so many items, of one for_each() or several.
    void begin(const char* stage, std::size_t items) const {
        if (progress_ != nullptr) progress_->begin(stage, items);
    }

    /// Calls do_item(0) to do_item(count - 1), each once, in any order, several at a time. Throws what the
    /// first of them in that order threw, after all have ended.
    void for_each(std::size_t count, const std::function<void(std::size_t)>& do_item) const;

  private:
    Workers* workers_;
    CompileProgress* progress_;
};

}  // namespace oblong::map
