#include "tools/map/work_sharing.h"

#include <atomic>
#include <exception>
#include <mutex>

namespace oblong::map {
namespace {

class Items final : public SharedWork {
  public:
    Items(std::size_t count, const std::function<void(std::size_t)>& do_item, CompileProgress* progress)
        : count_(count), do_item_(do_item), progress_(progress) {}

    bool do_part(int worker) override {
        if (next_ >= count_) return false;
        const std::size_t item = next_++;
        if (item >= count_) return false;
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
        return true;
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

    const std::size_t count_;
    std::atomic<std::size_t> next_ = 0;
    const std::function<void(std::size_t)>& do_item_;
    CompileProgress* progress_;
    std::atomic<std::size_t> done_ = 0;
    std::size_t told_ = 0;
    std::mutex mutex_;  // guards error_ and failed_
    std::size_t failed_ = 0;
    std::exception_ptr error_;
};

}  // namespace

void WorkSharing::for_each(std::size_t count, const std::function<void(std::size_t)>& do_item) const {
    Items items(count, do_item, progress_);
    if (workers_ == nullptr) {
        while (items.do_part(0)) {
        }
    } else {
        workers_->begin(items);
        workers_->end();
    }
    items.finish();
}

}  // namespace oblong::map
