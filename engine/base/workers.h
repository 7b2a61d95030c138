#pragma once

#include <cstdint>

namespace oblong {

/// Work in items that may be done concurrently.
class SharedWork {
  public:
    virtual ~SharedWork() = default;
    /// Does one item. `worker`, below Workers::count(), differs between concurrent calls.
    virtual void do_item(std::uint32_t item, int worker) = 0;
};

/// Shares work among its caller, which is worker 0, and threads made by the program (platform/worker_threads.h). The
/// engine starts no threads.
class Workers {
  public:
    virtual ~Workers() = default;
    virtual int count() const = 0;
    /// Begins work without items. Earlier work must have ended.
    virtual void begin(SharedWork& work) = 0;
    /// Adds the next item, counted from 0. The first free thread takes it, and sees everything written before this
    /// call.
    virtual void add_item() = 0;
    /// Works until all added items are done; the caller then sees everything that they wrote.
    virtual void finish_items() = 0;
    /// Ends the work after finish_items(): the threads sleep until the next.
    virtual void end() = 0;
};

}  // namespace oblong
