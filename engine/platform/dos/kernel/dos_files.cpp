#include "engine/platform/dos/kernel/file_table.h"
#include "engine/platform/dos/kernel/kernel.h"

// The files of the game's folder are stored in one DOS file, in the archive's format (file_table.cpp). A new version is
// written under another name, and replaces the old one when it is complete.

namespace oblong::dos {
namespace {

constexpr char kFolder[] = "oblong", kKept[] = "OBLONG.SAV", kNew[] = "OBLONG.NEW", kUnfinished[] = ".part";
constexpr std::uint32_t kHead = 64, kPiece = 32 * 1024;
constexpr std::uint16_t kNames = 0xff00;  // in the buffer, after all pieces

struct Entry {
    char name[kNameSize];
    std::uint32_t offset, size;
};
struct Head {
    std::uint32_t count, size;
    std::uint8_t unused[kHead - 8];
};

std::uint16_t put_name(const char* name, std::uint16_t at) {
    memcpy(dos_buffer() + at, name, sizeof kKept);
    return at;
}

std::int32_t open_kept(const char* name) {
    return call_dos(0x3d00, 0, 0, put_name(name, kNames));
}

bool read_all(std::uint16_t handle, void* to, std::uint32_t size) {
    for (std::uint32_t done = 0; done < size;) {
        const std::uint32_t piece = size - done < kPiece ? size - done : kPiece;
        if (call_dos(0x3f00, handle, static_cast<std::uint16_t>(piece), 0) != static_cast<std::int32_t>(piece))
            return false;
        memcpy(static_cast<std::uint8_t*>(to) + done, dos_buffer(), piece);
        done += piece;
    }
    return true;
}

// A damaged DOS file must not refer to memory outside it.
bool is_sound(const Entry& entry, const Head& head) {
    return entry.name[kNameSize - 1] == 0 && name_in(kFolder, entry.name) != nullptr && entry.offset <= head.size &&
           entry.size <= head.size - entry.offset;
}

void add_files(const std::uint8_t* archive, const Head& head) {
    const auto* const entries = reinterpret_cast<const Entry*>(archive + kHead);
    for (std::uint32_t i = 0; i < head.count; ++i) {
        if (!is_sound(entries[i], head)) continue;
        const int file = make_file(Path(entries[i].name), false);
        if (file < 0 || !make_room(file_of(file), entries[i].size)) return;
        memcpy(const_cast<std::uint8_t*>(file_of(file).bytes), archive + entries[i].offset, entries[i].size);
        file_of(file).size = entries[i].size;
    }
}

void read_kept_file(std::uint16_t handle) {
    Head head;
    if (!read_all(handle, &head, kHead) || head.size < kHead || head.size > 4 << 20 || head.count > kMostFiles ||
        head.size < kHead + sizeof(Entry) * head.count)
        return;
    auto* const archive = static_cast<std::uint8_t*>(take_pages(whole_pages(head.size)));
    if (archive == nullptr) return;
    if (read_all(handle, archive + kHead, head.size - kHead)) add_files(archive, head);
    free_pages(archive, whole_pages(head.size));
}

// Collects data into pieces for DOS.
class Writer {
  public:
    explicit Writer(std::uint16_t handle) : handle_(handle) {}

    void add(const void* bytes, std::uint32_t size) {
        const auto* from = static_cast<const std::uint8_t*>(bytes);
        while (size > 0) {
            const std::uint32_t piece = size < kPiece - used_ ? size : kPiece - used_;
            memcpy(dos_buffer() + used_, from, piece);
            used_ += piece, from += piece, size -= piece;
            if (used_ == kPiece) flush();
        }
    }
    void flush() {
        if (used_ > 0 && error_ == 0) {
            const std::int32_t written = call_dos(0x4000, handle_, static_cast<std::uint16_t>(used_), 0);
            if (written != static_cast<std::int32_t>(used_)) error_ = written < 0 ? kReadOnly : kNoSpace;
        }
        used_ = 0;
    }
    std::int32_t error() const { return error_; }

  private:
    std::uint16_t handle_;
    std::uint32_t used_ = 0;
    std::int32_t error_ = 0;
};

template <class Use>
void for_each_kept(Use use) {
    for (int i = 0; i < kMostFiles; ++i)
        if (is_kept(file_of(i))) use(file_of(i));
}

std::int32_t write_kept(std::uint16_t handle) {
    Head head{};
    for_each_kept([&](const File& file) { ++head.count, head.size += file.size; });
    std::uint32_t offset = kHead + sizeof(Entry) * head.count;
    head.size += offset;
    Writer writer(handle);
    writer.add(&head, kHead);
    for_each_kept([&](const File& file) {
        Entry entry{{}, offset, file.size};
        memcpy(entry.name, file.name, kNameSize);
        writer.add(&entry, sizeof entry);
        offset += file.size;
    });
    for_each_kept([&](const File& file) { writer.add(file.bytes, file.size); });
    writer.flush();
    return writer.error();
}

}  // namespace

bool is_in_kept_folder(const char* name) {
    return name_in(kFolder, name) != nullptr;
}

bool is_kept(const File& file) {
    if (file.is_folder || file.size == 0 || !is_in_kept_folder(file.name)) return false;
    std::uint32_t length = 0, same = 0;
    while (file.name[length] != 0) ++length;
    constexpr std::uint32_t kEnd = sizeof kUnfinished - 1;
    while (same < kEnd && length > kEnd && file.name[length - kEnd + same] == kUnfinished[same]) ++same;
    return same < kEnd;
}

void read_kept_files() {
    if (dos_buffer() == nullptr) return;
    make_file(Path(kFolder), true);
    std::int32_t handle = open_kept(kKept);
    if (handle < 0) handle = open_kept(kNew);  // power was lost between removing the old file and renaming the new one
    if (handle < 0) return;
    read_kept_file(static_cast<std::uint16_t>(handle));
    call_dos(0x3e00, static_cast<std::uint16_t>(handle), 0, 0);
}

std::int32_t keep_files() {
    if (dos_buffer() == nullptr) return 0;
    const std::int32_t made = call_dos(0x3c00, 0, 0, put_name(kNew, kNames));
    if (made < 0) return kReadOnly;
    const auto handle = static_cast<std::uint16_t>(made);
    std::int32_t error = write_kept(handle);
    if (call_dos(0x3e00, handle, 0, 0) < 0 && error == 0) error = kNoSpace;
    if (error != 0) {
        call_dos(0x4100, 0, 0, put_name(kNew, kNames));
        return error;
    }
    call_dos(0x4100, 0, 0, put_name(kKept, kNames));
    const bool is_done = call_dos(0x5600, 0, 0, put_name(kNew, kNames), put_name(kKept, kNames + sizeof kKept)) >= 0;
    return is_done ? 0 : kReadOnly;
}

}  // namespace oblong::dos
