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
    first_item_ = added_.load(std::memory_order_relaxed);
    set_state(State::Working);
}

void WorkerThreads::add_item() {
    added_.store(added_.load(std::memory_order_relaxed) + 1, std::memory_order_release);
}

void WorkerThreads::finish_items() {
    while (do_next_item(0)) {
    }
    Lookout lookout;
    while (finished_.load(std::memory_order_acquire) != added_.load(std::memory_order_relaxed)) lookout.wait();
}

void WorkerThreads::end() {
    state_.store(State::Resting);  // needs no notification: sleeping threads wait for the next work
}

void WorkerThreads::set_state(State state) {
    {
        const std::lock_guard lock(mutex_);
        state_.store(state);
    }
    changed_.notify_all();
}

void WorkerThreads::run(int worker) {
    while (wait_for_work() == State::Working) {
        Lookout lookout;
        while (state_.load(std::memory_order_relaxed) == State::Working)
            if (!do_next_item(worker)) lookout.wait();
    }
}

WorkerThreads::State WorkerThreads::wait_for_work() {
    for (Lookout lookout; !lookout.is_late(); lookout.wait())
        if (const State state = state_.load(std::memory_order_relaxed); state != State::Resting) return state;
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [this] { return state_.load() != State::Resting; });
    return state_.load();
}

/// Items are taken in order. A taken item was added, since `added_` only grows.
bool WorkerThreads::do_next_item(int worker) {
    std::uint32_t next = taken_.load(std::memory_order_relaxed);
    do {
        if (static_cast<std::int32_t>(added_.load(std::memory_order_acquire) - next) <= 0) return false;
    } while (!taken_.compare_exchange_weak(next, next + 1, std::memory_order_relaxed));
    work_->do_item(next - first_item_, worker);
    finished_.fetch_add(1, std::memory_order_release);
    return true;
}

}  // namespace oblong
