#pragma once

#include <string>
#include <vector>

namespace oblong::map {

/// A set of leaves as in the file: a bit each, leaf 1 first, lowest bit first; a zero byte is followed by the number of
/// zero bytes that it stands for.
std::string packed_row(const std::vector<bool>& leaves);

/// The first `leaf_count` leaves of the row at `offset`; all of them if it is negative.
std::vector<bool> unpacked_row(const std::string& visibility, int offset, std::size_t leaf_count);

}  // namespace oblong::map
