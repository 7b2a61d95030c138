// The pages that list saved walks: to load, to delete, to save.
#include <algorithm>
#include <utility>

#include "game/menu/menu_pages.h"

namespace oblong {

MenuRow MenuPages::save_row(const SaveEntry& save, std::function<void()> accept) const {
    return {save.name, save.content, save.help, std::move(accept), nullptr, save.picture};
}

void MenuPages::open_load() {
    menu_.open([this, saves = host_.saves()] {
        MenuPage page{"Load"};
        for (std::size_t i = 0; i < saves.size(); ++i) {
            const SaveEntry& save = saves[i];
            const auto load = [this, i, save] {
                if (!save.has_game) return host_.load(i);  // which shows the reason; then another may be chosen
                const std::string question = "Leave this walk and load " + save.name + "?";
                const auto action = closing([this, i] { host_.load(i); });
                if (save.is_of_this_walk && host_.has_unsaved_progress())
                    return ask("Load", question + kLost, "Yes", action);
                leave_walk(question, action);
            };
            page.rows.push_back(save_row(save, save.is_empty ? nullptr : std::function<void()>(load)));
            if (!save.is_empty && !save.has_game)
                page.rows.back().help = host_.key_names().in("{accept} says why it can't be loaded");
        }
        const bool has_saves =
            std::any_of(saves.begin(), saves.end(), [](const SaveEntry& save) { return !save.is_empty; });
        if (has_saves)
            page.add("Delete", "a saved walk", [this] { open_delete(); });
        else
            page.text = "Nothing is saved yet.";
        add_back(page);
        return page;
    });
}

// The page below has an older list, whose entries the program no longer knows.
void MenuPages::open_delete() {
    menu_.open([this, saves = host_.saves()] {
        MenuPage page{"Delete"};
        page.back = [this] {
            menu_.close(2);  // this one, and the list before it
            open_load();
        };
        for (std::size_t i = 0; i < saves.size(); ++i) {
            const SaveEntry& save = saves[i];
            if (save.is_empty) continue;
            const auto remove = [this, i] {
                const std::string fault = host_.remove_save(i);
                menu_.close(3);  // the question, this one, and the list before it
                open_load();
                if (!fault.empty()) open_message("Delete", fault);
            };
            const auto accept = [this, name = save.name, remove] {
                ask("Delete", "Delete " + name + " for good?", "Delete it", remove);
            };
            page.rows.push_back(save_row(save, accept));
        }
        page.add("Back", "", page.back);
        return page;
    });
}

void MenuPages::open_save() {
    menu_.open([this, saves = host_.saves()] {
        MenuPage page{"Save"};
        for (std::size_t i = 0; i < saves.size(); ++i) {
            const SaveEntry& save = saves[i];
            if (!save.is_saved_to_by_player) continue;
            const auto write = [this, i](std::size_t pages) {
                const std::string fault = host_.save(i);
                menu_.close(pages);
                if (fault.empty()) return menu_.close_all();
                open_save();  // anew: another program may have changed the list
                open_message("Save", fault);
            };
            const auto accept = [this, write, name = save.name, is_empty = save.is_empty] {
                if (is_empty) return write(1);
                ask("Save", "Replace what is in " + name + "?", "Replace it",
                    [write] { write(2); });  // the question too
            };
            page.rows.push_back(save_row(save, accept));
        }
        add_back(page);
        return page;
    });
}

}  // namespace oblong
