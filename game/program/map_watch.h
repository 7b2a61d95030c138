#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>

#include "game/program/level_watch.h"

namespace oblong {

/// Recompiles a level when its source changes: checks the file, the maps that it includes and its textures now and
/// then, and has oblong-map compile a draft of the changed part while the game goes on.
class MapWatch final : public LevelWatch {
  public:
    /// `compiler` is the program oblong-map, `game` its option; empty: none. The level is written beside the source, as
    /// NAME-draft.bsp.
    MapWatch(std::string map_file, std::string compiler, std::string game = "");
    ~MapWatch() override;
    MapWatch(const MapWatch&) = delete;

    const std::string& level_file() const override { return level_file_; }
    std::optional<Result> poll(std::uint64_t now_us) override;
    std::string due_reminder(std::uint64_t now_us) override;
    void remind_of(std::string fault) override;
    /// Compiles all and waits for the result. If there is no level: throws FileError, or with `waits` prints why on
    /// standard error, and compiles again after each change until there is one.
    void compile_first(bool waits);

  private:
    struct Stamp {
        std::filesystem::file_time_type time;
        std::uintmax_t size = 0;
        bool operator==(const Stamp&) const = default;
    };

    static Stamp stamp_of(const std::string& file);
    std::optional<Result> look(std::uint64_t now_us);
    bool others_have_changed();
    void look_for_others();
    void begin(bool compiles_all);
    Result finish(bool has_level);

    std::string map_file_, compiler_, game_, level_file_, log_file_, reads_file_, since_file_;
    std::string text_;        // of the current level
    std::string tried_text_;  // of the compilation
    Stamp seen_;
    std::map<std::string, Stamp> others_;  // other files that the compiler read
    bool has_failed_ = false;              // then the next compilation is All
    std::string fault_;                    // of the level; empty: none
    std::uint64_t looked_us_ = 0, reminded_us_ = 0;
    std::optional<int> running_;  // the compiler's process
    bool compiles_all_ = true;
};

}  // namespace oblong
