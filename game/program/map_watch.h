#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "engine/math/vec.h"

namespace oblong {

/// What of a level has to be made anew after its source has changed.
enum class MapChange : std::uint8_t { Nothing, Entities, Light, All };

/// Compares two texts of a Quake .map: brushes, which entities have some, and what names other files count as All; what
/// may shine or be lit in another way as Light.
MapChange change_between(const std::string& former, const std::string& now);

/// Keeps a level up with its source: looks now and then at the file, at maps within it and at its textures, and has
/// oblong-map compile a draft of what changed while the game goes on.
class MapWatch {
  public:
    /// `compiler` is the program oblong-map. The level is written beside the source, as NAME-draft.bsp.
    MapWatch(std::string map_file, std::string compiler);
    ~MapWatch();
    MapWatch(const MapWatch&) = delete;

    const std::string& level_file() const { return level_file_; }

    /// What a compilation that ended has brought.
    struct News {
        bool has_level = false;              ///< level_file() is new
        std::string fault;                   ///< what the compiler said, if it failed
        std::vector<Vec3<World>> leak_path;  ///< from an entity to the void, if the level leaks
    };

    /// Begins what is due, and returns what has ended. Reads files at most five times a second.
    std::optional<News> poll(std::uint64_t now_us);
    /// What is wrong with the level, each few seconds until it is mended; empty: nothing is, or not now.
    std::string due_reminder(std::uint64_t now_us);
    /// The new level is wrong in a way that the compiler does not know of.
    void remind_of(std::string fault);
    /// Compiles all and waits for it. Throws FileError where there is no level then.
    void compile_first();

  private:
    struct Stamp {
        std::filesystem::file_time_type time;
        std::uintmax_t size = 0;
        bool operator==(const Stamp&) const = default;
    };

    static Stamp stamp_of(const std::string& file);
    bool others_have_changed();
    void look_for_others();
    void begin(MapChange change);
    News finish(int status);

    std::string map_file_, compiler_, level_file_, said_file_, points_file_, reads_file_;
    std::string text_;        // that the level was made of
    std::string tried_text_;  // that is compiled
    Stamp seen_;
    std::map<std::string, Stamp> others_;  // that the compiler read
    bool has_failed_ = false;              // then all is due
    std::string fault_;                    // of the level; empty: none
    std::uint64_t looked_us_ = 0, reminded_us_ = 0;
    std::optional<int> running_;  // the compiler's process
    MapChange running_change_ = MapChange::All;
};

}  // namespace oblong
