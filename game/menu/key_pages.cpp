#include <algorithm>
#include <utility>

#include "game/menu/menu_pages.h"

namespace oblong {
namespace {

std::string label_of(Action action) {
    return std::string(row_of(action).label);
}

// The other actions of an action's input: "Jump, Map"; empty if none.
std::string others_of(const std::vector<Conflict>& conflicts, Action action, Input input) {
    std::string others;
    for (const Conflict& conflict : conflicts) {
        if (conflict.input != input ||
            std::find(conflict.actions.begin(), conflict.actions.end(), action) == conflict.actions.end())
            continue;
        for (const Action other : conflict.actions)
            if (other != action) others += (others.empty() ? "" : ", ") + label_of(other);
    }
    return others;
}

bool has_conflict(const std::vector<Conflict>& conflicts, Action action) {
    return std::any_of(conflicts.begin(), conflicts.end(), [&](const Conflict& conflict) {
        return std::find(conflict.actions.begin(), conflict.actions.end(), action) != conflict.actions.end();
    });
}

// The pages of keys. It is copied into their functions.
class KeyPages {
  public:
    KeyPages(Menu& menu, MenuHost& host, KeyUndo& undo) : menu_(&menu), host_(&host), undo_(&undo) {}

    void open() const {
        menu_->open([*this] { return list_page(); });
    }

  private:
    template <class Change>
    void change(Change change) const {
        Bindings& bindings = host_->preferences().bindings;
        *undo_ = bindings;
        change(bindings);
    }
    void bind(Action action, Input input) const {
        change([&](Bindings& bindings) { bindings.bind(action, input); });
    }

    // A second undo is a redo.
    void add_undo(MenuPage& page) const {
        if (!*undo_ || **undo_ == host_->preferences().bindings) return;
        page.add("Undo the last change", "the last change of keys",
                 [*this] { change([before = **undo_](Bindings& bindings) { bindings = before; }); });
    }

    MenuPage list_page() const {
        MenuPage page{"Keys"};
        page.help = host_->key_names().in("{accept} changes what is chosen");
        const std::vector<Conflict> conflicts = conflicts_of(host_->preferences().bindings);
        for (const ActionRow& names : all_actions()) {
            const Action action = names.action;
            const bool is_doubled = has_conflict(conflicts, action);
            const auto accept = [*this, action] { menu_->open([*this, action] { return action_page(action); }); };
            page.add(std::string(names.label), is_doubled ? "! A key here has another use too" : "", accept).value =
                (is_doubled ? "! " : "") + inputs_text(*host_, action);
        }
        add_undo(page);
        add_sets(page);
        page.add("Back", "", [*this] { menu_->close(); });
        return page;
    }

    void add_sets(MenuPage& page) const {
        constexpr std::array<std::pair<Hands, const char*>, kHandsCount> kSets{
            {{Hands::Both, "All defaults"},
             {Hands::Left, "All for the left hand"},
             {Hands::Right, "All for the right hand"}}};
        for (const auto& [hands, label] : kSets)
            page.add(label, "resets all keys",
                     [*this, of = hands] { menu_->open([*this, of] { return set_page(of); }); });
    }

    MenuPage set_page(Hands hands) const {
        MenuPage page{"Keys", "Reset all keys? Your changes are lost."};
        page.add("No", "", [*this] { menu_->close(); });
        page.add("Yes", "", [*this, hands] {
            change([&](Bindings& bindings) { bindings = default_bindings(hands); });
            menu_->close();
        });
        return page;
    }

    MenuPage action_page(Action action) const {
        MenuPage page{label_of(action)};
        const std::vector<Conflict> conflicts = conflicts_of(host_->preferences().bindings);
        for (const Input input : host_->preferences().bindings.inputs_of(action)) {
            const std::string others = others_of(conflicts, action, input);
            const auto remove = [*this, action, input] {
                change([&](Bindings& bindings) { bindings.unbind(action, input); });
            };
            page.add(host_->local_name_of(input), others.empty() ? "" : "also does: " + others, remove).value =
                "remove";
        }
        page.add("Add a key or button", "",
                 [*this, action] { menu_->open([*this, action] { return press_page(action); }); });
        page.first_chosen = page.rows.size() - 1;
        add_undo(page);
        page.add("Done", "", [*this] { menu_->close(); });
        return page;
    }

    MenuPage press_page(Action action) const {
        MenuPage page{label_of(action), "Press a key, or a button of the mouse or gamepad, for: " + label_of(action) +
                                            ".\n\n" + host_->key_names().of(Action::Menu) + ": none."};
        page.press = [*this, action](Input input) {
            menu_->close();
            const std::string others = others_if_bound(action, input);
            if (others.empty()) return bind(action, input);
            menu_->open([*this, action, input, others] { return conflict_page(action, input, others); });
        };
        return page;
    }

    std::string others_if_bound(Action action, Input input) const {
        Bindings tried = host_->preferences().bindings;
        tried.bind(action, input);
        return others_of(conflicts_of(tried), action, input);
    }

    MenuPage conflict_page(Action action, Input input, const std::string& others) const {
        const std::string name = host_->local_name_of(input);
        MenuPage page{label_of(action), name + " does something already: " + others + "."};
        page.add("Take it from there", "", [*this, action, input] {
            change([&](Bindings& bindings) {
                for (const ActionRow& names : all_actions())
                    if (is_other(action, names.action, input)) bindings.unbind(names.action, input);
                bindings.bind(action, input);
            });
            menu_->close();
        });
        page.add("Let it do both", "", [*this, action, input] {
            bind(action, input);
            menu_->close();
        });
        page.add("Keep it as it was", "", [*this] { menu_->close(); });
        return page;
    }

    // Whether an input bound to both actions would conflict.
    static bool is_other(Action action, Action other, Input input) {
        Bindings both;
        both.bind(action, input);
        both.bind(other, input);
        return action != other && !conflicts_of(both).empty();
    }

    Menu* menu_;
    MenuHost* host_;
    KeyUndo* undo_;
};

}  // namespace

void open_key_pages(Menu& menu, MenuHost& host, KeyUndo& undo) {
    KeyPages(menu, host, undo).open();
}

std::string inputs_text(MenuHost& host, Action action) {
    std::string text;
    for (const Input input : host.preferences().bindings.inputs_of(action))
        text += (text.empty() ? "" : ", ") + host.local_name_of(input);
    return text.empty() ? "none" : text;
}

}  // namespace oblong
