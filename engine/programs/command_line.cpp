#include "engine/programs/command_line.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>

#include "engine/base/input_error.h"
#include "engine/base/text.h"
#include "engine/io/files.h"
#include "engine/programs/arguments.h"

namespace oblong {

namespace {

constexpr const char* kNoDash = "no dash";

std::string fault_of_empty(const std::string& text) {
    return text.empty() ? "is empty, expected a value" : "";
}

std::string fault_of_dash(const std::string& text) {
    return text == "-" ? "'-' is neither standard input nor output here, expected a name" : "";
}

}  // namespace

CommandOption& CommandOption::require() {
    option_->required();
    return *this;
}

CommandOption& CommandOption::limit(std::int64_t least, std::int64_t most) {
    option_->check(CLI::Range(least, most));
    return *this;
}

CommandOption& CommandOption::need(const CommandOption& other) {
    option_->needs(other.option_);
    return *this;
}

CommandOption& CommandOption::exclude(const CommandOption& other) {
    option_->excludes(other.option_);
    return *this;
}

CommandOption& CommandOption::accept_standard_output() {
    option_->get_validator(kNoDash)->active(false);
    return *this;
}

CommandOption& CommandOption::accept_no_value(const std::string& instead) {
    option_->expected(0, 1)->default_str(instead);
    return *this;
}

template <class Value>
CommandOption CommandArguments::add(const std::string& names, Value& value, const std::string& help) {
    CLI::Option* const option = app_->add_option(names, value, help);
    if (value != Value{}) option->capture_default_str();
    option->check(fault_of_empty, "");
    option->check(fault_of_dash, "", kNoDash);
    if constexpr (std::is_same_v<Value, std::vector<std::string>>)
        if (names.starts_with('-'))  // --wad A --wad B, so that a positional argument may follow
            option->expected(1)->multi_option_policy(CLI::MultiOptionPolicy::TakeAll)->allow_extra_args(false);
    return CommandOption(option);
}

template CommandOption CommandArguments::add(const std::string&, std::string&, const std::string&);
template CommandOption CommandArguments::add(const std::string&, std::vector<std::string>&, const std::string&);
template CommandOption CommandArguments::add(const std::string&, std::int64_t&, const std::string&);

void CommandArguments::add_flag(const std::string& names, bool& value, const std::string& help) {
    app_->add_flag(names, value, help);
}

void CommandArguments::add_switch(const std::string& name, std::string& value, const std::string& help) {
    app_->add_flag("--" + name + ",!--no-" + name, value, help);
}

CommandArguments CommandArguments::add_command(const std::string& name, const std::string& help) {
    app_->require_subcommand(1);
    return CommandArguments(app_->add_subcommand(name, help));
}

bool CommandArguments::is_given() const {
    return app_->parsed();
}

CommandLine::CommandLine(const std::string& program, const std::string& description)
    : CommandLine(std::make_shared<CLI::App>(description, program)) {
    owned_->set_version_flag("--version", program + " " + OBLONG_VERSION);
}

CommandLine::CommandLine(std::shared_ptr<CLI::App> app) : CommandArguments(app.get()), owned_(std::move(app)) {}

int CommandLine::run(int argument_count, const char* const* arguments, const std::function<void()>& body) {
    const std::string program = owned_->get_name();
    owned_->failure_message([&](const CLI::App*, const CLI::Error& error) {
        constexpr std::size_t kMost = 1000;  // the message names all unexpected arguments
        return program + ": " + shortened(error.what(), kMost) + "\nRun it with --help for more information.\n";
    });
    try {
        parse(argument_count, arguments);
    } catch (const CLI::ParseError& error) {
        constexpr int kWrongUsage = 2;
        return owned_->exit(error) == 0 ? run_program(program, [] {}) : kWrongUsage;
    }
    return run_program(program, body);
}

// CLI11 reports missing arguments first, but misspelt ones are more often the cause.
void CommandLine::parse(int argument_count, const char* const* arguments) {
    try {
        owned_->parse(argument_count, arguments);
    } catch (const CLI::RequiredError&) {
        const std::vector<std::string> unknown = owned_->remaining(true);
        if (unknown.empty()) throw;
        throw CLI::ExtrasError(owned_->get_name(), unknown);
    }
}

void check_replaces_none(const std::string& option, const std::string& written, const std::vector<std::string>& read) {
    const auto is_written = [&](const std::string& file) {
        std::error_code none;
        return !file.empty() && (file == written || std::filesystem::equivalent(file, written, none));
    };
    if (std::any_of(read.begin(), read.end(), is_written))
        throw UsageError(option + ": '" + written + "' is read or written for another option, expected another name");
}

void check_replaces_only(const std::string& option, const std::string& written, const std::string& kind,
                         const std::vector<std::string_view>& beginnings) {
    std::error_code none;
    const std::string text = std::filesystem::is_regular_file(written, none) ? read_text(written) : "";
    if (!text.empty() && std::none_of(beginnings.begin(), beginnings.end(),
                                      [&](std::string_view beginning) { return text.starts_with(beginning); }))
        throw UsageError(option + ": '" + written + "' is there and no " + kind +
                         ", expected one to replace or another name");
}

}  // namespace oblong
