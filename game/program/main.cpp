namespace oblong {
int start_game(int argument_count, const char* const* arguments);  // program.h, which takes seconds to compile
}

int main(int argc, char** argv) {
    return oblong::start_game(argc, argv);
}
