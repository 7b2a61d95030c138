#pragma once

#include <iosfwd>
#include <optional>
#include <string>
#include <string_view>

#include "engine/accuracy/accuracy.h"
#include "engine/level/level.h"
#include "tools/probe/fields.h"

namespace oblong {

// One function for each query: reads the fields after the query's name, calls the engine, returns the answer's line.
// Throws Unsupported. The protocol is in README.md. `accuracy`: the dials of the stages.

std::string answer_project(Fields& fields, const Accuracy& accuracy);
std::string answer_view(Fields& fields, const Accuracy& accuracy);
std::string answer_coverage(Fields& fields, const Accuracy& accuracy);
std::string answer_mesh(Fields& fields, const Accuracy& accuracy);
std::string answer_texspan(Fields& fields, const Accuracy& accuracy);
std::string answer_texspanq(Fields& fields, const Accuracy& accuracy);
std::string answer_modes(Fields& fields, const Accuracy& accuracy);
std::string answer_clip(Fields& fields, const Accuracy& accuracy);
std::string answer_sine(Fields& fields, const Accuracy& accuracy);
std::string answer_cosine(Fields& fields, const Accuracy& accuracy);
std::string answer_root(Fields& fields, const Accuracy& accuracy);
std::string answer_reciprocal(Fields& fields, const Accuracy& accuracy);

/// Answers queries about the engine's arithmetic, a line each: README.md.
class Probe {
  public:
    /// `accuracy`: the dials of the stages that it queries.
    explicit Probe(const Accuracy& accuracy = {}) : accuracy_(accuracy) {}

    /// The answer's line, without its end; `unsupported` for anything but a query. Never throws on bad input.
    std::string answer(std::string_view line);

  private:
    std::string answer_leaf(Fields& fields);

    Accuracy accuracy_;
    // Of the last query: queries for many points of one level read it once.
    std::string level_path_;
    std::optional<Level> level_;  // none: it can't be read
};

/// Answers every line of `in` by a line on `out`, in order.
void answer_lines(const Accuracy& accuracy, std::istream& in, std::ostream& out);

}  // namespace oblong
