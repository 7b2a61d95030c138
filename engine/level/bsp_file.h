#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "engine/base/table.h"
#include "engine/level/bsp_floats.h"
#include "engine/level/bsp_format.h"

namespace oblong {

constexpr std::uint32_t little_endian_u32(const std::uint8_t* four) {
    return std::uint32_t{four[0]} | std::uint32_t{four[1]} << 8 | std::uint32_t{four[2]} << 16 |
           std::uint32_t{four[3]} << 24;
}

/// Throws an InputError for an error in a lump; `file_offset` is where the wrong field starts in the file.
[[noreturn]] void fail_in_lump(Lump lump, std::int64_t file_offset, const std::string& what_is_wrong);

/// "plane 9, expected 0 to 7", or "plane 9, expected none: the file has no plane".
std::string describe_bad_index(const char* what, std::int64_t index, std::int64_t count);

struct LumpRange {
    std::int32_t offset = 0, size = 0;  ///< bytes in the file
};

/// A level file with checked version and lump table.
struct BspFile {
    std::span<const std::uint8_t> bytes;
    BspFormat format;
    std::array<LumpRange, kLumpCount> lumps;

    LumpRange range(Lump lump) const { return item(lumps, lump); }
    std::span<const std::uint8_t> lump_bytes(Lump lump) const;
    /// The number of records in the lump (bytes if it has no records).
    std::int32_t count(Lump lump) const { return range(lump).size / item(format.record_sizes, lump); }
};

/// Checks the version, and that every lump is behind the header, inside the file, and holds whole records.
BspFile open_bsp(std::span<const std::uint8_t> bytes);

/// Reads the little-endian numbers of a lump in sequence, on any machine. Throws InputError at the lump's end.
class LumpReader {
  public:
    LumpReader(const BspFile& file, Lump lump)
        : bytes_(file.lump_bytes(lump)), file_offset_(file.range(lump).offset), lump_(lump), format_(file.format) {}

    std::int64_t size() const { return static_cast<std::int64_t>(bytes_.size()); }
    /// Continues at this byte of the lump, which may be its end.
    void seek(std::int64_t lump_offset);
    std::span<const std::uint8_t> read_bytes(std::int64_t size) { return {take(size), as_size(size)}; }
    void skip(std::int64_t size) { read_bytes(size); }

    std::uint8_t read_u8() { return take(1)[0]; }
    std::uint32_t read_u16() {
        const std::uint8_t* const two = take(2);
        return std::uint32_t{two[0]} | std::uint32_t{two[1]} << 8;
    }
    std::int32_t read_i16() {
        const auto value = static_cast<std::int32_t>(read_u16());
        return value < 0x8000 ? value : value - 0x10000;
    }
    std::uint32_t read_u32() { return little_endian_u32(take(4)); }
    std::int32_t read_i32() { return static_cast<std::int32_t>(read_u32()); }
    FloatBits read_float() { return FloatBits{read_u32()}; }

    /// An index or count of the format's width.
    std::int32_t read_index() { return format_.has_wide_indices ? read_i32() : static_cast<std::int32_t>(read_u16()); }
    /// A child in a tree of `record_count` nodes: an index, or negative.
    std::int32_t read_child(std::int32_t record_count);

    /// Throws unless 0 <= index < count; `what` names the records.
    std::int32_t check_index(std::int32_t index, std::int32_t count, const char* what) const {
        if (index < 0 || index >= count) fail(describe_bad_index(what, index, count));
        return index;
    }
    /// Throws unless [first, first + size) is in [0, count).
    void check_extent(std::int64_t first, std::int64_t size, std::int64_t count, const char* what) const;
    template <class Record>
    IndexRange<Record> check_range(std::int32_t first, std::int32_t size, std::int64_t count, const char* what) const {
        check_extent(first, size, count, what);
        return {Index<Record>(first), size};
    }
    /// The float read last, in fixed point: value * 2^fraction_bits, rounded to nearest. Throws unless |value| < limit.
    std::int64_t check_fixed(FloatBits value, int fraction_bits, std::int32_t limit, const char* what) const;
    std::int64_t read_fixed(int fraction_bits, std::int32_t limit, const char* what) {
        return check_fixed(read_float(), fraction_bits, limit, what);
    }

    /// Throws an InputError that names the lump and the offset of the field read last.
    [[noreturn]] void fail(const std::string& what_is_wrong) const;

  private:
    const std::uint8_t* take(std::int64_t size_wanted) {
        field_ = position_;
        if (size_wanted < 0 || size_wanted > size() - position_) fail_to_take(size_wanted);
        position_ += size_wanted;
        return bytes_.data() + field_;
    }
    [[noreturn]] void fail_to_take(std::int64_t size_wanted) const;

    std::span<const std::uint8_t> bytes_;
    std::int64_t file_offset_ = 0, position_ = 0, field_ = 0;
    Lump lump_;
    BspFormat format_;
};

}  // namespace oblong
