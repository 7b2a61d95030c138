// The options file: whatever is read is written so that it is read again, and the player's lines stay.

#include "game/options/preference_table.h"
#include "game/options/preferences_store.h"
#include "tests/fuzz/common/fuzz.h"

namespace oblong::fuzz {
namespace {

// The values that a text names.
std::string values_in(const std::string& text, const Preferences& preferences) {
    std::string values;
    for (const KeptValue* value : all_kept_values())
        if (text.find(value->name) != std::string::npos) values += value->name + "=" + value->text(preferences) + "\n";
    return values;
}

std::string some_word(const std::string& text, std::minstd_rand& random) {
    const std::size_t begin = text.find_first_not_of(' ', below(text.size(), random));
    return begin == std::string::npos ? text : text.substr(begin, text.find_first_of(" ,", begin) - begin);
}

}  // namespace

void mutate(Bytes& input, std::minstd_rand& random) {
    if (below(3, random) == 0) return mutate_bytes(input, 32);
    const std::span<const KeptValue* const> values = all_kept_values();
    const KeptValue& value = *one_of(values, random);
    const std::string number = std::to_string(odd_number(random));
    const std::string line = value.name + " = " +
                             (below(2, random)   ? some_word(value.values, random)
                              : below(2, random) ? value.text({})
                                                 : number) +
                             "\n";
    std::string text = text_of(input);
    const std::size_t start = text.find('\n', below(text.size(), random));
    text.insert(start == std::string::npos ? 0 : start + 1, line);
    set_text(input, text);
}

void run(Input input) {
    constexpr std::size_t kMost = 1024;  // a longer text takes longer and does nothing else
    const std::string text = text_of(input.first(std::min(input.size(), kMost)));
    const ReadPreferences read = read_preferences(text);
    for (const LineFault& fault : read.faults) expect(fault.line > 0 && !fault.what.empty(), "a fault with a line");
    const std::string values = values_in(text, read.preferences);
    const ReadPreferences again = read_preferences(values);
    expect(again.faults.empty(), "values without a fault: " + values);
    expect(values_in(text, again.preferences) == values, "the values that were written: " + values);

    const KeptValue* changed = all_kept_values()[text.size() % all_kept_values().size()];
    const std::string altered = with_values(text, {changed}, read.preferences);
    expect(changed->text(read_preferences(altered).preferences) == changed->text(read.preferences),
           "the value that was changed: " + changed->name);
}

}  // namespace oblong::fuzz
