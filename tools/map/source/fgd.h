#pragma once

#include <string>

namespace oblong::map {

/// entity_classes() as TrenchBroom and Valve's editors read them: an FGD file. Families are no classes that an editor
/// could place, and `classname` and `origin` are its own.
std::string fgd_text();

}  // namespace oblong::map
