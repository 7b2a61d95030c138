#include "game/saves/save_slots.h"

#include <filesystem>
#include <utility>

#include "engine/platform/files.h"

namespace oblong {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kLargestSave_bytes = std::size_t{1} << 24;

std::string former_of(const std::string& file) {
    return file + ".old";
}

bool is_there(const std::string& file) {
    std::error_code ignored;
    return fs::symlink_status(file, ignored).type() != fs::file_type::not_found;
}

SavedGame read_save(const std::string& file) {
    return naming_file(file, [&] { return decode_save(read_file(file, kLargestSave_bytes)); });
}

// Why a file is no save that can be loaded; empty if it is one.
std::string refusal_of(const std::string& file) {
    try {
        read_save(file);
    } catch (const FileError& error) {
        return error.what();
    }
    return {};
}

}  // namespace

std::string name_of(SaveSlot slot) {
    if (slot == SaveSlot::Quick) return "Quick save";
    if (slot == SaveSlot::Automatic) return "Autosave";
    if (slot == SaveSlot::LevelStart) return "Level start";
    return "Slot " + std::to_string(static_cast<int>(slot) - static_cast<int>(SaveSlot::FirstNumbered) + 1);
}

std::string SaveSlots::file_of(SaveSlot slot) const {
    std::string name = "quick.save";
    if (slot == SaveSlot::Automatic) name = "auto.save";
    if (slot == SaveSlot::LevelStart) name = "start.save";
    if (slot >= SaveSlot::FirstNumbered)
        name =
            "slot" + std::to_string(static_cast<int>(slot) - static_cast<int>(SaveSlot::FirstNumbered) + 1) + ".save";
    return (fs::path(folder_) / name).string();
}

// A damaged file does not take the place of the one before it.
void SaveSlots::save(SaveSlot slot, const SavedGame& game) const {
    make_folder(folder_);
    const std::string file = file_of(slot);
    if (is_there(file) && refusal_of(file).empty())
        replace_file(file, former_of(file), encode_save(game));
    else
        write_file(file, encode_save(game));
}

SlotContent SaveSlots::load(SaveSlot slot) const {
    SlotContent content;
    content.slot = slot;
    const std::string file = file_of(slot);
    for (const std::string& each : {file, former_of(file)}) {
        if (!is_there(each)) continue;
        try {
            content.game = read_save(each);
            content.is_former = each != file;
            return content;
        } catch (const FileError& error) {
            if (content.refusal.empty()) content.refusal = error.what();
        }
    }
    return content;
}

std::vector<SlotContent> SaveSlots::list() const {
    std::vector<SlotContent> all;
    for (int slot = 0; slot < kSaveSlotCount; ++slot) all.push_back(load(static_cast<SaveSlot>(slot)));
    return all;
}

}  // namespace oblong
