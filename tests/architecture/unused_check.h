#pragma once

#include <string>
#include <vector>

#include "tests/architecture/include_check.h"

namespace oblong::test {

/// One line for every function that a header of engine/ declares and no code of `files` uses: neither the engine, nor
/// the game, nor a tool other than the gallery and the probe, which show what they like. Names are compared, not
/// meanings: a name that another function has in use passes. Functions of engine/methods are for the gallery, the probe
/// and tests, so that they are not asked for, but what they use counts as used.
std::vector<std::string> find_unused_functions(const std::vector<SourceFile>& files);

}  // namespace oblong::test
