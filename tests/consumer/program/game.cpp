// A program of somebody else's. It prints checksums of a plasma and, given LEVEL.bsp PALETTE MODEL.obj, of the level's
// picture.
#include <oblong.h>

#include <cstdint>
#include <cstdio>
#include <exception>

int main(int argc, char** argv) {
    try {
        std::printf("%s\n", oblong::version());
        oblong::Window window("Plasma");
        const oblong::Framebuffer canvas = window.canvas();
        do {
            for (int y = 0; y < 200; ++y)
                for (int x = 0; x < 320; ++x) canvas.row(y)[x] = static_cast<std::uint8_t>(x * y >> 6);
        } while (window.show());
        std::printf("plasma %08x\n", static_cast<unsigned>(oblong::checksum(canvas)));
        if (argc < 4) return 0;

        const oblong::Palette palette = oblong::load_palette(argv[2]);
        oblong::LevelScene scene(argv[1], palette);
        scene.draw(oblong::pose_at(0, 40, 70, 92, -6), 0, canvas);
        std::printf("level %08x\n", static_cast<unsigned>(oblong::checksum(canvas)));
        const oblong::Model model(argv[3], palette);
        const oblong::Speaker speaker;
        std::printf("model of %d frame\n", model.frame_count());
    } catch (const std::exception& error) {
        std::fprintf(stderr, "game: %s\n", error.what());
        return 1;
    }
}
