#include "engine/platform/worker_threads.h"

#include <system_error>

namespace oblong {

namespace {

/// Polling that now and then yields the processor.
class Lookout {
  public:
    void wait() {
        if (++looks_ % kLooksPerTurn == 0) std::this_thread::yield();
    }
    /// Whether it has waited for a tenth of a millisecond or more.
    bool is_late() const { return looks_ > kLooksPerTurn * 256; }

  private:
    static constexpr int kLooksPerTurn = 64;
    int looks_ = 0;
};

}  // namespace

WorkerThreads::WorkerThreads(int wanted) {
    try {
        for (int worker = 1; worker < wanted; ++worker) threads_.emplace_back([this, worker] { run(worker); });
    } catch (const std::system_error&) {  // fewer threads do the work
    }
}

WorkerThreads::~WorkerThreads() {
    set_state(State::Stopping);
    for (std::thread& thread : threads_) thread.join();
}

void WorkerThreads::begin(SharedWork& work) {
    work_ = &work;
    set_state(State::Working);
}

void WorkerThreads::end() {
    const auto do_parts = [this] {
        while (work_->do_part(0)) {
        }
    };
    do_parts();
    state_.store(State::Resting);  // needs no notification: sleeping threads wait for the next work
    for (Lookout lookout; busy_.load() != 0;) lookout.wait();
    do_parts();  // those that a thread held while the others looked
}

void WorkerThreads::set_state(State state) {
    {
        const std::lock_guard lock(mutex_);
        state_.store(state);
    }
    changed_.notify_all();
}

/// A thread counts as busy before it looks at the state, and end() looks for busy threads after it has set the state,
/// so one of them sees the other.
void WorkerThreads::run(int worker) {
    while (wait_for_work() != State::Stopping) {
        ++busy_;
        for (Lookout lookout; state_.load() == State::Working;)
            if (!work_->do_part(worker)) lookout.wait();
        --busy_;
    }
}

WorkerThreads::State WorkerThreads::wait_for_work() {
    for (Lookout lookout; !lookout.is_late(); lookout.wait())
        if (const State state = state_.load(std::memory_order_relaxed); state != State::Resting) return state;
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [this] { return state_.load() != State::Resting; });
    return state_.load();
}

}  // namespace oblong
