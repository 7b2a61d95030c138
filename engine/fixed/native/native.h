#pragma once

// The one door to code for a processor below raster/kernels/: what engine/ takes from `native` is plain.h's, or that of
// this processor, with the same results (tests/fixed/native_test.cpp).

#if defined(__i386__)
#include "engine/fixed/native/i386.h"
namespace oblong {
namespace native = on_i386;
}
#else
#include "engine/fixed/native/plain.h"
namespace oblong {
namespace native = plain;
}
#endif
