#include "tools/probe/probe.h"

#include <array>
#include <istream>
#include <ostream>

#include "engine/io/files.h"
#include "engine/level/bsp_read.h"
#include "engine/level/side.h"

namespace oblong {

namespace {

struct NamedQuery {
    std::string_view name;
    std::string (*answer)(Fields&, const Accuracy&);
};

constexpr std::array kQueries = {NamedQuery{"project", answer_project},   NamedQuery{"view", answer_view},
                                 NamedQuery{"coverage", answer_coverage}, NamedQuery{"mesh", answer_mesh},
                                 NamedQuery{"texspan", answer_texspan},   NamedQuery{"texspanq", answer_texspanq},
                                 NamedQuery{"modes", answer_modes},       NamedQuery{"clip", answer_clip},
                                 NamedQuery{"sin", answer_sine},          NamedQuery{"cos", answer_cosine},
                                 NamedQuery{"sqrt", answer_root},         NamedQuery{"recip", answer_reciprocal}};

std::optional<Level> read_level(const std::string& path) {
    constexpr std::size_t kLargestLevel = std::size_t{1} << 28;
    try {
        return read_bsp(read_file(path, kLargestLevel));
    } catch (const std::runtime_error&) {
        return std::nullopt;
    }
}

}  // namespace

std::string Probe::answer_leaf(Fields& fields) {
    const std::string path(fields.text());
    const auto point = convert<World>(fields.point());
    fields.expect_end();

    if (level_path_ != path) {
        level_ = read_level(path);
        level_path_ = path;
    }
    if (!level_) throw Unsupported{};
    const LeafIndex index = find_leaf(*level_, level_->world(), point);
    return std::to_string(index.number()) + ' ' + std::to_string(level_->leaves[index].contents);
}

std::string Probe::answer(std::string_view line) {
    try {
        Fields fields(line);
        const std::string_view name = fields.text();
        if (name == "leaf") return answer_leaf(fields);
        for (const NamedQuery& query : kQueries)
            if (query.name == name) return query.answer(fields, accuracy_);
    } catch (const Unsupported&) {
    }
    return "unsupported";
}

void answer_lines(const Accuracy& accuracy, std::istream& in, std::ostream& out) {
    Probe probe(accuracy);
    std::string line;
    while (std::getline(in, line)) {
        if (line.ends_with('\r')) line.pop_back();
        out << probe.answer(line) << '\n';
        // Flushed only if no query is waiting: interactive clients get each answer, batches are not slowed.
        if (in.rdbuf()->in_avail() <= 0) out.flush();
    }
    out.flush();
}

}  // namespace oblong
