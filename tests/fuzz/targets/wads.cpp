// WAD2 files: their textures, by the tools' reader and the compiler's, written and read again.

#include "engine/base/text.h"
#include "engine/io/wad.h"
#include "tests/fuzz/common/fuzz.h"
#include "tools/map/source/textures.h"

namespace oblong::fuzz {

void read(Input input) {
    read_wad(input);
}

void run(Input input) {
    constexpr std::size_t kLongestName = 15;  // that is written
    const map::Wad compilers(text_of(input));
    std::vector<MipTexture> textures;
    for (const WadTexture& texture : read_wad(input)) {
        expect(compilers.find(lower_case(texture.name)) != nullptr, "the texture by its name");
        textures.push_back(parse_miptex(texture.miptex));
        textures.back().name = textures.back().name.substr(0, kLongestName);
    }
    const Bytes written = write_wad(textures);
    const std::vector<WadTexture> again = read_wad(written);
    expect(again.size() == textures.size(), "as many textures as were written");
    for (std::size_t i = 0; i < again.size(); ++i)
        expect(parse_miptex(again[i].miptex) == textures[i], "the texture that was written");
}

}  // namespace oblong::fuzz
