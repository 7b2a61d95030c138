namespace oblong {
// Declared in program.h, whose headers take seconds to compile.
int start_game(int argument_count, const char* const* arguments);
}  // namespace oblong

int main(int argc, char** argv) {
    return oblong::start_game(argc, argv);
}
