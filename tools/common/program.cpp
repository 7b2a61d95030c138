#include "tools/common/program.h"

#include <cstdio>
#include <exception>
#include <new>

#include "engine/platform/files.h"
#include "tools/common/arguments.h"

namespace oblong {

int run_program(const std::string& name, const std::function<void()>& body) {
    try {
        body();
        flush_standard_output();
        return 0;
    } catch (const UsageError& error) {
        std::fprintf(stderr, "%s: %s\n", name.c_str(), error.what());
        return 2;
    } catch (const InputError& error) {
        std::fprintf(stderr, "%s: %s: %s\n", name.c_str(), error.where.c_str(), error.what());
        return 1;
    } catch (const std::bad_alloc&) {
        std::fprintf(stderr, "%s: out of memory\n", name.c_str());
        return 1;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "%s: %s\n", name.c_str(), error.what());
        return 1;
    }
}

void warn_of_torn_edges(const std::string& program, const std::string& level_file, std::size_t edges) {
    if (edges == 0) return;
    std::fprintf(stderr,
                 "%s: %s: warning: the level is torn at %zu edges, expected faces that meet: pixels there may take "
                 "the colour next to them\n",
                 program.c_str(), level_file.c_str(), edges);
}

}  // namespace oblong
