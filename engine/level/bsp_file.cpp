#include "engine/level/bsp_file.h"

#include "engine/base/input_error.h"
#include "engine/base/table.h"

namespace oblong {

namespace {

BspFormat find_format(std::uint32_t version) {
    for (const BspFormat& format : kBspFormats)
        if (format.version == version) return format;
    constexpr std::uint32_t kMostVersion = 1000;  // above: the first bytes of another kind of file
    const std::string found = version > kMostVersion ? "no level of Quake" : "version " + std::to_string(version);
    throw InputError("header, offset 0", found + ", expected version 29, BSP2 or 2PSB");
}

void check_lump(Lump lump, LumpRange range, int record_size, std::int64_t file_size) {
    const auto index = as_size(lump);
    const auto table_offset = static_cast<std::int64_t>(4 + index * 8);
    const std::string found = "offset " + std::to_string(range.offset) + ", size " + std::to_string(range.size);

    if (range.offset < 0 || range.size < 0) fail_in_lump(lump, table_offset, found + ", expected no negative number");
    if (std::int64_t{range.offset} + range.size > file_size)
        fail_in_lump(lump, table_offset,
                     found + ", expected an end within the " + std::to_string(file_size) + " bytes");
    if (range.size > 0 && range.offset < kBspHeaderSize)
        fail_in_lump(lump, table_offset, found + ", expected a start behind the header of 124 bytes");
    if (range.size % record_size != 0)
        fail_in_lump(lump, table_offset,
                     found + ", expected a size of whole records of " + std::to_string(record_size));
}

}  // namespace

void fail_in_lump(Lump lump, std::int64_t file_offset, const std::string& what_is_wrong) {
    const std::string name = item(kLumpNames, lump);
    throw InputError("lump '" + name + "', offset " + std::to_string(file_offset), what_is_wrong);
}

std::string describe_bad_index(const char* what, std::int64_t index, std::int64_t count) {
    const std::string found = std::string(what) + " " + std::to_string(index);
    if (count == 0) return found + ", expected none: the file has no " + what;
    return found + ", expected 0 to " + std::to_string(count - 1);
}

std::span<const std::uint8_t> BspFile::lump_bytes(Lump lump) const {
    const LumpRange where = range(lump);
    return bytes.subspan(as_size(where.offset), as_size(where.size));
}

BspFile open_bsp(std::span<const std::uint8_t> bytes) {
    if (bytes.size() < kBspHeaderSize)
        throw InputError("header, offset 0", std::to_string(bytes.size()) + " bytes, expected a header of 124");

    BspFile file{bytes, find_format(little_endian_u32(bytes.data())), {}};
    for (std::size_t i = 0; i < kLumpCount; ++i) {
        const std::span<const std::uint8_t> entry = bytes.subspan(4 + i * 8, 8);
        file.lumps[i].offset = static_cast<std::int32_t>(little_endian_u32(entry.data()));
        file.lumps[i].size = static_cast<std::int32_t>(little_endian_u32(entry.data() + 4));
        check_lump(static_cast<Lump>(i), file.lumps[i], file.format.record_sizes[i],
                   static_cast<std::int64_t>(bytes.size()));
    }
    return file;
}

void LumpReader::seek(std::int64_t lump_offset) {
    field_ = position_;
    if (lump_offset < 0 || lump_offset > size())
        fail("offset " + std::to_string(lump_offset) + ", expected 0 to the lump's size of " + std::to_string(size()));
    position_ = field_ = lump_offset;
}

void LumpReader::fail_to_take(std::int64_t size_wanted) const {
    fail(std::to_string(size_wanted) + " bytes needed, " + std::to_string(size() - position_) + " left in the lump");
}

std::int32_t LumpReader::read_child(std::int32_t record_count) {
    if (format_.has_wide_indices) return read_i32();
    const auto value = static_cast<std::int32_t>(read_u16());
    return value < record_count ? value : value - 0x10000;
}

void LumpReader::check_extent(std::int64_t first, std::int64_t size_wanted, std::int64_t count,
                              const char* what) const {
    if (first >= 0 && size_wanted >= 0 && first + size_wanted <= count) return;
    fail(std::to_string(size_wanted) + " " + what + " from " + std::to_string(first) +
         " on, expected them within the " + std::to_string(count) + " of the file");
}

std::int64_t LumpReader::check_fixed(FloatBits value, int fraction_bits, std::int32_t limit, const char* what) const {
    if (const auto fixed = to_fixed(value, fraction_bits, limit)) return *fixed;
    fail(std::string(what) + " " + describe(value) + ", expected between -" + std::to_string(limit) + " and " +
         std::to_string(limit));
}

void LumpReader::fail(const std::string& what_is_wrong) const {
    fail_in_lump(lump_, file_offset_ + field_, what_is_wrong);
}

}  // namespace oblong
