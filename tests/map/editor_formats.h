#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

/// TrenchBroom's formats, read by the grammars of its manual and sources (version 9 of game configurations): strictly,
/// so that what passes here passes there.
namespace oblong::test {

/// A value of its expression language.
struct EditorValue {
    enum class Kind { Undefined, Boolean, Number, Text, List, Map };

    Kind kind = Kind::Undefined;
    double number = 0;  ///< 0 or 1 of a Boolean
    std::string text;
    std::vector<EditorValue> list;
    std::map<std::string, EditorValue> map;

    /// A member of a map. Throws std::runtime_error where there is none, as for all below of another kind.
    const EditorValue& at(const std::string& key) const;
    const std::string& as_text() const;
    double as_number() const;
    const std::vector<EditorValue>& as_list() const;
};

using EditorVariables = std::map<std::string, EditorValue>;

/// Evaluates an expression that takes all of `text`; names stand for variables, unknown ones are Undefined. Throws
/// std::runtime_error with the offset of what is wrong.
EditorValue evaluate(std::string_view text, const EditorVariables& variables = {});

/// A string with its ${...} evaluated: an Undefined one is an error.
std::string interpolated(const std::string& text, const EditorVariables& variables);

/// The game's configuration, the ways to compile and the ways to start it, evaluated. Throws std::runtime_error for
/// what the editor does not read: a missing value, one of another type, another version.
EditorValue read_game_config(std::string_view text);
EditorValue read_compilation_config(std::string_view text);
EditorValue read_engine_config(std::string_view text);

struct EditorKey {
    std::string name, type, description, usual;
    std::map<std::string, std::string> values;
};

struct EditorClass {
    std::string kind, name, model, size;  ///< model: its expression
    std::vector<EditorKey> keys;
};

/// The classes of an FGD file. Throws std::runtime_error with the line of what is wrong, and of what the editor warns
/// of.
std::vector<EditorClass> read_fgd(std::string_view text);

}  // namespace oblong::test
