#include "engine/library/oblong.h"

namespace oblong {

const char* version() {
    return OBLONG_VERSION;
}

}  // namespace oblong
