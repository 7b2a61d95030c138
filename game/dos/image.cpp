// oblong-dos-image ASSETS BUILT OUT: packs the results of the DOS build in BUILT (kernel.bin, oblong_dos, boot.bin,
// loader.bin) and the museum of ASSETS into OUT/OBLONG.SYS and OUT/oblong.img. Runs on the build machine, not under
// DOS.
#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include "engine/base/little_endian.h"
#include "engine/io/files.h"
#include "engine/level/t_junctions.h"
#include "engine/platform/dos/layout.h"
#include "engine/programs/command_line.h"
#include "engine/sound/small_mixer.h"
#include "engine/sound/sound_file.h"
#include "game/dos/prepared_game.h"
#include "game/sound/sound_table.h"

namespace oblong {
namespace {

namespace fs = std::filesystem;
using Bytes = std::vector<std::uint8_t>;

constexpr std::size_t kPage = 4096, kSector = 512;

void append(Bytes& to, const Bytes& bytes) {
    to.insert(to.end(), bytes.begin(), bytes.end());
}

// Appends zeros up to a multiple of `unit`.
void pad(Bytes& bytes, std::size_t unit) {
    bytes.resize((bytes.size() + unit - 1) / unit * unit);
}

void put_number(Bytes& bytes, std::size_t at, std::size_t number) {
    for (std::size_t byte = 0; byte < 4; ++byte) bytes.at(at + byte) = static_cast<std::uint8_t>(number >> 8 * byte);
}

struct ArchivedFile {
    std::string name;
    Bytes bytes;
};

// The format that engine/platform/dos/kernel/files.cpp reads.
// After the first `read_once` files are read, their memory is free.
Bytes archive_of(const std::vector<ArchivedFile>& files, std::size_t read_once) {
    constexpr std::size_t kHead = 64, kEntry = 64, kName = 56;
    Bytes archive(kHead + kEntry * files.size());
    put_number(archive, 0, files.size());
    for (std::size_t i = 0; i < files.size(); ++i) {
        pad(archive, 16);
        const std::size_t entry = kHead + kEntry * i;
        if (files[i].name.size() >= kName) throw InputError("archive", files[i].name + ": a name that is too long");
        std::copy(files[i].name.begin(), files[i].name.end(), archive.begin() + static_cast<std::ptrdiff_t>(entry));
        put_number(archive, entry + kName, archive.size());
        put_number(archive, entry + kName + 4, files[i].bytes.size());
        append(archive, files[i].bytes);
    }
    put_number(archive, 4, archive.size());
    put_number(archive, 8, read_once);
    return archive;
}

// The memory image of a program (ELF, 32 bits) from PROGRAM_ADDRESS on, with zeros where the file has no bytes.
Bytes loaded_program(const Bytes& elf) {
    constexpr std::size_t kHeadersOffset = 28, kHeaderCount = 44, kHeader = 32;
    constexpr std::uint32_t kLoaded = 1;
    const auto number = [&](std::size_t at) { return LittleEndianReader(elf, at).next<std::uint32_t>(); };
    Bytes memory;
    for (std::size_t i = 0; i < LittleEndianReader(elf, kHeaderCount).next<std::uint16_t>(); ++i) {
        const std::size_t part = number(kHeadersOffset) + kHeader * i;
        if (number(part) != kLoaded) continue;
        const std::size_t offset = number(part + 4), at = number(part + 8) - PROGRAM_ADDRESS;
        const auto bytes = std::span(elf).subspan(offset, number(part + 16));
        memory.resize(std::max(memory.size(), at + number(part + 20)));
        std::copy(bytes.begin(), bytes.end(), memory.begin() + static_cast<std::ptrdiff_t>(at));
    }
    return memory;
}

// A WAV file of 8 bits a sample (as decode_sound() reads it), with as many as the card plays.
Bytes sound_of(const std::string& file) {
    constexpr std::uint32_t kRiff = 0x4646'4952, kWave = 0x4556'4157, kFormat = 0x2074'6d66, kData = 0x6174'6164;
    constexpr std::uint32_t kPcmOfOneChannel = 0x1'0001, kBitsAndBytes = 0x8'0001, kRate = SmallMixer::kRate_hz;
    const SoundSamples sound = read_parsed(file, decode_sound);
    const std::vector<std::int8_t> samples = SmallMixer::at_own_rate(sound.samples, sound.rate_hz);
    const auto size = static_cast<std::uint32_t>(samples.size());
    Bytes wav;
    for (const std::uint32_t number :
         {kRiff, 36 + size, kWave, kFormat, 16u, kPcmOfOneChannel, kRate, kRate, kBitsAndBytes, kData, size})
        append_little_endian(wav, number);
    for (const std::int8_t sample : samples) wav.push_back(static_cast<std::uint8_t>(sample + 128));
    return wav;
}

// As it is called under DOS.
std::string archived_name(const fs::path& file) {
    return "assets/" + file.filename().string();
}

Bytes definition_of(const fs::path& assets) {
    GameDefinition game = read_game_definition(assets.string());
    game.folder = "/assets";
    for (std::string* const file : {&game.palette, &game.demo}) *file = "/" + archived_name(*file);
    return encode_definition(game);
}

Bytes museum_archive(const fs::path& assets) {
    LevelFiles files;
    files.assets = assets.string();
    files.level = (assets / "demo.bsp").string();
    GameData data = load_game(files);
    data.level.t_junctions = find_t_junctions(data.level);
    std::vector<ArchivedFile> archived{{"assets/demo.bsp", encode_prepared_game(data)}}, rest;
    std::vector<fs::path> sounds(fs::directory_iterator(assets / "sounds"), {});
    std::sort(sounds.begin(), sounds.end());
    for (const fs::path& sound : sounds) {
        if (sound.extension() != ".flac") continue;
        const std::string name = "sounds/" + sound.filename().string();
        const bool is_named = std::any_of(data.sounds.sounds.begin(), data.sounds.sounds.end(),
                                          [&](const LevelSound& own) { return own.name == name; });
        auto& list = is_named && find_sound(sound.stem().string()) ? rest : archived;  // of the level and of the game
        list.push_back({"assets/" + name, sound_of(sound.string())});
    }
    const std::size_t read_once = archived.size();
    archived.insert(archived.end(), rest.begin(), rest.end());
    archived.push_back({"assets/game", definition_of(assets)});
    for (const char* name : {"palette.lmp", "walk.demo"})
        archived.push_back({archived_name(name), read_file((assets / name).string())});
    return archive_of(archived, read_once);
}

// The image that the loader copies to KERNEL_ADDRESS.
Bytes system_of(const fs::path& assets, const fs::path& built) {
    Bytes system = read_file((built / "kernel.bin").string());
    system.resize(PROGRAM_ADDRESS - KERNEL_ADDRESS);
    append(system, loaded_program(read_file((built / "oblong_dos").string())));
    pad(system, kPage);
    append(system, museum_archive(assets));
    pad(system, kSector);
    return system;
}

Bytes disk_of(const fs::path& built, const Bytes& system) {
    constexpr std::size_t kLoaderSectors = 7, kCylinder = 16 * 63 * kSector;
    constexpr std::size_t kEndSector = 440, kPartitionSectors = 458;  // as in boot.S
    Bytes disk = read_file((built / "boot.bin").string());
    append(disk, read_file((built / "loader.bin").string()));
    if (disk.size() > (1 + kLoaderSectors) * kSector) throw InputError("loader.bin", "more than 7 sectors");
    disk.resize((1 + kLoaderSectors) * kSector);
    append(disk, system);
    put_number(disk, kEndSector, disk.size() / kSector);
    pad(disk, kCylinder);
    put_number(disk, kPartitionSectors, disk.size() / kSector - 1);
    return disk;
}

int run(int count, const char* const* arguments) {
    CommandLine line("oblong-dos-image", "Packs the DOS build's parts into OBLONG.SYS and a disk image.");
    std::string assets, built, out;
    line.add("assets", assets, "folder of the museum").require();
    line.add("built", built, "folder of the kernel, the program and the loaders").require();
    line.add("out", out, "folder of what is written").require();
    return line.run(count, arguments, [&] {
        const Bytes system = system_of(assets, built);
        write_file((fs::path(out) / "OBLONG.SYS").string(), system);
        write_file((fs::path(out) / "oblong.img").string(), disk_of(built, system));
    });
}

}  // namespace
}  // namespace oblong

int main(int argc, char** argv) {
    return oblong::run(argc, argv);
}
