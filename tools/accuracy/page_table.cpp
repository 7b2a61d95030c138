#include "tools/accuracy/page_table.h"

#include "engine/base/input_error.h"
#include "tools/accuracy/numbers.h"

namespace oblong {

std::string preset_table(const Report& report) {
    std::string table =
        "| preset | texels out of place, pixels: rms | largest | pixels of a wrong face, of 1,000 | 386 at 33 | 486 at "
        "66 | Pentium at 90 MHz |\n|---|---|---|---|---|---|---|\n";
    for (const Configurations::Row& preset : report.configurations.presets) {
        const SettingResult& result = report.results[preset.index];
        const bool is_default = preset.index == report.configurations.default_index;
        table += is_default ? "| **" + preset.name + "** |" : "| " + preset.name + " |";
        const auto add = [&](double value) { table += " " + number_text(value) + " |"; };
        add(result.errors.displacement.rms);
        add(result.errors.displacement.max);
        add(result.errors.wrong.rms);
        for (std::size_t i = 0; i < kProcessors.size(); ++i) add(frame_rate(kProcessors[i], result.cost.cycles[i]));
        table += "\n";
    }
    return table;
}

std::string with_table(const std::string& page, const std::string& file, const std::string& table) {
    const std::string begin = "<!-- oblong-accuracy -->\n", end = "<!-- end -->";
    const std::size_t first = page.find(begin), last = page.find(end, first);
    if (first == std::string::npos || last == std::string::npos)
        throw InputError(
            file, "lines '<!-- oblong-accuracy -->' and '<!-- end -->' are missing, expected a table between them");
    return page.substr(0, first + begin.size()) + table + page.substr(last);
}

}  // namespace oblong
