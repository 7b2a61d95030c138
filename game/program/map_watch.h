#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "engine/math/vec.h"

namespace oblong {

/// What of a level has to be made anew after its source has changed.
enum class MapChange : std::uint8_t { Nothing, Entities, Light, All };

/// Compares two texts of a Quake .map: brushes, or which entities have some, count as All; what may shine or be lit in
/// another way as Light.
MapChange change_between(const std::string& former, const std::string& now);

/// Keeps a level up with its source: looks at the file now and then, and has oblong-map compile a draft of what changed
/// while the game goes on.
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
    /// Compiles all and waits for it. Throws FileError where there is no level then.
    void compile_first();

  private:
    struct Stamp {
        std::filesystem::file_time_type time;
        std::uintmax_t size = 0;
        bool operator==(const Stamp&) const = default;
    };

    std::optional<Stamp> stamp() const;
    void begin(MapChange change);
    News finish(int status);

    std::string map_file_, compiler_, level_file_, said_file_, points_file_;
    std::string text_;        // that the level was made of
    std::string tried_text_;  // that is compiled
    std::optional<Stamp> seen_;
    std::uint64_t looked_us_ = 0;
    std::optional<int> running_;  // the compiler's process
};

}  // namespace oblong
