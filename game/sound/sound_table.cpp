#include "game/sound/sound_table.h"

#include <algorithm>
#include <array>

namespace oblong {
namespace {

constexpr CaptionRule kSometimes = CaptionRule::Sometimes;

// In the order of Sound.
constexpr auto kRows = std::to_array<SoundRow>({
    {"step_stone", 3, "footsteps on stone", 0, 110, 12, kSometimes},
    {"step_wood", 3, "footsteps on wood", 0, 110, 12, kSometimes},
    {"step_metal", 3, "footsteps on metal", 0, 100, 18, kSometimes},
    {"step_earth", 3, "footsteps on earth", 0, 120, 12, kSometimes},
    {"step_carpet", 3, "footsteps on carpet", 0, 100, 12, kSometimes},
    {"step_water", 3, "footsteps in water", 0, 120, 18, kSometimes},
    {"land", 1, "you land", 0, 170, 14},
    {"swim", 2, "swimming", 0, 120, 28, kSometimes},
    {"water_in", 1, "splash", 0, 220, 42},
    {"water_out", 1, "water drips off you", 0, 170, 42},
    {"door_start", 1, "door", 900, 220, 21},
    {"door_move", 1, "", 700, 150, 0},
    {"door_stop", 1, "door stops", 900, 230, 21},
    {"slab_start", 1, "heavy door", 1000, 230, 25},
    {"slab_move", 1, "", 900, 170, 0},
    {"slab_stop", 1, "heavy door stops", 1000, 240, 28},
    {"gate_start", 1, "gate", 1000, 210, 28},
    {"gate_move", 1, "", 900, 160, 0},
    {"gate_stop", 1, "gate stops", 1000, 230, 42},
    {"lift_start", 1, "lift", 900, 200, 25},
    {"lift_move", 1, "", 700, 150, 0},
    {"lift_stop", 1, "lift stops", 900, 220, 25},
    {"train_start", 1, "something heavy moves", 1000, 200, 35},
    {"train_move", 1, "", 900, 160, 0},
    {"train_stop", 1, "it stops", 1000, 210, 28},
    {"button", 1, "button", 700, 230, 14},
    {"teleport", 1, "you are somewhere else", 0, 200, 56},
    {"hurt", 1, "that hurts", 0, 200, 8},
    {"lens", 1, "a lens rings", 0, 220, 105},
    {"key", 1, "keys jingle", 0, 210, 42},
    {"message", 1, "", 0, 130, 28},
    {"played", 0, "", 900, 200, 28},  // always a level's own file, at a place
    {"secret", 1, "a secret", 0, 200, 70},
    {"level_end", 1, "a closing chord", 0, 220, 140},
    {"menu_move", 1, "", 0, 110, 4},
    {"menu_accept", 1, "", 0, 150, 11},
    {"menu_back", 1, "", 0, 140, 11},
    {"wind", 1, "wind", 900, 180, 0, kSometimes},
    {"rain", 1, "rain", 700, 160, 0, kSometimes},
    {"water", 1, "water", 500, 130, 0, kSometimes},
    {"slime", 1, "slime bubbles", 450, 150, 0, kSometimes},
    {"lava", 1, "lava bubbles", 600, 190, 0, kSometimes},
    {"fire", 1, "a flame", 300, 130, 0, kSometimes},
    {"hum", 1, "a lamp hums", 160, 70, 0, kSometimes},
    {"sparks", 1, "sparks crackle", 450, 150, 0, kSometimes},
    {"bubbles", 1, "bubbles", 350, 130, 0, kSometimes},
    {"teleporter", 1, "a teleporter hums", 500, 160, 0, kSometimes},
    {"under_water", 1, "under water", 0, 150, 0, kSometimes},
});
static_assert(kRows.size() == kSoundCount);

}  // namespace

const SoundRow& row_of(Sound sound) {
    return item(kRows, sound);
}

std::optional<Sound> find_sound(std::string_view file) {
    const auto found =
        std::find_if(kRows.begin(), kRows.end(), [file](const SoundRow& row) { return row.file == file; });
    return found == kRows.end() ? std::nullopt : std::optional(static_cast<Sound>(found - kRows.begin()));
}

std::string file_of(Sound sound, std::int32_t variant) {
    const SoundRow& row = row_of(sound);
    return row.file + (row.variants > 1 ? std::to_string(variant + 1) : std::string()) + ".flac";
}

}  // namespace oblong
