#include "tools/map/work_sharing.h"

#include <atomic>
#include <exception>
#include <mutex>

namespace oblong::map {
namespace {

class Items final : public SharedWork {
  public:
    Items(const std::function<void(std::size_t)>& do_item, CompileProgress* progress)
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
    CompileProgress* progress_;
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

}  // namespace oblong::map
