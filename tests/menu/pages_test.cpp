#include <gtest/gtest.h>

#include <set>

#include "engine/base/text.h"
#include "engine/platform/headless.h"
#include "game/menu/menu_pages.h"
#include "tests/support/palettes.h"

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
                end_fault.empty() ? "e1m2" : "", end_fault};
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
    bool is_of_museum = true;
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
    void choose(const std::string& label) {
        for (std::size_t i = 0; i <= menu_.page().rows.size(); ++i, act(MenuAction::Down))
            if (menu_.page().rows[menu_.chosen()].label == label) return act(MenuAction::Accept);
        FAIL() << "no row " << label << " in " << menu_.page().title;
    }

    FakeHost host_;
    Menu menu_;
    KeyUndo undo_;
    MenuPages pages_{menu_, host_};
};

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

TEST_F(Pages, TheTitleHasWhatAPlayerLooksFor) {
    pages_.open_title();
    std::vector<std::string> labels;
    for (const MenuRow& row : menu_.page().rows) {
        labels.push_back(row.label);
        EXPECT_EQ(row.help.find("museum"), std::string::npos) << "other games have the same page";
    }
    EXPECT_EQ(labels, (std::vector<std::string>{"Continue", "Walk", "Visit", "Levels", "Load", "Options", "Gallery",
                                                "Credits", "Quit"}));
    choose("Walk");
    EXPECT_EQ(host_.done, std::vector<std::string>{"walk"});
    EXPECT_FALSE(menu_.is_open());
}

TEST_F(Pages, AGameWithoutGalleryHasNoRowForIt) {
    host_.is_of_museum = false;
    for (const auto open : {&MenuPages::open_title, &MenuPages::open_game}) {
        (pages_.*open)();
        for (const MenuRow& row : menu_.page().rows) EXPECT_NE(row.label, "Gallery");
    }
}

TEST_F(Pages, EscapeOnTheTitleAsksAndEscapeAgainGoesOn) {
    pages_.open_title();
    for (int i = 0; i < 9; ++i) {
        escape();
        EXPECT_EQ(menu_.page().title, "Quit");
        EXPECT_EQ(menu_.page().rows[menu_.chosen()].label, "No") << "an answer by mistake loses nothing";
        escape();
        EXPECT_EQ(menu_.page().title, "OBLONG");
    }
    EXPECT_TRUE(host_.done.empty());
    escape();
    choose("Yes");
    EXPECT_EQ(host_.done, std::vector<std::string>{"leave"});
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

TEST_F(Pages, WhatLosesAWalkAsksFirst) {
    host_.has_folder = false;
    pages_.open_game();
    choose("Restart level");
    EXPECT_TRUE(host_.done.empty());
    EXPECT_NE(menu_.page().text.find("is lost"), std::string::npos);
    choose("No");
    EXPECT_EQ(menu_.page().title, "Paused");
    choose("Quit");
    EXPECT_TRUE(host_.done.empty());
    choose("Yes");
    EXPECT_EQ(host_.done, std::vector<std::string>{"leave"});
}

TEST_F(Pages, WhatLosesNothingAsksNothing) {
    host_.is_unsaved = false;
    pages_.open_game();
    choose("Restart level");
    EXPECT_EQ(host_.done, std::vector<std::string>{"restart"});
    host_.is_unsaved = true;
    pages_.open_game();
    choose("Quit");
    EXPECT_EQ(host_.done.back(), "leave");
}

TEST_F(Pages, SlotsAreSavedToAndLoadedFrom) {
    pages_.open_game();
    choose("Save");
    EXPECT_EQ(menu_.page().rows.size(), 4u) << "three slots and Back: the game writes the autosave";
    choose("Slot 1");
    EXPECT_EQ(host_.done.back(), "save 1");
    pages_.open_game();
    choose("Save");
    choose("Slot 2");
    EXPECT_EQ(host_.done.size(), 1u) << "a saved game is replaced only after a question";
    choose("Replace it");
    EXPECT_EQ(host_.done.back(), "save 2");
    host_.is_unsaved = false;
    pages_.open_title();
    choose("Load");
    choose("Slot 1");
    EXPECT_EQ(host_.done.size(), 2u) << "nothing is in it";
    choose("Walk 2");
    EXPECT_EQ(host_.done.back(), "load 0");
}

TEST_F(Pages, AfterAFailedSaveAnotherSlotCanBeChosen) {
    host_.save_fault = "the disk is full";
    for (const char* slot : {"Slot 1", "Slot 2"}) {  // an empty one, and one after a question
        pages_.open_game();
        choose("Save");
        choose(slot);
        if (menu_.page().rows.back().label == "Replace it") choose("Replace it");
        EXPECT_EQ(menu_.page().text, host_.save_fault) << slot;
        choose("OK");
        EXPECT_EQ(menu_.page().rows[0].label, "Slot 1") << "the page Save";
        escape();
        EXPECT_EQ(menu_.page().title, "Paused") << slot;
        escape();
    }
    EXPECT_EQ(host_.done.size(), 2u);
}

TEST_F(Pages, ADamagedWalkIsChosenToLearnWhy) {
    pages_.open_title();
    EXPECT_EQ(menu_.page().rows[0].label, "Continue");
    EXPECT_EQ(menu_.page().rows[0].help, "Damaged");
    choose("Continue");
    EXPECT_EQ(host_.done.back(), "continue");
    pages_.open_title();
    choose("Load");
    EXPECT_EQ(menu_.page().rows[3].help, "Enter says why it can't be loaded");
    choose("Walk 1");
    EXPECT_EQ(host_.done.back(), "load 3");
    EXPECT_EQ(menu_.page().title, "Load") << "another can be chosen";
    pages_.open_game();
    choose("Save");
    EXPECT_EQ(menu_.page().rows[2].label, "Slot 3");
    EXPECT_EQ(menu_.page().rows[2].help, "") << "is replaced there";
}

TEST_F(Pages, TheTitleSaysThatAnEarlierSaveIsContinued) {
    host_.last = FakeHost::list()[2];
    pages_.open_title();
    EXPECT_EQ(menu_.page().rows[0].help, "Continue in demo 1:23");
    host_.last->help = "The save before the last";
    EXPECT_EQ(menu_.page().rows[0].help, "Continue in demo 1:23. The save before the last");
}

// Of the walk that is on: its later part is lost then, though it would be saved on leaving.
TEST_F(Pages, GoingBackInTheWalkThatIsOnAsksFirst) {
    pages_.open_game();
    choose("Load");
    choose("Walk 2");
    EXPECT_TRUE(host_.done.empty());
    choose("No");
    choose("Slot 2");
    EXPECT_EQ(host_.done, std::vector<std::string>{"load 2"}) << "the walk is kept";
}

TEST_F(Pages, WhatIsSavedIsDeletedAfterAQuestion) {
    pages_.open_title();
    choose("Load");
    choose("Delete");
    EXPECT_EQ(menu_.page().rows.size(), 5u) << "all but the empty one, and Back";
    choose("Walk 1");
    choose("No");
    EXPECT_TRUE(host_.done.empty());
    choose("Walk 1");
    choose("Delete it");
    EXPECT_EQ(host_.done, std::vector<std::string>{"remove 3"});
    EXPECT_EQ(menu_.page().title, "Load");
    EXPECT_EQ(menu_.depth(), 2u);
}

// Each list replaces the one before it in the program: what is loaded is an entry of the last.
TEST_F(Pages, TheListOfLoadIsANewOneAfterThatOfDelete) {
    host_.is_unsaved = false;
    for (const bool by_key : {false, true}) {
        pages_.open_title();
        choose("Load");
        choose("Delete");
        host_.lists = 0;
        by_key ? escape() : choose("Back");
        EXPECT_EQ(host_.lists, 1);
        EXPECT_EQ(menu_.page().title, "Load");
        EXPECT_EQ(menu_.depth(), 2u);
        menu_.close_all();
    }
}

TEST_F(Pages, TheEndLeadsOn) {
    pages_.open_end();
    EXPECT_NE(menu_.page().text.find("12:34"), std::string::npos);
    for (const char* line :
         {"\nLenses found: 12 of 12", "\nSecrets found: 1 of 4", "\nPicture (bounded): 486", "\nMissed: an egg"})
        EXPECT_NE(menu_.page().text.find(line), std::string::npos) << menu_.page().text;
    choose("Picture");
    EXPECT_TRUE(host_.done.back().ends_with(
        "\nTime: 12:34\nLenses found: 12 of 12\nSecrets found: 1 of 4\nPicture (bounded): 486"))
        << host_.done.back();
    EXPECT_EQ(menu_.page().title, "Picture");
    choose("OK");
    choose("On to e1m2");
    EXPECT_EQ(host_.done.back(), "next");
    pages_.open_end();
    choose("Again");
    EXPECT_EQ(host_.done.back(), "restart");
}

TEST_F(Pages, TheEndSaysWhichLevelIsMissing) {
    host_.end_fault = "e1m2.bsp: open: no such level in maps, expected one";
    pages_.open_end();
    EXPECT_NE(menu_.page().text.find(host_.end_fault), std::string::npos) << menu_.page().text;
}

TEST_F(Pages, PreferencesChangeAtOnce) {
    pages_.open_game();
    choose("Options");
    choose("Comfort");
    const auto row = [&] { return menu_.page().rows[menu_.chosen()]; };
    while (row().label != "Text size") act(MenuAction::Down);
    act(MenuAction::Right);
    EXPECT_EQ(host_.kept.text_scale, 2);
    act(MenuAction::Left);
    EXPECT_EQ(host_.kept.text_scale, 1);
}

TEST_F(Pages, KeysAreAddedRemovedAndConflictsShown) {
    open_key_pages(menu_, host_, undo_);
    choose("Jump, swim up");
    choose("Add a key or button");
    press("J");
    EXPECT_NE(inputs_text(host_, Action::Jump).find("J"), std::string::npos);
    choose("Add a key or button");
    press("W");  // walks ahead
    EXPECT_EQ(menu_.page().rows.size(), 3u) << menu_.page().text;
    escape();
    EXPECT_EQ(inputs_text(host_, Action::Jump).find("W"), std::string::npos);
    choose("Add a key or button");
    press("W");
    choose("Let it do both");
    EXPECT_EQ(conflicts_of(host_.kept.bindings).size(), 1u);
    escape();
    EXPECT_EQ(menu_.page().rows[menu_.chosen()].value.substr(0, 2), "! ");
    choose("Jump, swim up");
    choose("W");  // removes it
    EXPECT_TRUE(conflicts_of(host_.kept.bindings).empty());
    choose("Add a key or button");
    press("W");
    choose("Take it from there");
    EXPECT_TRUE(conflicts_of(host_.kept.bindings).empty());
    EXPECT_EQ(inputs_text(host_, Action::Forward).find("W"), std::string::npos);
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

TEST_F(Pages, AllKeysAreSetAnewOnlyAfterAQuestion) {
    host_.kept.bindings.unbind_all(Action::Jump);
    open_key_pages(menu_, host_, undo_);
    choose("All defaults");
    choose("No");
    EXPECT_TRUE(host_.kept.bindings.inputs_of(Action::Jump).empty());
    choose("All defaults");
    choose("Yes");
    EXPECT_EQ(host_.kept.bindings, default_bindings());
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
