#include <CLI/CLI.hpp>
#include <iostream>

#include "tools/cli/program.h"
#include "tools/probe/probe.h"

int main(int argc, char** argv) {
    constexpr const char* kProgram = "oblong-probe";
    CLI::App app("Answers queries about the engine's arithmetic: one a line on standard input.", kProgram);
    app.set_version_flag("--version", std::string(kProgram) + " " + OBLONG_VERSION);
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        return app.exit(error) == 0 ? 0 : 2;
    }
    std::ios::sync_with_stdio(false);
    std::cin.tie(nullptr);
    return oblong::run_program(kProgram, [] { oblong::answer_lines(std::cin, std::cout); });
}
