#pragma once

#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <mutex>
#include <thread>
#include <vector>

#include "engine/base/workers.h"

namespace oblong {

/// Threads that share in work. They sleep while there is none, and look for items without sleeping while there is: work
/// is what takes less than a frame.
class WorkerThreads final : public Workers {
  public:
    /// Makes count() `wanted`, 1 or more; or fewer, where the system does not give as many threads.
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

    /// Items are numbered through, from work to work. Numbers wrap, and soon, so that any test would show if that were
    /// wrong: they are compared by their differences.
    static constexpr std::uint32_t kFirstNumber = 0xffff'ff00;

    /// A line of the processors' caches: what different threads write does not share one.
    static constexpr std::size_t kLine_bytes = 64;

    SharedWork* work_ = nullptr;                                              ///< read by who has taken an item of it
    std::uint32_t first_item_ = kFirstNumber;                                 ///< of the work; read likewise
    alignas(kLine_bytes) std::atomic<std::uint32_t> added_{kFirstNumber};     ///< up to here items may be taken
    alignas(kLine_bytes) std::atomic<std::uint32_t> taken_{kFirstNumber};     ///< up to here they are
    alignas(kLine_bytes) std::atomic<std::uint32_t> finished_{kFirstNumber};  ///< so many are
    alignas(kLine_bytes) std::atomic<State> state_{State::Resting};
    std::mutex mutex_;  ///< of changes of state_
    std::condition_variable changed_;
    std::vector<std::thread> threads_;
};

}  // namespace oblong
