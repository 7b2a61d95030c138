#include <gtest/gtest.h>

#include <set>

#include "engine/base/text.h"
#include "engine/platform/headless.h"
#include "game/menu/menu_pages.h"
#include "tests/support/palettes.h"
#include "tests/support/script.h"

namespace oblong::test::pages_test {
namespace {

constexpr CanvasSize kCanvas{320, 200};

// A program that only notes what it is asked to do.
class FakeHost final : public MenuHost {
  public:
    Preferences& preferences() override { return kept; }
    KeyNames key_names() const override { return {kept.bindings, platform, false}; }
    std::string local_name_of(Input input) const override { return name_of(input); }
    std::vector<KeyHelp> key_help() const override { return game_help(key_names()); }
    std::string game_title() const override { return "OBLONG"; }
    Goal goal() const override {
        return {"Lenses", "11 of 12", "Missing: FOG (north)", "RAIN: found\nFOG: missing (north)"};
    }
    std::vector<std::string> messages() const override { return {"You carry a lens.", std::string(300, 'm')}; }
    std::string figures() const override { return "12 figures"; }
    std::vector<LevelEntry> levels() const override {
        return {{"demo", "", "The museum"}, {"e1m1", "maps/e1m1.bsp", "the Slipgate Complex"}};
    }
    std::vector<SaveEntry> saves() override {
        ++lists;
        return list();
    }
    static std::vector<SaveEntry> list() {
        const auto pixels = std::make_shared<std::vector<Rgb8>>(std::vector<Rgb8>{{255, 0, 0}, {0, 255, 0}});
        const SaveEntry empty{"Slot 1", "empty", "", true, true, false, false, std::nullopt};
        const SaveEntry full{"Slot 2", "demo 1:23", "", true, false, true, false, MenuPicture{2, 1, pixels}};
        const SaveEntry damaged{"Walk 1", "damaged", "", false, false, false, false, std::nullopt};
        const SaveEntry own{"Walk 2", "demo 0:10", "", false, false, true, true, std::nullopt};
        const SaveEntry damaged_slot{"Slot 3", "damaged", "", true, false, false, false, std::nullopt};
        return {own, empty, full, damaged, damaged_slot};
    }
    std::optional<SaveEntry> last_walk() const override { return last ? *last : list()[3]; }
    EndFigures end_figures() const override {
        return {"You have seen the museum.",     "12:34",          "Lenses found: 12 of 12",
                "Secrets found: 1 of 4",         "Missed: an egg", "Picture (bounded): 486",
                end_fault.empty() ? "e1m2" : "", end_fault,        is_lost};
    }
    std::string credits() const override { return std::string(2000, 'c'); }
    bool can_save() const override { return has_folder; }
    bool has_unsaved_progress() const override { return is_unsaved; }
    void act(Action action) override { done.push_back(std::string(row_of(action).name)); }
    void walk() override { done.push_back("walk"); }
    bool has_visit() const override { return true; }
    bool has_gallery() const override { return is_of_museum; }
    void visit() override { done.push_back("visit"); }
    void continue_walk() override { done.push_back("continue"); }
    void restart() override { done.push_back("restart"); }
    void play_level(const std::string& name) override { done.push_back("level " + name); }
    void play_next() override { done.push_back("next"); }
    std::string save_picture(const std::string& text) override {
        done.push_back("picture " + text);
        return "{screenshot} Saved";
    }
    std::string save(std::size_t entry) override {
        done.push_back("save " + std::to_string(entry));
        return save_fault;
    }
    void load(std::size_t entry) override { done.push_back("load " + std::to_string(entry)); }
    std::string remove_save(std::size_t entry) override {
        done.push_back("remove " + std::to_string(entry));
        return "";
    }
    void show_title() override { done.push_back("title"); }
    void show_gallery() override { done.push_back("gallery"); }
    void leave() override { done.push_back("leave"); }

    const HeadlessPlatform platform{1, 35, nullptr, nullptr};
    Preferences kept;
    std::optional<SaveEntry> last;
    std::string end_fault, save_fault;
    std::vector<std::string> done;
    int lists = 0;  // how often they were asked for
    bool is_of_museum = true, is_lost = false;
    bool has_folder = true, is_unsaved = true;
};

class Pages : public testing::Test {
  protected:
    void act(MenuAction action) {
        Controls controls;
        controls.menu = {action};
        menu_.handle(controls, kCanvas, 1, {0, 0, 320, 200});
    }
    void escape() {
        Controls controls;
        controls.commands = {Action::Menu};
        menu_.handle(controls, kCanvas, 1, {0, 0, 320, 200});
    }
    void press(const char* key) {
        Controls controls;
        controls.pressed = input_named(key);
        menu_.handle(controls, kCanvas, 1, {0, 0, 320, 200});
    }
    // By the keys, from wherever the page is.
    void go_to(const std::string& label) {
        for (std::size_t i = 0; i <= menu_.page().rows.size(); ++i, act(MenuAction::Down))
            if (menu_.page().rows[menu_.chosen()].label == label) return;
        FAIL() << "no row " << label << " in " << menu_.page().title;
    }
    void choose(const std::string& label) {
        go_to(label);
        act(MenuAction::Accept);
    }

    FakeHost host_;
    Menu menu_;
    KeyUndo undo_;
    MenuPages pages_{menu_, host_};
};

/// What a player does on the pages, and what they show and have the program do:
///
///     open title              the pages of title, game, end or keys, a book, a note; `lost`, `without saves`, `saved`:
///     of the program Load; Slot 1            rows that are chosen, by the keys; `escape`, `press KEY`, `go to ROW`,
///     `left`, `right` : title = Load, row0 = Walk 2, help0 = "", rows = 4, chosen = No, text has 12:34, closed : did =
///     load 0, all = 2 what the program did last, and how many things in all : jump has J, conflicts = 1, scale = 2
class PageScript : private Pages {
  public:
    void run(const Script& script) {
        for (const ScriptLine& line : script_lines(script.text)) {
            SCOPED_TRACE(line.text);
            for (const Words& words : line.actions) do_one(words);
            for (const Words& words : line.checks) check(words);
        }
    }

  private:
    void TestBody() override {}
    void do_one(const Words& words) {
        const std::string what = joined(words), rest = joined(words, 1);
        if (words[0] == "open") {
            menu_.close_all();
            host_.is_lost = what == "open lost end";
            if (rest == "title") pages_.open_title();
            if (rest == "game") pages_.open_game();
            if (rest == "end" || rest == "lost end") pages_.open_end();
            if (rest == "book") pages_.open_pages("The diary\fMonday.\fTuesday.\fToday.");
            if (rest == "note") pages_.open_pages("\fOne page.");
            if (rest == "keys") open_key_pages(menu_, host_, undo_);
        } else if (what == "without saves")
            host_.has_folder = false;
        else if (what == "saved" || what == "unsaved")
            host_.is_unsaved = what == "unsaved";
        else if (what == "an earlier save")
            host_.last = FakeHost::list()[2];
        else if (words[0] == "told")
            host_.last->help = rest;
        else if (words[0] == "fault")
            host_.save_fault = host_.end_fault = rest;
        else if (words[0] == "unbind")
            host_.kept.bindings.unbind_all(Action::Jump);
        else if (what == "escape")
            escape();
        else if (what == "left" || what == "right")
            act(what == "left" ? MenuAction::Left : MenuAction::Right);
        else if (words[0] == "press")
            press(rest.c_str());
        else if (words[0] == "go")
            go_to(joined(words, 2));
        else
            choose(what);
    }
    void check(const Words& words) {
        if (words.size() == 1) {
            EXPECT_FALSE(menu_.is_open());
            return;
        }
        const std::string found = value(words[0]), wanted = joined(words, 2);
        const bool has_part = found.find(wanted) != std::string::npos;
        EXPECT_TRUE(words[1] == "=" ? found == wanted : has_part == (words[1] == "has"))
            << joined(words) << ": is " << found;
    }
    std::string value(const std::string& name) {
        if (name == "did") return host_.done.empty() ? "" : host_.done.back();
        if (name == "all") return std::to_string(host_.done.size());
        if (name == "jump") return inputs_text(host_, Action::Jump);
        if (name == "ahead") return inputs_text(host_, Action::Forward);
        if (name == "conflicts") return std::to_string(conflicts_of(host_.kept.bindings).size());
        if (name == "defaults") return host_.kept.bindings == default_bindings() ? "yes" : "no";
        if (name == "scale") return std::to_string(host_.kept.text_scale);
        if (name == "depth") return std::to_string(menu_.depth());
        const MenuPage page = menu_.page();
        if (name == "title") return page.title;
        if (name == "text") return page.text;
        if (name == "rows") return std::to_string(page.rows.size());
        if (name == "chosen") return page.rows.at(menu_.chosen()).label;
        if (name == "value") return page.rows.at(menu_.chosen()).value;
        const MenuRow& row = page.rows.at(static_cast<std::size_t>(name.back() - '0'));
        return name.starts_with("row") ? row.label : row.help;
    }
};

constexpr Script kPageScripts[] = {
    {"TheTitleHasWhatAPlayerLooksFor", R"(
        open title: rows = 9, row0 = Continue, row1 = Walk, row2 = Visit, row3 = Levels, row4 = Load, row5 = Options
        : row6 = Gallery, row7 = Credits, row8 = Quit
        Walk: did = walk, all = 1, closed
    )"},
    {"EscapeOnTheTitleAsksAndEscapeAgainGoesOn", R"(
        open title
        escape: title = Quit, chosen = No       # an answer by mistake loses nothing
        escape: title = OBLONG
        escape: title = Quit, chosen = No
        escape: title = OBLONG, all = 0
        escape; Yes: did = leave, all = 1
    )"},
    {"WhatLosesAWalkAsksFirst", R"(
        without saves; open game; Restart level: all = 0, text has is lost
        No: title = Paused
        Quit: all = 0
        Yes: did = leave, all = 1
    )"},
    {"WhatLosesNothingAsksNothing", R"(
        saved; open game; Restart level: did = restart, all = 1
        unsaved; open game; Quit: did = leave
    )"},
    {"SlotsAreSavedToAndLoadedFrom", R"(
        open game; Save: rows = 4       # three slots and Back: the game writes the autosave
        Slot 1: did = save 1
        open game; Save; Slot 2: all = 1        # a saved game is replaced only after a question
        Replace it: did = save 2
        saved; open title; Load; Slot 1: all = 2        # nothing is in it
        Walk 2: did = load 0
    )"},
    {"AfterAFailedSaveAnotherSlotCanBeChosen", R"(
        fault the disk is full; open game; Save; Slot 1: text = the disk is full
        OK: row0 = Slot 1
        escape: title = Paused
        Save; Slot 2; Replace it: text = the disk is full
        OK: row0 = Slot 1, all = 2
        escape: title = Paused
    )"},
    {"ADamagedWalkIsChosenToLearnWhy", R"(
        open title: row0 = Continue, help0 = Damaged
        Continue: did = continue
        open title; Load: help3 = Enter says why it can't be loaded
        Walk 1: did = load 3, title = Load      # another can be chosen
        open game; Save: row2 = Slot 3, help2 =         # is replaced there
    )"},
    {"TheTitleSaysThatAnEarlierSaveIsContinued", R"(
        an earlier save; open title: help0 = Continue in demo 1:23
        told The save before the last: help0 = Continue in demo 1:23. The save before the last
    )"},
    // Of the walk that is on: its later part is lost then, though it would be saved on leaving.
    {"GoingBackInTheWalkThatIsOnAsksFirst", R"(
        open game; Load; Walk 2: all = 0
        No; Slot 2: did = load 2, all = 1       # the walk is kept
    )"},
    {"WhatIsSavedIsDeletedAfterAQuestion", R"(
        open title; Load; Delete: rows = 5      # all but the empty one, and Back
        Walk 1; No: all = 0
        Walk 1; Delete it: did = remove 3, all = 1, title = Load, depth = 2
    )"},
    {"TheEndLeadsOn", R"(
        open end: text has 12:34, text has Lenses found: 12 of 12, text has Secrets found: 1 of 4
        : text has Picture (bounded): 486, text has Missed: an egg
        Picture: title = Picture, did has Time: 12:34, did has Lenses found: 12 of 12, did has Secrets found: 1 of 4
        : did has Picture (bounded): 486, did lacks Missed
        OK; On to e1m2: did = next
        open end; Again: did = restart
    )"},
    {"TheEndSaysWhichLevelIsMissing", R"(
        fault "e1m2.bsp: open: no such level in maps, expected one"; open end: text has "e1m2.bsp: open: no such level in maps, expected one"
    )"},
    {"WhoHasLostMayLoad", R"(
        open lost end; Load; Slot 2: did = load 2
    )"},
    {"PagesAreTurned", R"(
        open book: title = The diary, text = Monday., rows = 1
        Next: text = Tuesday., rows = 2
        Back: text = Monday.
        Next; Next: title = The diary, text = Today.
        OK: closed
        open book; Next; escape: closed
        open note: title = , text = One page., rows = 1
        OK: closed
    )"},
    {"PreferencesChangeAtOnce", R"(
        open game; Options; Comfort; go to Text size; right: scale = 2
        left: scale = 1
    )"},
    {"KeysAreAddedRemovedAndConflictsShown", R"(
        open keys; Jump, swim up; Add a key or button; press J: jump has J
        Add a key or button; press W: rows = 3      # it walks ahead
        escape: jump lacks W
        Add a key or button; press W; Let it do both: conflicts = 1
        escape: value has "! "
        Jump, swim up; W: conflicts = 0     # removes it
        Add a key or button; press W; Take it from there: conflicts = 0, ahead lacks W
    )"},
    {"AllKeysAreSetAnewOnlyAfterAQuestion", R"(
        unbind jump; open keys; All defaults; No: jump = none
        All defaults; Yes: defaults = yes
    )"},
};
void run_pages(const Script& script) {
    PageScript().run(script);
}
OBLONG_SCRIPTS(PageScripts, kPageScripts, run_pages);

// Of hundreds of walks, several times a frame.
TEST_F(Pages, PicturesOfSavesAreNotCopiedEachTimeAPageIsMade) {
    for (const char* list : {"Load", "Save"}) {
        pages_.open_game();
        choose(list);
        const MenuPage page = menu_.page(), again = menu_.page();
        const auto has_picture = [](const MenuRow& row) { return row.picture.has_value(); };
        const auto row = std::find_if(page.rows.begin(), page.rows.end(), has_picture);
        ASSERT_NE(row, page.rows.end());
        EXPECT_EQ(row->picture->pixels, again.rows[static_cast<std::size_t>(row - page.rows.begin())].picture->pixels);
    }
}

// Other games have the same page.
TEST_F(Pages, TheTitleDoesNotNameTheMuseum) {
    pages_.open_title();
    for (const MenuRow& row : menu_.page().rows) EXPECT_EQ(row.help.find("museum"), std::string::npos);
}

TEST_F(Pages, AGameWithoutGalleryHasNoRowForIt) {
    host_.is_of_museum = false;
    for (const auto open : {&MenuPages::open_title, &MenuPages::open_game}) {
        (pages_.*open)();
        for (const MenuRow& row : menu_.page().rows) EXPECT_NE(row.label, "Gallery");
    }
}

// Opens every page that can be reached and leaves each by Escape: nothing is done by that.
class EveryPage : public Pages {
  protected:
    void visit(int levels) {
        const std::size_t depth = menu_.depth();
        seen_.insert(menu_.page().title);
        for (const MenuRow& row : menu_.page().rows)
            EXPECT_EQ(row.help, in_capitals(row.help, 1)) << menu_.page().title << ": " << row.label;
        for (std::size_t row = 0; row < menu_.page().rows.size(); ++row) {
            const MenuRow chosen = menu_.page().rows[row];
            if (!chosen.accept || is_final(chosen.label) || chosen.value == "remove" || is_of_a_key(chosen)) continue;
            for (std::size_t i = 0; i < menu_.page().rows.size() && menu_.chosen() != row; ++i) act(MenuAction::Down);
            ASSERT_EQ(menu_.chosen(), row) << chosen.label << " can't be chosen";
            act(MenuAction::Accept);
            ASSERT_TRUE(menu_.is_open()) << chosen.label << " closes the menu";
            if (menu_.depth() <= depth) continue;
            if (levels > 0) visit(levels - 1);
            while (menu_.depth() > depth) escape();
        }
    }
    // Rows that do something at once, or answer.
    static bool is_final(const std::string& label) {
        static const std::set<std::string> kFinal{"Resume",  "OK",   "No",       "Yes",        "Back",     "Done",
                                                  "Gallery", "Walk", "Continue", "Replace it", "Delete it"};
        return kFinal.contains(label) || label == "Slot 1" || label == "Slot 3" || label == "Walk 1" || label == "Quit";
    }
    bool is_of_a_key(const MenuRow& row) const {
        const std::vector<KeyHelp> help = host_.key_help();
        return menu_.page().closed_by == Action::ShowHelp &&
               std::any_of(help.begin(), help.end(), [&](const KeyHelp& line) { return line.label == row.label; });
    }
    std::set<std::string> seen_;
};

TEST_F(EveryPage, OfAWalkIsReachedAndLeftWithoutLoss) {
    pages_.open_game();
    choose("Save");
    visit(4);
    menu_.close_all();
    host_.has_folder = false;  // so that leaving asks
    pages_.open_game();
    visit(4);
    EXPECT_TRUE(host_.done.empty()) << host_.done.front();
    for (const char* title : {"Paused", "Save", "Load", "Options", "Picture", "Accuracy", "Comfort", "Controls",
                              "Sound", "Light", "Keys", "Levels", "Not saved"})
        EXPECT_TRUE(seen_.contains(title)) << title;
    escape();
    EXPECT_FALSE(menu_.is_open());
}

// A pad has fewer buttons than there are actions, a touch screen four.
TEST_F(Pages, DoWithoutAKeyAllThatNeedsNotBeHeld) {
    std::vector<std::string> expected;
    for (const ActionRow& row : all_actions()) {
        if (is_move(row.action) || row.help.empty() || row.action == Action::Menu || row.action == Action::ShowHelp)
            continue;
        expected.emplace_back(row.name);
        pages_.open_game();
        choose("Keys");
        choose(std::string(row.help));
        EXPECT_FALSE(menu_.is_open());
    }
    EXPECT_EQ(host_.done, expected);
    EXPECT_GT(expected.size(), 25u);
}

// However it was made: added, removed, taken from elsewhere, all set anew.
TEST_F(Pages, TheLastChangeOfAKeyIsUndone) {
    open_key_pages(menu_, host_, undo_);
    const auto undo_and_redo = [&](const Bindings& before) {
        const Bindings after = host_.kept.bindings;
        EXPECT_NE(before, after);
        choose("Undo the last change");
        EXPECT_EQ(host_.kept.bindings, before);
        choose("Undo the last change");
        EXPECT_EQ(host_.kept.bindings, after);
        choose("Undo the last change");
    };
    const Bindings at_first = host_.kept.bindings;
    choose("Jump, swim up");
    for (const MenuRow& row : menu_.page().rows) EXPECT_NE(row.label, "Undo the last change") << "nothing was changed";
    choose("Add a key or button");
    press("J");
    undo_and_redo(at_first);
    choose("Space");  // removes it
    undo_and_redo(at_first);
    choose("Add a key or button");
    press("W");
    choose("Take it from there");
    undo_and_redo(at_first);
    escape();
    choose("All for the left hand");
    choose("Yes");
    undo_and_redo(at_first);
}

// Every page, drawn at every size, in a canvas with a border around it.
TEST_F(EveryPage, CanBeDrawnAtAnySize) {
    const Palette palette = test::grey_palette();
    const MenuLook look(palette);
    for (const auto open :
         {&MenuPages::open_title, &MenuPages::open_game, &MenuPages::open_end, &MenuPages::open_gallery}) {
        (pages_.*open)();
        for (const CanvasSize size :
             {CanvasSize{320, 200}, CanvasSize{160, 100}, CanvasSize{8, 8}, CanvasSize{640, 480}})
            for (const std::int32_t text_scale : {1, 2}) {
                constexpr std::int32_t kBorder_px = 20;
                const std::int32_t pitch = size.width_px + 2 * kBorder_px;
                std::vector<std::uint8_t> pixels(static_cast<std::size_t>(pitch * (size.height_px + 2 * kBorder_px)),
                                                 7);
                const Framebuffer canvas{pixels.data() + kBorder_px * pitch + kBorder_px, size.width_px, size.height_px,
                                         pitch};
                menu_.draw(text_scale, look, palette, canvas);
                for (std::int32_t y = 0; y < size.height_px; ++y)
                    std::fill_n(canvas.row(y), size.width_px, std::uint8_t{7});
                EXPECT_EQ(std::set<std::uint8_t>(pixels.begin(), pixels.end()).size(), 1u);
            }
        menu_.close_all();
    }
}

}  // namespace
}  // namespace oblong::test::pages_test
