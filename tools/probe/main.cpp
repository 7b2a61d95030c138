#include <iostream>

#include "engine/io/files.h"
#include "engine/programs/arguments.h"
#include "engine/programs/command_line.h"
#include "tools/probe/probe.h"

int main(int argc, char** argv) {
    oblong::CommandLine line("oblong-probe",
                             "Answers queries about the engine's arithmetic: one a line on standard input.");
    std::vector<std::string> dials;
    line.add("--dial", dials, "NAME=VALUE; may be given several times (README)");
    return line.run(argc, argv, [&] {
        const oblong::Accuracy accuracy = oblong::parse_accuracy(oblong::Preset::Bounded, dials);
        std::ios::sync_with_stdio(false);
        std::cin.tie(nullptr);
        oblong::answer_lines(accuracy, std::cin, std::cout);
        if (std::cin.bad()) throw oblong::FileError("standard input", "read", "failed, expected it to be readable");
        if (!std::cout.flush())
            throw oblong::FileError("standard output", "write", "failed, expected it to be writable");
    });
}
