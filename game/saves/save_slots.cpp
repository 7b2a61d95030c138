#include "game/saves/save_slots.h"

#include <array>
#include <cerrno>
#include <charconv>
#include <chrono>
#include <cstring>
#include <filesystem>
#include <set>
#include <string_view>
#include <thread>
#include <utility>

#include "engine/base/table.h"
#include "engine/io/files.h"
#include "engine/io/system.h"

namespace oblong {

std::unique_ptr<FileLock> FileLock::take(const std::string& file, std::int64_t byte, int longest_wait_ms) {
    constexpr int kPause_ms = 5;
    const int number = open_file(file, OpenMode::Lock);
    if (number < 0) throw FileError(file, "open", std::strerror(errno) + std::string(", expected a place for a lock"));
    std::unique_ptr<FileLock> lock(new FileLock(number));
    for (int waited_ms = 0; !lock_byte(number, byte); waited_ms += kPause_ms) {
        if (waited_ms >= longest_wait_ms) return nullptr;
        std::this_thread::sleep_for(std::chrono::milliseconds(kPause_ms));
    }
    return lock;
}

FileLock::~FileLock() {
    close_file(number_);
}

namespace {

namespace fs = std::filesystem;

constexpr std::size_t kLargestSave_bytes = std::size_t{1} << 24;
constexpr std::string_view kExtension = ".save", kFormerExtension = ".old";
constexpr std::array<std::string_view, 3> kPrefixes{"auto", "quick", "slot"};  // by SaveKind
// Byte 0: the folder; byte n + 1: walk n.
constexpr const char* kLockFile = "lock";
constexpr int kLongestWait_ms = 3000, kMostWalks = 1'000'000;

std::string former_of(const std::string& file) {
    return file + std::string(kFormerExtension);
}

bool is_there(const std::string& file) {
    std::error_code ignored;
    return fs::symlink_status(file, ignored).type() != fs::file_type::not_found;
}

std::vector<std::uint8_t> bytes_of(const std::string& file) {
    return read_file(file, kLargestSave_bytes);
}

// Whether a file is a save worth keeping, by its checksum; its state is not read.
bool is_whole_save(const std::string& file) {
    try {
        decode_save_head(bytes_of(file));
        return true;
    } catch (const std::runtime_error&) {  // FileError, or InputError
        return false;
    }
}

std::string number_text(SaveSlot slot) {
    return slot.number == 0 ? "" : std::to_string(slot.number);
}

std::string file_name_of(SaveSlot slot) {
    return std::string(item(kPrefixes, slot.kind)) + number_text(slot) + std::string(kExtension);
}

// The slot whose file or previous file has this name; nothing for any other file.
std::optional<SaveSlot> slot_of(const std::string& file_name) {
    const std::string_view name(file_name);
    for (const SaveKind kind : {SaveKind::Walk, SaveKind::Quick, SaveKind::Numbered}) {
        const std::string_view prefix = item(kPrefixes, kind);
        SaveSlot slot{kind, 0};
        if (!name.starts_with(prefix)) continue;
        std::from_chars(name.data() + prefix.size(), name.data() + name.size(), slot.number);
        if (slot.number < 0 || slot.number > kMostWalks) continue;
        if (name == file_name_of(slot) || name == former_of(file_name_of(slot))) return slot;
    }
    return {};
}

// When a slot was saved; the earliest time if there is no such file.
fs::file_time_type time_of(const std::string& file) {
    std::error_code ignored;
    return fs::last_write_time(is_there(file) ? file : former_of(file), ignored);
}

std::vector<fs::path> files_in(const std::string& folder) {
    std::vector<fs::path> files;
    std::error_code error;
    for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error))
        files.push_back(entry->path());
    return files;
}

// The last save of a slot that `decode` accepts, or the one before it.
template <class Saved>
SlotOf<Saved> read_slot(SaveSlot slot, const std::string& unresolved_file,
                        Saved decode(std::span<const std::uint8_t> bytes)) {
    SlotOf<Saved> content;
    content.slot = slot;
    try {
        const std::string file = end_of_links(unresolved_file);
        for (const std::string& each : {file, former_of(file)}) {
            if (!is_there(each)) continue;
            try {
                content.game = naming_file(each, [&] { return decode(bytes_of(each)); });
                content.is_former = each != file;
                return content;
            } catch (const FileError& error) {
                content.refusal +=
                    (content.refusal.empty() ? "" : "\n\nThe save before it: ") + std::string(error.what());
            }
        }
    } catch (const FileError& error) {
        content.refusal = error.what();
    }
    return content;
}

}  // namespace

std::string name_of(SaveSlot slot) {
    static constexpr std::array<const char*, 3> kNames{"Walk", "Quick save", "Slot"};
    const std::string number = number_text(slot);
    return item(kNames, slot.kind) + (number.empty() ? "" : " " + number);
}

std::string SaveSlots::link_of(SaveSlot slot) const {
    return (fs::path(folder_) / file_name_of(slot)).string();
}

// Follows links, so that a save may be kept elsewhere, with the previous one beside it.
std::string SaveSlots::file_of(SaveSlot slot) const {
    return end_of_links(link_of(slot));
}

std::unique_ptr<FileLock> SaveSlots::lock(std::int64_t byte, int longest_wait_ms) const {
    make_folder(folder_);
    return FileLock::take((fs::path(folder_) / kLockFile).string(), byte, longest_wait_ms);
}

// Also removes unfinished files of programs that ended while they saved: no other program saves now.
std::unique_ptr<FileLock> SaveSlots::lock_folder() const {
    auto held = lock(0, kLongestWait_ms);
    if (!held) throw FileError(folder_, "lock", "another program has been saving for 3 s, expected it to end");
    for (const fs::path& file : files_in(folder_))
        if (file.extension() == kUnfinishedExtension) remove_files({file.string()});
    return held;
}

// A damaged file does not replace the previous save.
void SaveSlots::save(SaveSlot slot, const SavedGame& game) const {
    const auto held = lock_folder();
    const std::string file = file_of(slot);
    if (is_there(file) && is_whole_save(file))
        replace_file(file, former_of(file), encode_save(game));
    else
        write_file(file, encode_save(game), FileUse::Kept);
    if (slot.kind != SaveKind::Numbered) make_latest(slot);  // those are listed by number
}

// Also after the clock was set back: else the title would go on with another walk.
void SaveSlots::make_latest(SaveSlot slot) const {
    const auto others = walks_and_quick_saves();
    const SaveSlot latest = others.empty() ? slot : others.front();
    std::error_code ignored;  // the save is whole without it
    if (latest != slot) fs::last_write_time(file_of(slot), time_of(link_of(latest)) + std::chrono::seconds(2), ignored);
}

SlotContent SaveSlots::load(SaveSlot slot) const {
    return read_slot(slot, link_of(slot), decode_save);
}

ListedSlot SaveSlots::head_of(SaveSlot slot) const {
    return read_slot(slot, link_of(slot), decode_save_head);
}

void SaveSlots::remove(SaveSlot slot) const {
    const auto held = lock_folder();
    const std::string file = file_of(slot);
    const bool is_walked = slot.kind != SaveKind::Numbered && !hold(slot.number);
    if (is_walked) throw FileError(file, "remove", "this walk is being played, expected one that is not");
    remove_files({former_of(file), file});
}

std::vector<SaveSlot> SaveSlots::walks_and_quick_saves() const {
    std::set<std::pair<fs::file_time_type, SaveSlot>> slots;
    for (const fs::path& file : files_in(folder_))
        if (const auto slot = slot_of(file.filename().string()); slot && slot->kind != SaveKind::Numbered)
            slots.emplace(time_of((file.parent_path() / file_name_of(*slot)).string()), *slot);
    std::vector<SaveSlot> last_first;
    for (auto entry = slots.rbegin(); entry != slots.rend(); ++entry) last_first.push_back(entry->second);
    return last_first;
}

std::vector<ListedSlot> SaveSlots::list() const {
    std::vector<ListedSlot> all;
    for (const SaveSlot slot : walks_and_quick_saves()) all.push_back(head_of(slot));
    for (int number = 1; number <= kNumberedSlotCount; ++number) all.push_back(head_of({SaveKind::Numbered, number}));
    return all;
}

std::optional<ListedSlot> SaveSlots::last_walk() const {
    for (const SaveSlot slot : walks_and_quick_saves())
        if (slot.kind == SaveKind::Walk) return head_of(slot);
    return {};
}

std::optional<HeldWalk> SaveSlots::hold(int number) const {
    HeldWalk held{number, lock(number + std::int64_t{1}, 0)};
    if (!held.lock) return {};
    return held;
}

HeldWalk SaveSlots::hold_new() const {
    const auto held = lock_folder();
    std::set<int> used{0};
    for (const SaveSlot slot : walks_and_quick_saves()) used.insert(slot.number);
    for (int number = *used.rbegin() + 1;; ++number) {
        if (number > kMostWalks) number = 1;  // beyond, list() would not find its saves
        if (used.contains(number)) continue;
        if (auto walk = hold(number)) return std::move(*walk);
    }
}

}  // namespace oblong
