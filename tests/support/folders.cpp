#include "tests/support/folders.h"

namespace oblong::test {

std::string source_folder() {
    return OBLONG_SOURCE_DIR;
}

std::string build_folder() {
    return OBLONG_BUILD_DIR;
}

}  // namespace oblong::test
