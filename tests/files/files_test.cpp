#include "engine/io/files.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>

#include <filesystem>

#include "tests/support/folders.h"
#include "tests/support/refusal.h"

namespace oblong::test {

namespace {

namespace fs = std::filesystem;
using Bytes = std::vector<std::uint8_t>;

const std::string kNoPlace = ", expected a place for a file of 65536 bytes";

class Files : public testing::Test {
  protected:
    std::string path(const std::string& name) const { return temporary_.path(name); }

    /// What the error says after the file's name; empty if there is none.
    template <class Work>
    std::string complaint(const std::string& file, Work work) const {
        const std::string said = refusal<FileError>([&] { work(file); });
        if (said.empty()) return said;
        return said.starts_with(file + ": ") ? said.substr(file.size() + 2) : "another file: " + said;
    }
    std::string complaint_of_reading(const std::string& file, std::size_t most_bytes = kLargestFile_bytes) const {
        return complaint(file, [&](const std::string& name) { read_file(name, most_bytes); });
    }
    std::string complaint_of_writing(const std::string& file) const {
        return complaint(file, [](const std::string& name) { write_file(name, Bytes(1 << 16, 4)); });
    }

    const TemporaryFolder temporary_;
    const fs::path folder_ = temporary_.path();
};

TEST_F(Files, WhatIsWrittenIsRead) {
    // Longer than any buffer, and not by whole ones; every byte, line ends and zeros too.
    Bytes bytes(300'001);
    for (std::size_t i = 0; i < bytes.size(); ++i) bytes[i] = static_cast<std::uint8_t>(i * i / 7);
    for (const Bytes& each : {bytes, Bytes{}}) {
        write_file(path("file"), each);
        EXPECT_EQ(fs::file_size(path("file")), each.size());
        EXPECT_EQ(read_file(path("file")), each);
    }
    const std::string text("a\r\n\0\x1a\xff", 6);
    write_file(path("text"), text);
    EXPECT_EQ(read_text(path("text")), text);
}

TEST_F(Files, NewContentTakesTheOldOnesPlaceAndNothingElseIsLeft) {
    const Bytes before(100, 1), after{2, 0, 3};
    write_file(path("file"), before);
    write_file(path("file"), after);
    EXPECT_EQ(read_file(path("file")), after);
    EXPECT_EQ(std::distance(fs::directory_iterator(folder_), {}), 1);
}

// Whatever stands where a file that is not whole yet would: another's link leads to nothing that is written.
TEST_F(Files, AnUnfinishedFileIsANewOne) {
    write_file(path("victim"), Bytes{7, 7, 7});
    const std::string name = path("file") + "." + std::to_string(getpid()) + "-";
    fs::create_symlink(path("victim"), name + "0" + kUnfinishedExtension);
    fs::create_hard_link(path("victim"), name + "1" + kUnfinishedExtension);
    write_file(path("file"), Bytes{2, 0, 3});
    EXPECT_TRUE(fs::is_regular_file(fs::symlink_status(path("file"))));
    EXPECT_EQ(read_file(path("file")), (Bytes{2, 0, 3}));
    EXPECT_EQ(read_file(path("victim")), (Bytes{7, 7, 7}));
    EXPECT_EQ(fs::hard_link_count(path("victim")), 2u) << "both are another's, and stay";
    EXPECT_TRUE(fs::is_symlink(name + "0" + kUnfinishedExtension));
}

TEST_F(Files, ADeviceIsWrittenToAndStays) {
    const std::string full = test::device_for_writing(folder_.string(), "full"),
                      null = test::device_for_writing(folder_.string(), "null");
    if (access(full.c_str(), W_OK) != 0) GTEST_SKIP() << "no devices can be used in " << folder_;
    EXPECT_EQ(complaint_of_writing(full), "write: No space left on device" + kNoPlace);
    EXPECT_TRUE(fs::is_character_file(full));
    EXPECT_EQ(complaint_of_writing(null), "");
    EXPECT_TRUE(fs::is_character_file(null));
}

// At its end, also over several links of other folders, and whole or not at all there.
TEST_F(Files, ALinkStaysAndWhatItLeadsToIsReplaced) {
    write_file(path("target"), Bytes(100, 1));
    fs::create_hard_link(path("target"), path("as it was"));
    fs::create_directory(path("below"));
    fs::create_symlink("../link", path("below/link to a link"));
    fs::create_symlink(path("target"), path("link"));
    fs::create_symlink("later", path("below/dangling"));
    for (const char* name : {"link", "below/link to a link", "below/dangling"}) {
        write_file(path(name), Bytes{2, 0, 3});
        EXPECT_TRUE(fs::is_symlink(path(name))) << name;
    }
    EXPECT_EQ(read_file(path("target")), (Bytes{2, 0, 3}));
    EXPECT_EQ(read_file(path("as it was")), Bytes(100, 1));
    EXPECT_EQ(read_file(path("below/later")), (Bytes{2, 0, 3}));
    fs::create_symlink("b", path("a"));
    fs::create_symlink("a", path("b"));
    EXPECT_EQ(complaint_of_writing(path("a")),
              "open: its symbolic links form a loop, expected a path that ends at a file");
}

// As a shell hands on standard output that leads to a file: what is written there follows what was.
TEST_F(Files, AnOpenFileIsWrittenToUnderItsNumber) {
    const int descriptor = open(path("file").c_str(), O_RDWR | O_CREAT, 0600);
    for (const std::string folder : {"/proc/self/fd/", "/dev/fd/"}) {
        write_file(folder + std::to_string(descriptor), Bytes{7, 8});
        Bytes read(2);
        EXPECT_EQ(pread(descriptor, read.data(), 2, 0), 2) << folder;
        EXPECT_EQ(read, (Bytes{7, 8})) << folder;
        ASSERT_EQ(ftruncate(descriptor, 0), 0);
    }
    close(descriptor);
    EXPECT_EQ(std::distance(fs::directory_iterator(folder_), {}), 1);
}

TEST_F(Files, PlacesThatCannotBeWritten) {
    fs::create_directories(path("folder"));
    EXPECT_EQ(complaint_of_writing(path("folder")), "write: Is a directory" + kNoPlace);
    EXPECT_EQ(complaint_of_writing(path("no/such/file")), "write: No such file or directory" + kNoPlace);
    EXPECT_NE(complaint_of_writing(""), "");
    EXPECT_EQ(std::distance(fs::recursive_directory_iterator(folder_), {}), 1);
}

TEST_F(Files, WhatCannotBeRead) {
    EXPECT_EQ(complaint_of_reading(path("none")), "open: No such file or directory, expected a readable file");
    EXPECT_EQ(complaint_of_reading(folder_.string()), "open: is a folder, expected a file");
    fs::create_symlink(folder_, path("link"));
    EXPECT_EQ(complaint_of_reading(path("link")), "open: is a folder, expected a file");
    write_file(path("file"), Bytes(1));
    EXPECT_EQ(complaint_of_reading(path("file/below")), "open: Not a directory, expected a readable file");
    // Opens, and reads nothing from its address 0.
    EXPECT_EQ(complaint_of_reading("/proc/self/mem"), "read: Input/output error, expected a readable file");
    write_file(path("locked"), Bytes(1));
    fs::permissions(path("locked"), fs::perms::none);
    const bool may_read_all = access(path("locked").c_str(), R_OK) == 0;  // root may
    EXPECT_EQ(complaint_of_reading(path("locked")),
              may_read_all ? "" : "open: Permission denied, expected a readable file");
}

TEST_F(Files, AFileMayHaveAsManyBytesAsAreAllowed) {
    write_file(path("file"), Bytes(100'000));
    EXPECT_EQ(complaint_of_reading(path("file"), 100'000), "");
    EXPECT_EQ(complaint_of_reading(path("file"), 99'999), "size: more than 99999 bytes, expected a smaller file");
}

// Nothing waits for what may never come: the test would.
TEST_F(Files, OnlyRegularFilesAreRead) {
    ASSERT_EQ(mkfifo(path("pipe").c_str(), 0600), 0);
    const int socket = ::socket(AF_UNIX, SOCK_STREAM, 0);
    sockaddr_un address{AF_UNIX, {}};
    path("socket").copy(address.sun_path, sizeof address.sun_path - 1);
    ASSERT_EQ(bind(socket, reinterpret_cast<const sockaddr*>(&address), sizeof address), 0);
    close(socket);
    fs::create_symlink(path("pipe"), path("link"));
    for (const std::string& file : {path("pipe"), path("link"), path("socket"), std::string("/dev/zero"),
                                    std::string("/dev/tty"), std::string("/dev/null")}) {
        EXPECT_EQ(complaint_of_reading(file), "open: is no regular file, expected one") << file;
        EXPECT_EQ(complaint(file, [](const std::string& name) { read_file_part(name, 0, 1); }),
                  "open: is no regular file, expected one")
            << file;
    }
}

TEST_F(Files, WhatFilesNameStaysBelowTheirFolder) {
    const std::string inside = path("a folder"), outside = path("a folder, another");  // begins alike
    for (const std::string& folder : {inside + "/below", outside}) {
        make_folder(folder);
        write_file(folder + "/file", Bytes(1));
    }
    fs::create_symlink("below", inside + "/link in");
    fs::create_symlink(inside, path("as named"));
    fs::create_symlink(outside, inside + "/link out");
    fs::create_symlink(outside + "/file", inside + "/file");
    ASSERT_EQ(mkfifo((inside + "/pipe").c_str(), 0600), 0);
    for (const char* name : {"below/file", "./below//file", "link in/file"})
        for (const std::string& folder : {inside, path("as named")}) {
            EXPECT_EQ(find_below({outside, folder}, name), (fs::path(folder) / name).lexically_normal()) << name;
            EXPECT_FALSE(leads_out(folder, name)) << name;
        }
    for (const std::string& name : {std::string("link out/file"), std::string("file"), outside + "/file",
                                    inside + "/below/file", std::string("../a folder, another/file"),
                                    std::string("below/../below/file"), std::string("/dev/stdin"), std::string()}) {
        EXPECT_EQ(find_below({inside}, name), "") << name;
        EXPECT_TRUE(leads_out(inside, name)) << name;
    }
    for (const char* name : {"pipe", "below", "none", "below/none"}) EXPECT_EQ(find_below({inside}, name), "") << name;
}

TEST_F(Files, FaultsOfTheContentNameTheFile) {
    write_file(path("file"), Bytes{7});
    const auto refuse = [](std::span<const std::uint8_t> bytes) -> int {
        throw InputError("offset 0", std::to_string(bytes[0]) + ", expected 8");
    };
    EXPECT_EQ(complaint(path("file"), [&](const std::string& file) { read_parsed(file, refuse); }),
              "offset 0: 7, expected 8");
    EXPECT_EQ(read_parsed(path("file"), [](std::span<const std::uint8_t> bytes) { return bytes[0]; }), 7);
}

TEST_F(Files, FoldersAreMadeWithThoseAbove) {
    make_folder(path("a/b/c"));
    make_folder(path("a/b/c"));
    EXPECT_TRUE(fs::is_directory(path("a/b/c")));
    write_file(path("file"), Bytes(1));
    for (const std::string& taken : {path("file"), path("file/below")})
        EXPECT_EQ(complaint(taken, make_folder), "make folder: Not a directory, expected a place for a folder");
}

}  // namespace

}  // namespace oblong::test
