#include <oblong.h>

int main() try {
    oblong::Window window("Game");
    do {
        oblong::clear(window.canvas());
        oblong::fill_circle(window.canvas(), window.mode(), window.mouse().column, window.mouse().row, 9, 180);
    } while (window.show() && !window.is_down("Escape"));
} catch (const std::exception& error) {
    return oblong::report(error);
}
