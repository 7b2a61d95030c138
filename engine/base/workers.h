#pragma once

#include <cstdint>

namespace oblong {

/// Work in items, any of which may be done while any other is.
class SharedWork {
  public:
    virtual ~SharedWork() = default;
    /// Does one item. `worker`, below Workers::count(), is who does it: two at once are never the same.
    virtual void do_item(std::uint32_t item, int worker) = 0;
};

/// Who shares in work: the one that hands it out, which is worker 0, and threads that a program made
/// (platform/worker_threads.h). The engine starts none.
class Workers {
  public:
    virtual ~Workers() = default;
    virtual int count() const = 0;
    /// Begins work of which there are no items yet. What was begun before has ended.
    virtual void begin(SharedWork& work) = 0;
    /// Adds the next item, counted from 0. The first free thread takes it, and sees all that was written before.
    virtual void add_item() = 0;
    /// Shares in the work until no item is left that was added: what all of them wrote is then seen by the caller.
    virtual void finish_items() = 0;
    /// Ends the work, whose items are finished: the others rest until there is more.
    virtual void end() = 0;
};

}  // namespace oblong
