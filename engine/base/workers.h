#pragma once

namespace oblong {

/// Work in parts that may be done concurrently.
class SharedWork {
  public:
    virtual ~SharedWork() = default;
    /// Does a part that no one else does. False if there is none now; more may come until Workers::end(). `worker`,
    /// below Workers::count(), differs between concurrent calls.
    virtual bool do_part(int worker) = 0;
};

/// Shares work among its caller, which is worker 0, and threads made by the program (platform/worker_threads.h). The
/// engine starts no threads.
class Workers {
  public:
    virtual ~Workers() = default;
    virtual int count() const = 0;
    /// From here on the others do parts of the work, as soon as there are some. Earlier work must have ended.
    virtual void begin(SharedWork& work) = 0;
    /// Works until all parts are done; the caller then sees everything that they wrote. The threads sleep until the
    /// next work.
    virtual void end() = 0;
};

}  // namespace oblong
