#include "game/program/map_watch.h"

#include <chrono>
#include <cstdio>
#include <sstream>
#include <thread>

#include "engine/io/files.h"
#include "engine/io/system.h"
#include "engine/programs/arguments.h"
#include "game/level/level_search.h"

namespace oblong {
namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t kPollEvery_us = 200'000, kBetweenReminders_us = 3'000'000;

}  // namespace

MapWatch::MapWatch(std::string map_file, std::string compiler, std::string game)
    : map_file_(std::move(map_file)), compiler_(std::move(compiler)), game_(std::move(game)) {
    const std::string base = fs::path(map_file_).replace_extension().string() + kDraftEnding;
    level_file_ = base + ".bsp";
    log_file_ = base + ".log";
    reads_file_ = base + ".reads";
    since_file_ = base + ".since";
}

MapWatch::~MapWatch() {
    if (running_) stop_program(*running_);  // it writes a level whole or not at all
}

MapWatch::Stamp MapWatch::stamp_of(const std::string& file) {
    std::error_code none, no_size;  // an editor may be writing it; a folder has no size
    const auto time = fs::last_write_time(file, none);
    const auto size = fs::file_size(file, no_size);
    return {time, no_size ? 0 : size};
}

bool MapWatch::others_have_changed() {
    bool have = false;
    for (auto& [file, seen] : others_) {
        const Stamp now = stamp_of(file);
        have = have || now != seen;
        seen = now;
    }
    return have;
}

std::optional<MapWatch::Result> MapWatch::poll(std::uint64_t now_us) {
    try {
        return look(now_us);
    } catch (const FileError&) {
        seen_ = {};  // tried again at the next look
        throw;
    }
}

std::optional<MapWatch::Result> MapWatch::look(std::uint64_t now_us) {
    if (running_) {
        const ProgramState state = state_of_program(*running_);
        if (state == ProgramState::Runs) return std::nullopt;
        running_.reset();
        if (state == ProgramState::Unknown)
            throw FileError(compiler_, "wait", "the system does not tell how it ended, expected an exit code");
        Result result = finish(state == ProgramState::Succeeded);
        if (result.has_level || compiles_all_) {
            remind_of(result.fault);
            return result;
        }
        begin(true);  // more has changed than the compiler has found
        return std::nullopt;
    }
    if (now_us < looked_us_ + kPollEvery_us) return std::nullopt;
    looked_us_ = now_us;
    std::error_code ignored;
    if (!fs::exists(map_file_, ignored)) return std::nullopt;
    const Stamp now = stamp_of(map_file_);
    const bool have_others = others_have_changed();
    if (now == seen_ && !have_others) return std::nullopt;
    seen_ = now;
    tried_text_ = read_text(map_file_);
    const bool is_all_new = have_others || has_failed_;
    if (is_all_new || tried_text_ != text_) begin(is_all_new);
    return std::nullopt;
}

void MapWatch::remind_of(std::string fault) {
    if (fault != fault_) reminded_us_ = 0;
    fault_ = std::move(fault);
}

std::string MapWatch::due_reminder(std::uint64_t now_us) {
    if (fault_.empty() || now_us < reminded_us_ + kBetweenReminders_us) return "";
    reminded_us_ = now_us;
    return fault_;
}

void MapWatch::compile_first(bool waits) {
    constexpr std::uint64_t kBetweenPolls_us = 20'000;
    seen_ = stamp_of(map_file_);
    tried_text_ = read_text(map_file_);
    begin(true);
    for (std::uint64_t now_us = 0;; now_us += kBetweenPolls_us) {
        const auto result = poll(now_us);
        if (result && result->has_level) break;
        if (result) {
            const FileError fault(map_file_, "oblong-map", result->fault);
            if (!waits) throw fault;
            print_fault("oblong", std::string(fault.what()) + "; tried again after a change");
        }
        std::this_thread::sleep_for(std::chrono::microseconds(kBetweenPolls_us));
    }
    looked_us_ = 0;
}

void MapWatch::begin(bool compiles_all) {
    std::vector<std::string> words{compiler_, map_file_, "-o", level_file_, "--fast", "--reads", reads_file_};
    if (!compiles_all) {
        write_file(since_file_, text_);
        words.insert(words.end(), {"--since", since_file_});
    }
    if (!game_.empty()) words.insert(words.end(), {"--game", game_});
    write_file(log_file_, std::string());  // names the folder if it is read-only: below, the compiler would be blamed
    running_ = start_program(std::move(words), log_file_);
    if (!running_) throw FileError(compiler_, "start", "the compiler does not start, expected oblong-map there");
    compiles_all_ = compiles_all;
}

// Known files keep the stamps from before they were read.
void MapWatch::look_for_others() {
    std::error_code ignored;
    if (!fs::exists(reads_file_, ignored)) return;
    std::map<std::string, Stamp> others;
    std::istringstream lines(read_text(reads_file_));
    for (std::string file; std::getline(lines, file);) {
        const auto known = others_.find(file);
        others[file] = known == others_.end() ? stamp_of(file) : known->second;
    }
    others_ = std::move(others);
}

MapWatch::Result MapWatch::finish(bool has_level) {
    look_for_others();
    Result result;
    result.has_level = has_level;
    has_failed_ = !result.has_level;
    std::istringstream lines(read_text(log_file_));
    for (std::string line; std::getline(lines, line);) {
        if (line.find(": warning: ") != std::string::npos)
            std::fputs((line + "\n").c_str(), stderr);
        else if (line.find("% ") == std::string::npos)
            result.fault = line;
    }
    if (result.has_level) {
        text_ = tried_text_;
        result.fault.clear();
        return result;
    }
    const std::string named = "oblong-map: " + map_file_ + ": ";
    if (result.fault.starts_with(named)) result.fault.erase(0, named.size());
    if (result.fault.empty()) result.fault = "oblong-map ended without a message";
    return result;
}

}  // namespace oblong
