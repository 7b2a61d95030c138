#pragma once

#include "game/options/preference_table.h"

namespace oblong {

/// The three that say together what is in the picture; a change leaves out what can't be drawn with the other two.
Preference mode_preference();
Preference display_preference();
Preference field_of_view_preference();

}  // namespace oblong
