#include "game/options/preferences_store.h"

#include <algorithm>
#include <filesystem>
#include <utility>

#include "engine/files/files.h"
#include "game/options/options_text.h"

namespace oblong {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kLargestFile_bytes = 256 * 1024;

bool exists(const std::string& file) {
    std::error_code error;
    return fs::exists(fs::symlink_status(file, error));
}

std::string text_of_file(const std::string& file) {
    const std::vector<std::uint8_t> bytes = read_file(file, kLargestFile_bytes, FileUse::Kept);
    return {bytes.begin(), bytes.end()};
}

}  // namespace

PreferencesStore::PreferencesStore(std::string file) : file_(std::move(file)) {
    if (!file_.empty() && exists(file_)) {
        try {
            const std::string text = text_of_file(file_);
            ReadPreferences read = naming_file(file_, [&] { return read_preferences(text); });
            kept_ = read.preferences;
            for (const LineFault& fault : read.faults)
                faults_.push_back(file_ + ": line " + std::to_string(fault.line) + ": " + fault.what);
        } catch (const FileError& error) {
            faults_.push_back(std::string(error.what()) + "; options are not kept");
            file_.clear();
        }
    }
    begin_with(kept_);
}

// A preset changes its dials too, so kept and earlier preferences are compared after all changes are copied.
void PreferencesStore::note_changes(const Preferences& now) {
    const Preferences before = kept_;
    for (const KeptValue* value : all_kept_values()) {
        const std::string text = value->text(now);
        if (text != value->text(shown_)) value->parse(kept_, text);
    }
    shown_ = now;
    for (const KeptValue* value : all_kept_values()) {
        const bool is_listed = std::find(changed_.begin(), changed_.end(), value) != changed_.end();
        if (!is_listed && value->text(kept_) != value->text(before)) changed_.push_back(value);
    }
}

std::string PreferencesStore::save(const Preferences& now) {
    if (file_.empty()) return "";
    note_changes(now);
    if (changed_.empty()) return "";
    try {
        const std::string folder = fs::path(file_).parent_path().string();
        if (!folder.empty()) make_folder(folder);
        // The file may have been edited while the game ran.
        const std::string text = exists(file_) ? text_of_file(file_) : write_preferences(kept_);
        write_file(file_, with_values(text, changed_, kept_), FileUse::Kept);
        changed_.clear();
        return "";
    } catch (const FileError& error) {
        return error.what();
    }
}

std::string PreferencesStore::save_when_settled(const Preferences& now, std::uint64_t now_us) {
    constexpr std::uint64_t kSettles_us = 1'000'000;
    if (now != settled_) {
        settled_ = now;
        settled_us_ = now_us;
    }
    if (settled_ == shown_ || now_us - settled_us_ < kSettles_us) return "";
    return save(now);
}

}  // namespace oblong
