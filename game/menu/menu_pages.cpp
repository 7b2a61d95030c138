#include "game/menu/menu_pages.h"

#include <utility>

#include "engine/base/text.h"

namespace oblong {
namespace {

std::string lines_of_end(const EndFigures& figures) {
    std::string text = "Time: " + figures.time;
    for (const std::string& line : {figures.lenses, figures.secrets, figures.picture})
        if (!line.empty()) text += "\n" + line;
    return text;
}

std::string text_of_end(const EndFigures& figures) {
    std::string text = figures.message + "\n\n" + lines_of_end(figures);
    if (!figures.missed.empty()) text += "\n" + figures.missed;
    if (!figures.fault.empty()) text += "\n\nThe next level cannot be played: " + figures.fault;
    return text;
}

}  // namespace

void MenuPages::open_title() {
    menu_.open([this] { return title_page(); });
}

void MenuPages::open_game() {
    menu_.open([this] { return game_page(); });
}

void MenuPages::open_gallery() {
    menu_.open([this] {
        MenuPage page{"Gallery"};
        page.add("Resume", "", [this] { menu_.close_all(); });
        add_keys(page);
        page.add("Title", "", closing([this] { host_.show_title(); }));
        page.add("Quit", "", [this] { host_.leave(); });
        return page;
    });
}

void MenuPages::open_end() {
    menu_.open([this, figures = host_.end_figures()] { return end_page(figures); });
}

void MenuPages::open_restart() {
    const auto restart = closing([this] { host_.restart(); });
    if (!host_.has_unsaved_progress()) return restart();
    const char* const what = host_.can_save() ? " This walk stays saved: Load continues it." : kLost;
    ask("Restart", std::string("Begin this level again?") + what, "Yes", restart);
}

void MenuPages::open_message(std::string title, std::string text) {
    menu_.open([this, title = std::move(title), text = std::move(text)] {
        MenuPage page{title, text};
        page.add("OK", "", [this] { menu_.close(); });
        return page;
    });
}

void MenuPages::open_pages(const std::string& text) {
    open_page_of(split(text, std::string_view(&kNewPage, 1)), 1);
}

// Page 0 is the heading.
void MenuPages::open_page_of(const std::vector<std::string>& pages, std::size_t number) {
    const auto turning_to = [this, pages](std::size_t other) {
        return [this, pages, other] {
            menu_.close();
            if (other < pages.size()) open_page_of(pages, other);
        };
    };
    menu_.open([pages, number, turning_to] {
        const std::size_t last = pages.size() - 1;
        MenuPage page{pages[0], pages[number]};
        page.add(number < last ? "Next" : "OK", "", turning_to(number + 1));
        if (number > 1) page.add("Back", "", turning_to(number - 1));
        if (last > 1) page.help = "Page " + std::to_string(number) + " of " + std::to_string(last);
        return page;
    });
}

MenuPage MenuPages::title_page() {
    MenuPage page{host_.game_title()};
    page.is_title = true;
    page.back = [this] { ask("Quit", "Quit Oblong?", "Yes", [this] { host_.leave(); }); };
    if (const auto last = host_.last_walk()) {
        const std::string help = last->help.empty() ? "" : ". " + last->help;
        page.add("Continue", last->has_game ? "continue in " + last->content + help : last->content,
                 closing([this] { host_.continue_walk(); }));
    }
    page.add("Walk", "a new walk, from the beginning", closing([this] { host_.walk(); }));
    if (host_.has_visit()) page.add("Visit", "a new walk through open doors", closing([this] { host_.visit(); }));
    page.add("Levels", "other levels", [this] { open_levels(); });
    page.add("Load", "a walk that was saved", [this] { open_load(); });
    page.add("Options", "", [this] { open_options(); });
    if (host_.has_gallery())
        page.add("Gallery", "what the engine can do, a page for each feature", [this] { host_.show_gallery(); });
    page.add("Credits", "", [this] { open_text("Credits", host_.credits(), {}); });
    page.add("Quit", "", [this] { host_.leave(); });
    page.help = host_.key_names().in("{choose} choose, {accept} accepts, {menu} goes back");
    return page;
}

MenuPage MenuPages::game_page() {
    MenuPage page{"Paused"};
    page.help = host_.key_names().in("{choose} choose, {accept} accepts, {menu} resumes");
    page.add("Resume", "", [this] { menu_.close_all(); });
    if (host_.can_save()) page.add("Save", "", [this] { open_save(); });
    page.add("Load", "", [this] { open_load(); });
    if (const Goal goal = host_.goal(); !goal.count.empty()) {
        page.add(goal.title, goal.hint.empty() ? "which are found, and which are missing" : goal.hint,
                 [this, goal] { open_text(goal.title, goal.list, {}); });
        page.rows.back().value = goal.count;
    }
    if (!host_.messages().empty()) page.add("Messages", "texts shown in this walk", [this] { open_messages(); });
    page.add("Options", "", [this] { open_options(); });
    add_keys(page);
    page.add("Restart level", "", [this] { open_restart(); });
    page.add("Levels", "", [this] { open_levels(); });
    if (host_.has_gallery()) page.add("Gallery", "the walk is paused meanwhile", [this] { host_.show_gallery(); });
    page.add("Title", host_.can_save() ? "The walk is saved: Continue resumes it" : "",
             [this] { leave_walk("Leave this walk?", closing([this] { host_.show_title(); })); });
    page.add("Quit", host_.can_save() ? "The walk is saved: Continue resumes it" : "",
             [this] { leave_walk("Quit the game?", [this] { host_.leave(); }); });
    return page;
}

MenuPage MenuPages::end_page(const EndFigures& figures) {
    MenuPage page{"The end", text_of_end(figures)};
    page.back = closing([this] { host_.show_title(); });
    if (!figures.next_level.empty())
        page.add("On to " + figures.next_level, "", closing([this] { host_.play_next(); }));
    page.add("Again", "", closing([this] { host_.restart(); }));
    if (figures.is_lost) page.add("Load", "", [this] { open_load(); });
    page.add("Picture", "this view with these figures under it, to share", [this, text = lines_of_end(figures)] {
        open_message("Picture", host_.key_names().in(host_.save_picture(host_.game_title() + "\n" + text)));
    });
    page.add("Another level", "", [this] { open_levels(); });
    page.add("Title", "", closing([this] { host_.show_title(); }));
    return page;
}

void MenuPages::open_options() {
    menu_.open([this] { return options_page(); });
}

MenuPage MenuPages::options_page() {
    MenuPage page{"Options"};
    page.help = "Changes apply at once and are saved";
    for (int i = 0; i < kPreferencePageCount; ++i) {
        const auto kind = static_cast<PreferencePage>(i);
        page.add(name_of(kind), "", [this, kind] { menu_.open([this, kind] { return preferences_page(kind); }); });
    }
    page.add("Light", "set with a test picture", [this] { open_light(); });
    page.add("Keys", "which key or button does what", [this] { open_key_pages(menu_, host_, key_undo_); });
    add_back(page);
    return page;
}

MenuRow MenuPages::preference_row(const Preference& preference) {
    const std::string keys = preference.keys.empty() ? "" : " (" + host_.key_names().in(preference.keys) + ")";
    return {in_capitals(preference.label, 1), preference.shown(host_.preferences()),
            in_capitals(preference.help, 1) + keys, nullptr,
            [this, &preference](int steps) { preference.change(host_.preferences(), steps); }};
}

MenuPage MenuPages::preferences_page(PreferencePage page) {
    MenuPage shown{name_of(page)};
    for (const Preference& preference : all_preferences())
        if (preference.page == page) shown.rows.push_back(preference_row(preference));
    add_back(shown);
    return shown;
}

void MenuPages::open_levels() {
    menu_.open([this, levels = host_.levels()] {
        MenuPage page{"Levels"};
        for (const LevelEntry& level : levels) {
            const auto go = [this, name = level.name, file = level.file] {
                leave_walk("Leave this walk and go to " + name + "?",
                           closing([this, file] { host_.play_level(file); }));
            };
            page.add(level.name, "", go).value = level.title;
        }
        add_back(page);
        return page;
    });
}

void MenuPages::add_keys(MenuPage& page) {
    page.add("Keys", "all that keys do, also without them", [this] { open_keys(); });
}

void MenuPages::add_back(MenuPage& page) {
    page.add("Back", "", [this] { menu_.close(); });
}

void MenuPages::open_text(std::string title, std::string text, std::optional<Action> closed_by) {
    menu_.open([this, title = std::move(title), text = std::move(text), closed_by] {
        MenuPage page{title, text};
        page.help = host_.key_names().in("{choose}: scroll. {menu} or a click: back");
        page.closed_by = closed_by;
        return page;
    });
}

void MenuPages::open_messages() {
    std::string text;
    for (const std::string& message : host_.messages()) text += (text.empty() ? "" : "\n\n") + message;
    open_text("Messages", text, {});
}

void MenuPages::open_keys() {
    menu_.open([this, help = host_.key_help()] {
        MenuPage page{"Keys"};
        page.help = host_.key_names().in("{choose} choose, {accept} does it, {menu} goes back");
        page.closed_by = Action::ShowHelp;
        for (const KeyHelp& line : help) page.rows.push_back({line.label, line.keys, "", acting(line.actions)});
        page.add("Change keys", "", [this] { open_key_pages(menu_, host_, key_undo_); });
        add_back(page);
        return page;
    });
}

void MenuPages::leave_walk(const std::string& question, std::function<void()> action) {
    if (host_.has_unsaved_progress() && !host_.can_save())
        ask("Not saved", question + kLost, "Yes", std::move(action));
    else
        action();
}

void MenuPages::open_not_saved(const std::string& fault, std::function<void()> go) {
    ask("Not saved", fault + "\n\nLeave this walk anyway?", "Yes", closing(std::move(go)));
}

void MenuPages::ask(std::string title, std::string text, std::string yes, std::function<void()> action) {
    menu_.open(
        [this, title = std::move(title), text = std::move(text), yes = std::move(yes), action = std::move(action)] {
            MenuPage page{title, text};
            page.add("No", "", [this] { menu_.close(); });
            page.add(yes, "", action);
            return page;
        });
}

// Nothing for what must be held, and for what a page cannot do.
std::function<void()> MenuPages::acting(const std::vector<Action>& actions) {
    const Action action = actions.front();
    if (actions.size() > 1 || is_move(action) || action == Action::Menu || action == Action::ShowHelp) return nullptr;
    return closing([this, action] { host_.act(action); });
}

std::function<void()> MenuPages::closing(std::function<void()> action) {
    return [this, action = std::move(action)] {
        menu_.close_all();
        action();
    };
}

}  // namespace oblong
