// Pak files: header and directory.

#include "engine/io/game_files.h"
#include "tests/fuzz/common/fuzz.h"

namespace oblong::fuzz {

void run(Input input) {
    const PakHeader header = read_pak_header(input.first(std::min(input.size(), kPakHeader_bytes)), input.size());
    const Input directory = input.subspan(header.directory_offset, header.directory_length);
    for (const PakEntry& entry : read_pak_directory(directory, header, input.size()))
        expect(!entry.name.empty() && std::uint64_t{entry.offset} + entry.length <= input.size(), "files in the pak");
}

}  // namespace oblong::fuzz
