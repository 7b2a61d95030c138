// TGA, BMP and JPEG files, 255 pixels a side at most: larger ones take longer and do nothing else.

#include "engine/pictures/picture.h"
#include "tests/fuzz/common/fuzz.h"

namespace oblong::fuzz {

void mutate(Bytes& input, std::minstd_rand&) {
    mutate_bytes(input);
    const auto clear = [&](std::size_t at) {
        if (at < input.size()) input[at] = 0;
    };
    if (input.size() < 2) return;
    if (input[0] == 'B') {
        for (const std::size_t at : {20u, 21u, 24u, 25u})
            if (at < input.size() && input[at] != 0xff) input[at] = 0;
    } else if (input[0] != 0xff) {
        for (const std::size_t at : {13u, 15u}) clear(at);
    }
    for (std::size_t at = 0; at + 1 < input.size(); ++at)
        if (input[at] == 0xff && input[at + 1] >= 0xc0 && input[at + 1] <= 0xc2)
            for (const std::size_t high : {5u, 7u}) clear(at + high);
}

void read(Input input) {
    decode_picture(input);
}

void run(Input input) {
    const PngImage image = decode_picture(input);
    expect(image.width_px > 0 && image.height_px > 0, "a picture of some size");
    const std::size_t pixels = image.indices.empty() ? image.colours.size() : image.indices.size();
    expect(pixels == static_cast<std::size_t>(image.width_px) * static_cast<std::size_t>(image.height_px),
           "as many pixels");
}

}  // namespace oblong::fuzz
