// Level files (BSP 29, BSP2, 2PSB): read, played and drawn.

#include "engine/base/checksum.h"
#include "engine/level/bsp_read.h"
#include "tests/fuzz/common/entity_mutator.h"
#include "tests/fuzz/common/played_level.h"
#include "tests/support/bsp_writer.h"

namespace oblong::fuzz {
namespace {

std::size_t version_of(const Bytes& file) {
    for (std::size_t i = 0; i < kBspFormats.size(); ++i)
        if (test::number_at(file, 0, 4) == kBspFormats[i].version) return i;
    return kBspFormats.size();
}

bool has_lumps(const Bytes& file) {
    if (file.size() < kBspHeaderSize || version_of(file) == kBspFormats.size()) return false;
    for (std::size_t lump = 0; lump < kLumpCount; ++lump) {
        const std::uint64_t end =
            std::uint64_t{test::number_at(file, 4 + lump * 8, 4)} + test::number_at(file, 8 + lump * 8, 4);
        if (end > file.size()) return false;
    }
    return true;
}

// Another number in a field of 1, 2 or 4 bytes, one of another record, or one close by; 4 bytes may be a float.
void alter_field(Bytes& lump, std::size_t record, std::minstd_rand& random) {
    const std::size_t size = std::size_t{1} << below(3, random), fields = record / size;
    if (fields == 0 || lump.size() < record) return;
    const std::size_t field = below(fields, random) * size, records = lump.size() / record;
    const std::size_t at = below(records, random) * record + field;
    const int width = static_cast<int>(size);
    const std::int64_t old = test::number_at(lump, at, width);
    const auto as_float = std::bit_cast<float>(static_cast<std::uint32_t>(old));
    std::int64_t value = odd_number(random);
    const std::size_t kind = below(4, random);
    if (kind == 0) value = old + static_cast<std::int64_t>(below(5, random)) - 2;
    if (kind == 1) value = test::number_at(lump, below(records, random) * record + field, width);
    if (kind == 2 && size == 4)
        value = std::bit_cast<std::uint32_t>(as_float + static_cast<float>(below(65, random)) / 4 - 8);
    test::put_number(lump, at, width, value);
}

void alter_records(Bytes& lump, std::size_t record, std::minstd_rand& random) {
    const std::size_t records = lump.size() / record;
    if (records == 0) return;
    const auto at = lump.begin() + static_cast<std::ptrdiff_t>(below(records, random) * record);
    const Bytes copy(at, at + static_cast<std::ptrdiff_t>(record));
    if (below(2, random) == 0)
        lump.insert(lump.begin() + static_cast<std::ptrdiff_t>(below(records, random) * record), copy.begin(),
                    copy.end());
    else
        lump.erase(at, at + static_cast<std::ptrdiff_t>(record));
}

// A lump changes, and the table of lumps with it: what is behind the first checks is reached.
Bytes altered(const Bytes& file, std::minstd_rand& random) {
    const std::size_t version = version_of(file);
    test::Lumps lumps = test::split_lumps(file);
    for (std::size_t changes = 1 + below(3, random); changes > 0; --changes) {
        const std::size_t number = below(kLumpCount, random);
        const auto record = static_cast<std::size_t>(kBspFormats[version].record_sizes[number]);
        Bytes& lump = lumps[number];
        if (number == static_cast<std::size_t>(Lump::Entities)) {
            std::string text(lump.begin(), lump.end());
            mutate_entities(text, false, random);
            lump.assign(text.begin(), text.end());
        } else if (below(12, random) == 0) {
            mutate_bytes(lump);
        } else if (below(6, random) == 0) {
            alter_records(lump, record, random);
        } else {
            alter_field(lump, std::min(std::max<std::size_t>(record, 4), lump.size()), random);
        }
    }
    Bytes changed = test::join_lumps(kBspFormats[version].version, lumps);
    if (below(3, random) != 0) return changed;
    Bytes colours(3 * lumps[static_cast<std::size_t>(Lump::Lighting)].size());
    for (std::uint8_t& colour : colours) colour = static_cast<std::uint8_t>(random());
    const std::int64_t shift = below(8, random) == 0 ? odd_number(random) : 0;
    test::append_extension(changed, "RGBLIGHTING", colours, static_cast<std::int64_t>(colours.size()), shift);
    return changed;
}

}  // namespace

void mutate(Bytes& input, std::minstd_rand& random) {
    if (!has_lumps(input) || below(20, random) == 0) return mutate_bytes(input);
    input = altered(input, random);
}

void read(Input input) {
    Level level = read_bsp(input);
    Bytes colours{'Q', 'L', 'I', 'T', 1, 0, 0, 0};
    colours.insert(colours.end(), input.begin(), input.end());
    colours.resize(std::min(colours.size(), 8 + 3 * level.lighting.size()));
    if (colours.size() == 8 + 3 * level.lighting.size()) read_lit_file(colours, level);
}

void run(Input input) {
    play_and_draw(read_bsp(input), fnv1a_of(input));
}

}  // namespace oblong::fuzz
