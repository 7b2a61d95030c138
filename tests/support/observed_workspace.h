#pragma once

#include "engine/frame/frame_counts.h"
#include "engine/frame/frame_record.h"
#include "engine/frame/workspace.h"

namespace oblong::test {

/// A workspace with counts and a record at hand; frames fill those that its observers point to.
struct ObservedWorkspace : FrameWorkspace {
    using FrameWorkspace::FrameWorkspace;

    void count() { observers.counts = &counts; }
    void keep_record() { observers.record = &record; }

    FrameCounts counts;
    FrameRecord record;
};

}  // namespace oblong::test
