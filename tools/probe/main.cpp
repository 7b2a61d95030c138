#include <iostream>

#include "tools/common/command_line.h"
#include "tools/probe/probe.h"

int main(int argc, char** argv) {
    oblong::CommandLine line("oblong-probe",
                             "Answers queries about the engine's arithmetic: one a line on standard input.");
    return line.run(argc, argv, [] {
        std::ios::sync_with_stdio(false);
        std::cin.tie(nullptr);
        oblong::answer_lines(std::cin, std::cout);
    });
}
