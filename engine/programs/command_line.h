#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

// CLI11 takes long to compile, so only this file's source includes it.
namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace oblong {

/// An option that was added, for further settings.
class CommandOption {
  public:
    explicit CommandOption(CLI::Option* option) : option_(option) {}

    CommandOption& require();
    CommandOption& limit(std::int64_t least, std::int64_t most);  ///< to a whole number from `least` to `most`
    CommandOption& need(const CommandOption& other);              ///< only together with `other`
    CommandOption& exclude(const CommandOption& other);           ///< never together with `other`
    CommandOption& accept_standard_output();                      ///< as "-"
    CommandOption& accept_no_value(const std::string& instead);   ///< the name alone stands for this value

  private:
    CLI::Option* option_;
};

/// What may follow a command: options, positional arguments, and subcommands.
class CommandArguments {
  public:
    explicit CommandArguments(CLI::App* app) : app_(app) {}

    /// `names` such as "-o,--out"; a name without a dash is a positional argument. The variable's value is the default,
    /// and --help shows it unless it is empty or 0. For std::string, a vector of them (one or more may be given) and
    /// std::int64_t. An empty value is refused: in scripts it is an unset variable. So is "-", which elsewhere means
    /// standard input or output, unless the option accepts it.
    template <class Value>
    CommandOption add(const std::string& names, Value& value, const std::string& help);
    void add_flag(const std::string& names, bool& value, const std::string& help);
    /// --NAME and --no-NAME set `value` to "true" or "false"; --NAME=TEXT sets it to TEXT.
    void add_switch(const std::string& name, std::string& value, const std::string& help);

    /// A subcommand; one of them must be given.
    CommandArguments add_command(const std::string& name, const std::string& help);
    bool is_given() const;

  private:
    CLI::App* app_;
};

/// The command line of a program; it has --help and --version.
class CommandLine : public CommandArguments {
  public:
    CommandLine(const std::string& program, const std::string& description);

    /// Reads the arguments and runs `body` as run_program() does; returns the program's exit code: 0 after --help and
    /// --version, 2 for wrong usage, reported on standard error; both without running `body`.
    int run(int argument_count, const char* const* arguments, const std::function<void()>& body);

  private:
    explicit CommandLine(std::shared_ptr<CLI::App> app);
    void parse(int argument_count, const char* const* arguments);

    std::shared_ptr<CLI::App> owned_;
};

/// Throws UsageError if the file that an option names for writing is one of those that are read. Empty names are no
/// files.
void check_replaces_none(const std::string& option, const std::string& written, const std::vector<std::string>& read);

/// Throws UsageError if the file that an option names for writing is there, is not empty and has none of these
/// beginnings: it is no file of that kind.
void check_replaces_only(const std::string& option, const std::string& written, const std::string& kind,
                         const std::vector<std::string_view>& beginnings);

}  // namespace oblong
