#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace oblong {

/// A value of a JSON file (RFC 8259), which knows its place there, as "/classes/item_coin/is".
class JsonValue {
  public:
    using Members = std::vector<std::pair<std::string, JsonValue>>;

    JsonValue(std::string file, std::string where) : file_(std::move(file)), where_(std::move(where)) {}

    /// Throws FileError: the file, the place, and `what`.
    [[noreturn]] void refuse(const std::string& what) const;

    // These refuse a value of another type.
    const std::string& text() const;  ///< in UTF-8
    const Members& members() const;   ///< in the file's order, each name once
    const Members& elements() const;  ///< of a list; their names are "0", "1" ...

  private:
    friend class JsonReader;

    std::string file_, where_;
    std::string_view type_;  ///< null, boolean, number, string, array or object
    std::string text_;
    Members parts_;
};

/// Reads a whole file's text. Throws FileError with the number of the first byte (from 1) that is no JSON, and for a
/// name that is in an object twice. The texts of numbers are checked, but not kept.
JsonValue parse_json(const std::string& file, std::string_view text);

}  // namespace oblong
