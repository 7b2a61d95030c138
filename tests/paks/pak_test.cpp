#include <gtest/gtest.h>

#include "engine/files/game_files.h"
#include "tests/paks/pak_writer.h"
#include "tests/support/refusal.h"

namespace oblong {
namespace {

using test::Bytes;
using test::put_number;

// "a.txt" at 12, "maps/b.bsp" at 15, the directory at 20 to 148.
const Bytes kPak = test::write_pak({{"a.txt", {1, 2, 3}}, {"maps/b.bsp", {4, 5, 6, 7, 8}}});

std::vector<PakEntry> read(const Bytes& bytes) {
    const PakHeader header = read_pak_header(bytes, bytes.size());
    const auto directory = std::span(bytes).subspan(header.directory_offset, header.directory_length);
    return read_pak_directory(directory, header, bytes.size());
}

std::string fault_of(const Bytes& bytes) {
    return test::refusal([&] { read(bytes); });
}

// Of the pak with another number at an offset.
std::string fault_with(std::size_t offset, std::uint32_t number) {
    Bytes bytes = kPak;
    put_number(bytes, offset, 4, number);
    return fault_of(bytes);
}

TEST(Pak, IsReadAsItWasWritten) {
    const std::vector<PakEntry> entries = read(kPak);
    ASSERT_EQ(entries.size(), 2u);
    EXPECT_EQ(entries[0].name, "a.txt");
    EXPECT_EQ(entries[0].offset, 12u);
    EXPECT_EQ(entries[0].length, 3u);
    EXPECT_EQ(entries[1].name, "maps/b.bsp");
    EXPECT_EQ(entries[1].offset, 15u);
    EXPECT_EQ(entries[1].length, 5u);
    EXPECT_TRUE(read(test::write_pak({})).empty());
}

TEST(Pak, EachCutAndEachLieOfTheHeaderIsNamed) {
    for (std::size_t size = 0; size < kPak.size(); ++size)
        EXPECT_NE(fault_of(Bytes(kPak.begin(), kPak.begin() + static_cast<std::ptrdiff_t>(size))), "") << size;
    EXPECT_EQ(fault_with(0, 0x4b434151), "offset 0: no pak file: expected 'PACK' and 8 more bytes");
    EXPECT_EQ(fault_with(4, 21),
              "offset 4: a directory of 128 bytes at 21, expected it behind the header in a file of 148");
    EXPECT_EQ(fault_with(4, 0),
              "offset 4: a directory of 128 bytes at 0, expected it behind the header in a file of 148");
    EXPECT_NE(fault_with(4, 0xffffffff), "");
    EXPECT_EQ(fault_with(8, 127), "offset 8: a directory of 127 bytes, expected a multiple of 64");
    EXPECT_NE(fault_with(8, 0xffffffc0), "");
}

TEST(Pak, EachLieOfTheDirectoryIsNamed) {
    EXPECT_EQ(fault_with(20 + 60, 200), "offset 76: a.txt has 200 bytes from 12 on, expected them in the file's 148");
    EXPECT_NE(fault_with(20 + 60, 0xffffffff), "");
    EXPECT_NE(fault_with(20 + 56, 0xffffffff), "");
    EXPECT_EQ(fault_with(20 + 60, 4), "offset 84: data from 15 on, where other data is, expected it apart");
    EXPECT_EQ(fault_with(20 + 56, 11), "offset 20: data from 11 on, where other data is, expected it apart");
    EXPECT_EQ(fault_with(84 + 56, 30), "offset 84: data from 30 on, where other data is, expected it apart");
    EXPECT_EQ(fault_with(84, 0), "offset 84: an entry without a name, expected one");
    Bytes endless = kPak;
    std::fill_n(endless.begin() + 20, 56, std::uint8_t{'x'});
    EXPECT_EQ(fault_of(endless), "offset 20: a name without an end, expected a zero byte among its 56");
    Bytes same = kPak;
    put_number(same, 84 + 56, 4, 12);
    put_number(same, 84 + 60, 4, 3);
    EXPECT_EQ(fault_of(same), "") << "two names of the same data";
}

}  // namespace
}  // namespace oblong
