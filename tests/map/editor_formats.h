#pragma once

#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

/// TrenchBroom's formats, by the grammars of its manual and sources (version 9 of game configurations), and of these
/// only the part that Oblong's files need: so that what passes here passes there.
namespace oblong::test {

using EditorVariables = std::map<std::string, std::string>;

/// A string with its ${...} replaced. Throws std::out_of_range for one that `variables` lacks.
std::string interpolated(const std::string& text, const EditorVariables& variables);

/// The game's configuration, the ways to compile and the ways to start it. The editor's language is JSON with remarks
/// and expressions; of these only a list of the variable `scale` is read, as text. Throws std::exception for what the
/// editor does not read: a missing value, one of another type, another version.
nlohmann::json read_game_config(std::string_view text);
nlohmann::json read_compilation_config(std::string_view text);
nlohmann::json read_engine_config(std::string_view text);

struct EditorClass {
    std::string name, model;                  ///< model: its expression
    std::map<std::string, std::string> keys;  ///< the type of each
};

/// The classes of an FGD file. Throws std::runtime_error with the line of what is wrong, and of what the editor warns
/// of.
std::vector<EditorClass> read_fgd(std::string_view text);

/// The path that a model's expression has for an entity with these keys. Throws std::exception if there is none.
std::string model_path(const std::string& expression, const EditorVariables& keys);

}  // namespace oblong::test
