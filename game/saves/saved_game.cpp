#include "game/saves/saved_game.h"

#include <algorithm>
#include <filesystem>
#include <string_view>
#include <utility>

#include "engine/base/checksum.h"
#include "engine/io/game_files.h"

namespace oblong {
namespace {

constexpr std::string_view kMagic = "OBLGSAVE";
constexpr std::uint32_t kVersion = 2;
constexpr std::size_t kVersionAt = 8, kSizeAt = 12, kHeaderBytes = 16, kHashBytes = 8, kLongestName = 4096;

void append_name(std::vector<std::uint8_t>& bytes, const std::string& whole_name) {
    const std::string name = whole_name.substr(0, kLongestName);
    append_little_endian(bytes, static_cast<std::uint16_t>(name.size()));
    bytes.insert(bytes.end(), name.begin(), name.end());
}

std::string read_name(LittleEndianReader& reader) {
    const auto name = reader.take(reader.next<std::uint16_t>());
    return {name.begin(), name.end()};
}

void append_level(std::vector<std::uint8_t>& bytes, const SavedLevel& level) {
    for (const std::string* name : {&level.name, &level.palette, &level.models}) append_name(bytes, *name);
    append_little_endian(bytes, static_cast<std::uint16_t>(level.game_folders.size()));
    for (const std::string& folder : level.game_folders) append_name(bytes, folder);
    for (const std::uint64_t hash : {level.file_hash, level.start_hash, level.palette_hash})
        append_little_endian(bytes, hash);
    append_little_endian(bytes, level.model_count);
}

SavedLevel read_level(LittleEndianReader& reader) {
    SavedLevel level;
    for (std::string* name : {&level.name, &level.palette, &level.models}) *name = read_name(reader);
    for (auto folders = reader.next<std::uint16_t>(); folders > 0; --folders)
        level.game_folders.push_back(read_name(reader));
    for (std::uint64_t* hash : {&level.file_hash, &level.start_hash, &level.palette_hash})
        *hash = reader.next<std::uint64_t>();
    level.model_count = reader.next<std::uint32_t>();
    return level;
}

void append_picture(std::vector<std::uint8_t>& bytes, const Thumbnail& picture) {
    for (const Rgb8 colour : picture.pixels) bytes.insert(bytes.end(), {colour.red, colour.green, colour.blue});
}

Thumbnail read_picture(LittleEndianReader& reader) {
    Thumbnail picture;
    const auto bytes = reader.take(3 * picture.pixels.size());
    for (std::size_t i = 0; i < picture.pixels.size(); ++i)
        picture.pixels[i] = {bytes[3 * i], bytes[3 * i + 1], bytes[3 * i + 2]};
    return picture;
}

// Reads what precedes the state.
SaveHead read_head(LittleEndianReader& reader) {
    SaveHead head;
    head.level = read_level(reader);
    head.lenses.taken = reader.next<std::int32_t>();
    head.lenses.all = reader.next<std::int32_t>();
    head.picture = read_picture(reader);
    return head;
}

// In two steps: of a sum of strings GCC 12 warns without a reason.
std::string of_other_version(std::string_view rest) {
    std::string text(kOtherVersion);
    text += rest;
    return text;
}

// Checks that the file is whole, unaltered and of this version; returns a reader of the bytes between header and
// checksum.
LittleEndianReader checked(std::span<const std::uint8_t> bytes) {
    expect_at(0, bytes.size() >= kHeaderBytes + kHashBytes,
              "the file has " + std::to_string(bytes.size()) + " bytes, expected a saved game");
    expect_at(0, std::equal(kMagic.begin(), kMagic.end(), bytes.begin()), "no saved game: expected 'OBLGSAVE'");
    LittleEndianReader header(bytes, kVersionAt);
    const auto version = header.next<std::uint32_t>();
    expect_at(kVersionAt, version == kVersion,
              of_other_version(" (" + std::to_string(version) + "), expected " + std::to_string(kVersion)));
    const auto size = header.next<std::uint32_t>();
    expect_at(kSizeAt, size == bytes.size(),
              "the file has " + std::to_string(bytes.size()) + " bytes, expected the " + std::to_string(size) +
                  " that were saved");
    const std::size_t end = bytes.size() - kHashBytes;
    expect_at(end, LittleEndianReader(bytes, end).next<std::uint64_t>() == fnv1a_of(bytes.first(end)),
              "the checksum differs, expected a file that was not changed");
    LittleEndianReader reader(bytes.first(end), kHeaderBytes);
    expect_at(kHeaderBytes, reader.next<std::uint64_t>() == state_layout(),
              of_other_version(", expected a state of this one's fields"));
    return reader;
}

// The columns or rows, at least one, that a pixel of the small picture covers.
PixelRange covered_by(std::int32_t index, std::int32_t small_px, std::int32_t large_px) {
    const auto edge = [&](std::int32_t i) { return static_cast<std::int32_t>(std::int64_t{i} * large_px / small_px); };
    const std::int32_t first = edge(index);
    return {first, std::max(first + 1, edge(index + 1))};
}

Rgb8 mean_colour(Framebuffer picture, const Palette& palette, PixelRange columns, PixelRange rows) {
    std::int64_t red = 0, green = 0, blue = 0;
    for (std::int32_t y = rows.first; y < rows.end; ++y)
        for (std::int32_t x = columns.first; x < columns.end; ++x) {
            const Rgb8 colour = item(palette.colours, picture.row(y)[x]);
            red += colour.red, green += colour.green, blue += colour.blue;
        }
    const std::int64_t count = std::int64_t{columns.end - columns.first} * (rows.end - rows.first);
    const auto mean = [count](std::int64_t sum) { return static_cast<std::uint8_t>((sum + count / 2) / count); };
    return {mean(red), mean(green), mean(blue)};
}

}  // namespace

std::vector<std::uint8_t> encode_save(const SavedGame& game) {
    std::vector<std::uint8_t> bytes(kMagic.begin(), kMagic.end());
    append_little_endian(bytes, kVersion);
    append_little_endian(bytes, std::uint32_t{0});  // the size: below
    append_little_endian(bytes, state_layout());
    append_level(bytes, game.level);
    append_little_endian(bytes, game.lenses.taken);
    append_little_endian(bytes, game.lenses.all);
    append_picture(bytes, game.picture);
    append_little_endian(bytes, hash_of(game.state));
    append_state(bytes, game.state);
    std::vector<std::uint8_t> size;
    append_little_endian(size, static_cast<std::uint32_t>(bytes.size() + kHashBytes));
    std::copy(size.begin(), size.end(), bytes.begin() + kSizeAt);
    append_little_endian(bytes, fnv1a_of(bytes));
    return bytes;
}

SaveHead decode_save_head(std::span<const std::uint8_t> bytes) {
    LittleEndianReader reader = checked(bytes);
    SaveHead head = read_head(reader);
    reader.take(kHashBytes);                               // of the state
    head.tick = reader.next<decltype(GameState::tick)>();  // its first field
    head.checksum = LittleEndianReader(bytes, bytes.size() - kHashBytes).next<std::uint64_t>();
    return head;
}

SavedGame decode_save(std::span<const std::uint8_t> bytes) {
    LittleEndianReader reader = checked(bytes);
    SaveHead head = read_head(reader);
    SavedGame game{std::move(head.level), head.lenses, {}, head.picture};
    const std::size_t hash_at = reader.offset();
    const auto state_hash = reader.next<std::uint64_t>();
    game.state = read_state(reader);
    expect_at(reader.offset(), reader.rest() == 0,
              std::to_string(reader.rest()) + " bytes follow the state, expected none");
    expect_at(hash_at, hash_of(game.state) == state_hash, "the state has another hash, expected the one saved");
    return game;
}

void check_level(const SavedGame& game, std::uint64_t level_hash, const GameLevel& level) {
    if (game.level.file_hash != level_hash)
        throw InputError("level", "saved in another level, another version of it or by other rules, expected this one");
    const std::string expected = "expected one saved by this version of the game";
    if (game.level.start_hash != hash_of(start_of(level)))
        throw InputError("state", "of another start of this level, " + expected);
    if (const std::string wrong = find_inconsistency(level, game.state); !wrong.empty())
        throw InputError("state", wrong + "; " + expected);
}

Thumbnail make_thumbnail(Framebuffer picture, const Palette& palette) {
    Thumbnail thumbnail;
    auto pixel = thumbnail.pixels.begin();
    for (std::int32_t y = 0; y < Thumbnail::kHeight_px; ++y)
        for (std::int32_t x = 0; x < Thumbnail::kWidth_px; ++x)
            *pixel++ = mean_colour(picture, palette, covered_by(x, Thumbnail::kWidth_px, picture.width_px),
                                   covered_by(y, Thumbnail::kHeight_px, picture.height_px));
    return thumbnail;
}

namespace {

namespace fs = std::filesystem;

std::string absolute(const std::string& path) {
    std::error_code ignored;
    return path.empty() ? "" : fs::absolute(path, ignored).lexically_normal().string();
}

bool is_at_hand(const std::string& path) {
    std::error_code ignored;
    return fs::exists(path, ignored) || path_in_pak(path);
}

std::uint64_t hash_of_colours(const Palette& palette) {
    Fnv1a hash;
    for (const Rgb8 colour : palette.colours)
        for (const std::uint8_t byte : {colour.red, colour.green, colour.blue}) hash.add(byte);
    return hash.value();
}

bool is_demo_level(const std::string& name, const std::string& assets) {
    std::error_code ignored;
    if (fs::path(name).filename() != kDemoLevelFile) return false;
    return !fs::exists(name, ignored) || fs::equivalent(name, fs::path(assets) / kDemoLevelFile, ignored);
}

}  // namespace

SavedLevel saved_level_of(const LoadedLevel& loaded) {
    const GameData& data = loaded.data;
    SavedLevel saved;
    saved.name = is_at_hand(data.level_file) ? absolute(data.level_file) : data.level_file;
    saved.palette = absolute(loaded.files.palette);
    saved.models = absolute(loaded.files.models);
    if (!loaded.files.level.empty())  // the demo level belongs to no game
        for (const std::string& folder : loaded.files.game_folders) saved.game_folders.push_back(absolute(folder));
    saved.file_hash = data.level_hash;
    saved.start_hash = hash_of(start_of(loaded.level));
    saved.palette_hash = hash_of_colours(data.palette);
    saved.model_count = static_cast<std::uint32_t>(data.models.models.size());
    return saved;
}

LevelFiles files_of(const SavedLevel& saved, const LevelFiles& own) {
    LevelFiles files = own;
    if (!is_demo_level(saved.name, own.assets)) {
        files.level = saved.name;
        files.game_folders = saved.game_folders;
    }
    if (saved.palette.empty() || is_at_hand(saved.palette)) files.palette = saved.palette;
    if (saved.models.empty() || is_at_hand(saved.models)) files.models = saved.models;
    return files;
}

std::string what_is_gone(const SavedLevel& saved, const SavedLevel& loaded) {
    std::string text;
    if (loaded.palette_hash != saved.palette_hash)
        text += "Its colours differ from those when it was saved: " +
                (saved.palette.empty() ? "the palette of its game" : saved.palette) + " is gone or another file.\n";
    if (loaded.model_count < saved.model_count)
        text += "It is shown without " + std::to_string(saved.model_count - loaded.model_count) + " of the " +
                std::to_string(saved.model_count) + " models that it had when it was saved: " +
                (saved.models.empty() ? "the files of its game" : saved.models) + " are gone.\n";
    return text;
}

}  // namespace oblong
