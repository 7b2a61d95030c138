#pragma once

#include <gtest/gtest.h>
#include <sys/wait.h>

#include <cstdlib>
#include <string>
#include <vector>

#include "tests/support/folders.h"

/// Runs the programs of the build.
namespace oblong::test {

struct Outcome {
    int exit_code = -1;  ///< -1 if a signal ended it
    std::string error;   ///< what it said on standard error
};

/// Runs a line of the shell, whose standard output goes to `output`.
inline Outcome run_line(const std::string& line, const std::string& output = "/dev/null") {
    const TemporaryFolder folder;
    const std::string errors = folder.path("error");
    const int status = std::system((line + " </dev/null >'" + output + "' 2>'" + errors + "'").c_str());
    const std::vector<std::uint8_t> error = read_file_bytes(errors);
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, std::string(error.begin(), error.end())};
}

/// Words of such a line: build/bin/NAME, and what comes before it where the user's files are in a folder of the test's.
inline std::string program(const std::string& name) {
    return "'" + build_folder() + "/bin/" + name + "'";
}
inline std::string at_home_in(const std::string& folder) {
    return "XDG_CONFIG_HOME='" + folder + "' XDG_DATA_HOME='" + folder + "' ";
}

/// Runs build/bin/WORDS[0] with the other words as its arguments.
inline Outcome run_program(const std::vector<std::string>& words, const std::string& output = "/dev/null") {
    std::string line = program(words[0]);
    for (std::size_t i = 1; i < words.size(); ++i) line += " '" + words[i] + "'";
    return run_line(line, output);
}

/// It failed as it should: exit code 1 and a line `PROGRAM: FILE: ...` with `where` in it.
inline testing::AssertionResult names_fault(const Outcome& outcome, const std::string& program, const std::string& file,
                                            const std::string& where) {
    if (outcome.exit_code == 1 && outcome.error.starts_with(program + ": " + file + ": ") &&
        outcome.error.find(where) != std::string::npos)
        return testing::AssertionSuccess();
    return testing::AssertionFailure() << "exit code " << outcome.exit_code << ", said: " << outcome.error
                                       << "expected the file " << file << " and '" << where << "'";
}

}  // namespace oblong::test
