// A program of somebody else.
#include <oblong.h>

#include <cstdio>

int main() {
    std::printf("%s\n", oblong::version());
}
