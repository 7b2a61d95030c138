#include <filesystem>

#include "engine/files/files.h"
#include "engine/level/bsp_read.h"
#include "engine/level/side.h"
#include "tools/probe/queries.h"

namespace oblong {

namespace {

/// Regular files only: reading from a pipe could block.
bool read_level(const std::string& path, Level& level) {
    constexpr std::size_t kLargestLevel = std::size_t{1} << 28;
    std::error_code error;
    if (!std::filesystem::is_regular_file(path, error)) return false;
    try {
        level = read_bsp(read_file(path, kLargestLevel));
        return true;
    } catch (const std::runtime_error&) {
        return false;
    }
}

}  // namespace

std::string answer_leaf(Fields& fields, LastLevel& cache) {
    const std::string path(fields.text());
    const auto point = convert<World>(fields.point());
    fields.expect_end();

    if (cache.path != path) {
        cache.is_readable = read_level(path, cache.level);
        cache.path = path;
    }
    if (!cache.is_readable) throw Unsupported{};
    const LeafIndex index = find_leaf(cache.level, cache.level.world(), point);
    const Leaf& leaf = cache.level.leaves[index];
    return std::to_string(index.number()) + ' ' + std::to_string(leaf.contents);
}

}  // namespace oblong
