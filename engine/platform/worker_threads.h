#pragma once

#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <mutex>
#include <thread>
#include <vector>

#include "engine/base/workers.h"

namespace oblong {

/// Threads that share work. They sleep while there is none, and poll for items while there is, since work takes less
/// than a frame.
class WorkerThreads final : public Workers {
  public:
    /// Makes count() `wanted`, 1 or more; or less if the system allows fewer threads.
    explicit WorkerThreads(int wanted);
    WorkerThreads(const WorkerThreads&) = delete;
    ~WorkerThreads() override;

    int count() const override { return static_cast<int>(threads_.size()) + 1; }
    void begin(SharedWork& work) override;
    void add_item() override;
    void finish_items() override;
    void end() override;

  private:
    enum class State : std::uint8_t { Resting, Working, Stopping };

    void run(int worker);
    State wait_for_work();
    bool do_next_item(int worker);
    void set_state(State state);

    /// Items are numbered consecutively across works. The numbers wrap, and are compared by their differences. They
    /// start near the wrap, so that tests cover it.
    static constexpr std::uint32_t kFirstNumber = 0xffff'ff00;

    /// A cache line: variables written by different threads are on different lines.
    static constexpr std::size_t kLine_bytes = 64;

    SharedWork* work_ = nullptr;               ///< read only by threads that have taken an item
    std::uint32_t first_item_ = kFirstNumber;  ///< number of the work's first item; read likewise
    alignas(kLine_bytes) std::atomic<std::uint32_t> added_{kFirstNumber};  ///< the end of the items that may be taken
    alignas(kLine_bytes) std::atomic<std::uint32_t> taken_{kFirstNumber};  ///< the end of the items taken
    alignas(kLine_bytes) std::atomic<std::uint32_t> finished_{
        kFirstNumber};  ///< the number of items done, in the same numbering
    alignas(kLine_bytes) std::atomic<State> state_{State::Resting};
    std::mutex mutex_;  ///< for changes of state_
    std::condition_variable changed_;
    std::vector<std::thread> threads_;
};

}  // namespace oblong
