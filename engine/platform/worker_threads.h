#pragma once

#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <mutex>
#include <thread>
#include <vector>

#include "engine/base/workers.h"

namespace oblong {

/// Threads that share work. They sleep while there is none, and poll for parts while there is, since work takes less
/// than a frame.
class WorkerThreads final : public Workers {
  public:
    /// Makes count() `wanted`, 1 or more; or less if the system allows fewer threads.
    explicit WorkerThreads(int wanted);
    WorkerThreads(const WorkerThreads&) = delete;
    ~WorkerThreads() override;

    int count() const override { return static_cast<int>(threads_.size()) + 1; }
    void begin(SharedWork& work) override;
    void end() override;

  private:
    enum class State : std::uint8_t { Resting, Working, Stopping };

    void run(int worker);
    State wait_for_work();
    void set_state(State state);

    SharedWork* work_ = nullptr;  ///< read only while Working
    std::atomic<State> state_{State::Resting};
    std::atomic<int> busy_{0};  ///< threads that may still read `work_`
    std::mutex mutex_;          ///< for changes of state_
    std::condition_variable changed_;
    std::vector<std::thread> threads_;
};

}  // namespace oblong
