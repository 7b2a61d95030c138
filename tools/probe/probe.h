#pragma once

#include <iosfwd>
#include <string>
#include <string_view>

#include "tools/probe/queries.h"

namespace oblong {

/// Answers queries about the engine's arithmetic, a line each: README.md.
class Probe {
  public:
    /// `accuracy`: the dials of the stages that it queries.
    explicit Probe(const Accuracy& accuracy = {}) : accuracy_(accuracy) {}

    /// The answer's line, without its end; `unsupported` for anything but a query. Never throws on bad input.
    std::string answer(std::string_view line);

  private:
    Accuracy accuracy_;
    LastLevel levels_;
};

/// Answers every line of `in` by a line on `out`, in order.
void answer_lines(const Accuracy& accuracy, std::istream& in, std::ostream& out);

}  // namespace oblong
