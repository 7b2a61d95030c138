#pragma once

#include <gtest/gtest.h>
#include <sys/wait.h>

#include <cstdlib>
#include <string>
#include <vector>

#include "tests/support/bsp_writer.h"
#include "tests/support/folders.h"

namespace oblong::test {

struct Outcome {
    int exit_code = -1;  ///< -1 if a signal ended it
    std::string error;   ///< what it said on standard error
};

/// Runs build/bin/WORDS[0] with the other words as its arguments; its standard output goes to `output`.
inline Outcome run_program(const std::vector<std::string>& words, const std::string& output = "/dev/null") {
    const TemporaryFolder folder;
    std::string line = "'" + test::build_folder() + "/bin/" + words[0] + "'";
    for (std::size_t i = 1; i < words.size(); ++i) line += " '" + words[i] + "'";
    line += " </dev/null >'" + output + "' 2>'" + folder.path("error") + "'";
    const int status = std::system(line.c_str());
    const std::vector<std::uint8_t> error = read_file_bytes(folder.path("error"));
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, std::string(error.begin(), error.end())};
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
