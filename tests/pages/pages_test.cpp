#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <iterator>
#include <map>
#include <set>
#include <sstream>

#include "engine/io/files.h"
#include "tests/pages/tables.h"
#include "tests/support/folders.h"
#include "tests/support/patterns.h"

namespace oblong::test {
namespace {

namespace fs = std::filesystem;

/// The project's pages: all files .md but those of builds and of hidden folders.
std::vector<fs::path> all_pages() {
    std::vector<fs::path> pages;
    for (auto entry = fs::recursive_directory_iterator(source_folder()); entry != fs::end(entry); ++entry) {
        const std::string name = entry->path().filename().string();
        if (entry->is_directory() && (name.starts_with('.') || fs::exists(entry->path() / "CMakeCache.txt")))
            entry.disable_recursion_pending();
        else if (entry->path().extension() == ".md")
            pages.push_back(entry->path());
    }
    std::sort(pages.begin(), pages.end());
    return pages;
}

const std::map<std::string, std::function<std::string()>> kTables{{"actions", action_table},
                                                                  {"options", option_table},
                                                                  {"dials", dial_table},
                                                                  {"classes", class_table},
                                                                  {"entity keys", entity_key_table},
                                                                  {"left out", left_out_table},
                                                                  {"library", library_table},
                                                                  {"first program", first_program},
                                                                  {"inputs", input_table},
                                                                  {"game members", game_member_table},
                                                                  {"examples", example_table}};

/// A page whose blocks "<!-- table NAME -->" to "<!-- end -->" are the tables of these names, which go to `found`.
std::string with_tables(std::string page, std::set<std::string>& found) {
    for (const auto& [name, table] : kTables) {
        const std::string begin = "<!-- table " + name + " -->\n", end = "<!-- end -->";
        const std::size_t first = page.find(begin);
        if (first == std::string::npos) continue;
        found.insert(name);
        const std::size_t from = first + begin.size();
        page.replace(from, page.find(end, from) - from, table());
    }
    return page;
}

/// OBLONG_WRITE_PAGES=1 build/bin/test_pages puts the tables into the pages.
TEST(Pages, TablesAreThoseOfTheCode) {
    std::set<std::string> found;
    for (const fs::path& path : all_pages()) {
        const std::string page = read_text(path.string()), wanted = with_tables(page, found);
        if (page == wanted) continue;
        if (std::getenv("OBLONG_WRITE_PAGES") != nullptr)
            write_file(path.string(), wanted);
        else
            ADD_FAILURE() << path << " has other tables than the code: OBLONG_WRITE_PAGES=1 build/bin/test_pages";
    }
    EXPECT_EQ(found.size(), kTables.size());
}

/// Whatever the header declares with parentheses, comments and bodies aside.
TEST(Pages, AllOfTheLibraryIsOnItsPage) {
    const std::string page = read_text(source_folder() + "/engine/library/README.md");
    std::istringstream lines(read_text(source_folder() + "/engine/library/oblong.h"));
    std::set<std::string> names;
    for (std::string line; std::getline(lines, line);) {
        line = with_replaced(line, "//.*|\\{ .*", "");
        if (line.find("= delete") != line.npos || line.find("operator") != line.npos) continue;
        for (const Groups& name : all_matches(line, R"((\w+)\()")) names.insert(name[1]);
    }
    EXPECT_GT(names.size(), 60u);
    for (const std::string& one : names)
        EXPECT_TRUE(is_found(page, "\\b" + one + "\\(")) << one << "() is not on the page";
}

/// What GitHub calls a heading in a link: "## Add a dial!" is "add-a-dial".
std::set<std::string> anchors_of(const std::string& page) {
    std::set<std::string> anchors;
    std::istringstream lines(page);
    for (std::string line; std::getline(lines, line);) {
        if (!line.starts_with('#')) continue;
        std::string anchor;
        for (const char letter : line.substr(line.find_first_not_of("# "))) {
            if (letter == ' ' || letter == '-') anchor += '-';
            if (std::isalnum(static_cast<unsigned char>(letter)) != 0 || letter == '_')
                anchor += static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
        }
        anchors.insert(anchor);
    }
    return anchors;
}

TEST(Pages, EveryLinkLeadsToAFileAndAHeading) {
    int count = 0;
    for (const fs::path& path : all_pages()) {
        const std::string page = read_text(path.string());
        for (const Groups& link : all_matches(page, R"(\]\(([^)#\s]*)(#([^)\s]*))?\))")) {
            const std::string &target = link[1], &anchor = link[3];
            if (target.find("://") != std::string::npos) continue;
            const fs::path file = target.empty() ? path : path.parent_path() / target;
            EXPECT_TRUE(fs::exists(file)) << path << ": " << target;
            const bool has_anchor =
                anchor.empty() || (fs::exists(file) && anchors_of(read_text(file.string())).contains(anchor));
            EXPECT_TRUE(has_anchor) << path << ": " << link[0];
            ++count;
        }
    }
    EXPECT_GT(count, 50);
}

/// Files that pages name by a path from the project's folder or from their own, as `tests/demo/walk_test.cpp`.
TEST(Pages, EverySourceFileThatTheyNameIsThere) {
    const std::string name = R"(`((?!build)[a-z_]+(/[a-z0-9_]+)+\.(cpp|h|py|csv|map))`)";
    const fs::path project = source_folder();
    for (const fs::path& path : all_pages()) {
        const std::string page = read_text(path.string());
        for (const Groups& named : all_matches(page, name)) {
            const std::string& file = named[1];
            const bool is_there = fs::exists(project / file) || fs::exists(path.parent_path() / file) ||
                                  fs::exists(project / "engine" / file);
            EXPECT_TRUE(is_there) << path << ": " << file;
        }
    }
}

/// Words of letters or digits: bars of tables are none.
std::ptrdiff_t count_words(const std::string& page) {
    std::istringstream text(page);
    return std::count_if(std::istream_iterator<std::string>(text), {}, [](const std::string& word) {
        return std::any_of(word.begin(), word.end(), [](unsigned char letter) { return std::isalnum(letter) != 0; });
    });
}

TEST(Pages, AreShort) {
    std::ptrdiff_t words = 0;
    for (const fs::path& path : all_pages())
        words += count_words(with_replaced(read_text(path.string()), "<!-- table [^]*?<!-- end -->", ""));
    EXPECT_LE(words, 10'000) << "beside the tables of the code";
    const std::string first = read_text(source_folder() + "/README.md");
    EXPECT_LE(std::count(first.begin(), first.end(), '\n'), 120);
}

}  // namespace
}  // namespace oblong::test
