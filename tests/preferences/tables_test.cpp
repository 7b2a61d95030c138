#include <gtest/gtest.h>

#include <cstdlib>

#include "engine/files/files.h"
#include "game/options/preference_table.h"
#include "tests/support/folders.h"

// The tables of keys and options on game/README.md are those of the code. OBLONG_WRITE_TABLES=1 writes them anew.
namespace oblong {
namespace {

const std::string kPage = test::source_folder() + "/game/README.md";

std::string text_of_page() {
    const std::vector<std::uint8_t> bytes = read_file(kPage);
    return {bytes.begin(), bytes.end()};
}

/// Of one device kind: "W, Up".
std::string inputs_of(const Bindings& bindings, Action action, bool are_keys) {
    std::string names;
    for (const Input input : bindings.inputs_of(action))
        if ((input.device == Device::Key) == are_keys) names += (names.empty() ? "" : ", ") + name_of(input);
    return names;
}

std::string keys_table() {
    const Bindings both = default_bindings(), left = default_bindings(Hands::Left),
                   right = default_bindings(Hands::Right);
    const auto if_other = [](const std::string& keys, const std::string& usual) { return keys == usual ? "" : keys; };
    std::string table = "| does | key | left hand | right hand | mouse, gamepad | `bind-` |\n|---|---|---|---|---|---|\n";
    for (const ActionRow& row : all_actions()) {
        const std::string keys = inputs_of(both, row.action, true);
        table += "| " + std::string(row.label) + " | " + keys + " | " +
                 if_other(inputs_of(left, row.action, true), keys) + " | " +
                 if_other(inputs_of(right, row.action, true), keys) + " | " + inputs_of(both, row.action, false) +
                 " | `" + std::string(row.name) + "` |\n";
    }
    return table;
}

std::string options_table() {
    std::string table = "| page | option | values | usual | what |\n|---|---|---|---|---|\n";
    for (const Preference& row : all_preferences())
        if (!row.name.starts_with("dial-"))
            table += std::string("| ") + name_of(row.page) + " | `" + row.name + "` | " + row.values + " | " +
                     row.text(Preferences{}) + " | " + row.help + " |\n";
    return table;
}

void expect_on_page(const std::string& name, const std::string& table) {
    const std::string begin = "<!-- " + name + " -->\n", end = "<!-- end of " + name + " -->";
    std::string page = text_of_page();
    const std::size_t from = page.find(begin), to = page.find(end);
    ASSERT_TRUE(from != page.npos && to != page.npos && from < to) << name;
    const std::size_t first = from + begin.size();
    if (std::getenv("OBLONG_WRITE_TABLES") != nullptr) {
        page.replace(first, to - first, table);
        write_file(kPage, std::vector<std::uint8_t>(page.begin(), page.end()));
        return;
    }
    EXPECT_EQ(page.substr(first, to - first), table) << "OBLONG_WRITE_TABLES=1 writes it";
}

TEST(Tables, OfKeysIsTheCodes) {
    expect_on_page("keys", keys_table());
}

TEST(Tables, OfOptionsIsTheCodes) {
    expect_on_page("options", options_table());
}

}  // namespace
}  // namespace oblong
