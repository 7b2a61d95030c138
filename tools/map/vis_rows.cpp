#include "tools/map/vis_rows.h"

namespace oblong::map {

std::string packed_row(const std::vector<bool>& leaves) {
    std::string bytes((leaves.size() + 7) / 8, '\0');
    for (std::size_t i = 0; i < leaves.size(); ++i) {
        if (leaves[i]) bytes[i / 8] = static_cast<char>(static_cast<unsigned char>(bytes[i / 8]) | (1u << (i % 8)));
    }
    std::string row;
    for (std::size_t i = 0; i < bytes.size();) {
        row.push_back(bytes[i]);
        if (bytes[i] != 0) {
            ++i;
            continue;
        }
        std::size_t run = 1;
        while (run < 255 && i + run < bytes.size() && bytes[i + run] == 0) ++run;
        row.push_back(static_cast<char>(run));
        i += run;
    }
    return row;
}

std::vector<bool> unpacked_row(const std::string& visibility, int offset, std::size_t leaf_count) {
    if (offset < 0) return std::vector<bool>(leaf_count, true);
    std::vector<bool> leaves;
    for (auto at = static_cast<std::size_t>(offset); leaves.size() < leaf_count; ++at) {
        const auto byte = static_cast<unsigned char>(visibility[at]);
        const std::size_t bits = byte != 0 ? 8 : 8 * static_cast<unsigned char>(visibility[++at]);
        for (std::size_t bit = 0; bit < bits; ++bit) leaves.push_back((byte >> (bit % 8) & 1) != 0);
    }
    leaves.resize(leaf_count);
    return leaves;
}

}  // namespace oblong::map
