#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "tests/saves/traced_process.h"

namespace oblong::test {

/// A disk below a folder, as system calls leave it when the power fails: what a file holds is sure once that file was
/// synced, and that a name is there, gone or another's once its folder was. Of the rest any part may have been written.
class ForgetfulDisk {
  public:
    using Bytes = std::vector<std::uint8_t>;
    using Files = std::map<std::string, Bytes>;  ///< by their whole paths

    explicit ForgetfulDisk(std::string folder) : folder_(std::move(folder)) {
        for (const auto& entry : std::filesystem::recursive_directory_iterator(folder_)) {
            if (entry.is_directory()) names_[entry.path().string()] = kFolder;
            if (!entry.is_regular_file()) continue;
            const Bytes bytes = read_file(entry.path().string());
            names_[entry.path().string()] = add_file({bytes, bytes});
        }
    }

    /// A call that has ended. True if what may be lost is another now.
    bool note(const SystemCall& call) {
        if (call.result < 0) return false;
        if (call.number == SYS_openat) return note_opening(call);
        if (call.number == SYS_write) return note_writing(call);
        if (call.number == SYS_fsync || call.number == SYS_fdatasync) return note_syncing(call);
        if (call.number == SYS_close) open_.erase(call.arguments[0]);
        if (!is_below(call.path)) return false;
        if (!call.second_path.empty()) return change({call.path, {}, call.second_path, now(call.path)});
        return change({call.path, call.number == kMakeFolder ? std::optional(kFolder) : std::nullopt, "", {}});
    }

    /// Each state in which the power may leave the disk now.
    void for_each_loss(const std::function<void(const Files&)>& body) const {
        for (std::uint32_t kept = 0; kept < 1u << pending_.size(); ++kept) {
            auto names = names_;
            for (std::size_t i = 0; i < pending_.size(); ++i)
                if (kept >> i & 1) apply(pending_[i], names);
            for (const int part : {0, 1, 2}) body(files(names, part));
        }
    }

  private:
    struct File {
        Bytes sure, written;
    };
    // A name gets a file or loses it, and another may get one in the same moment.
    struct Change {
        std::string name;
        std::optional<std::size_t> file;
        std::string other_name;
        std::optional<std::size_t> other_file;
    };
    using Names = std::map<std::string, std::size_t>;
    static constexpr std::size_t kFolder = ~std::size_t{0};
#ifdef SYS_mkdir
    static constexpr std::uint64_t kMakeFolder = SYS_mkdir;
#else
    static constexpr std::uint64_t kMakeFolder = SYS_mkdirat;
#endif

    static std::string folder_of(const std::string& path) {
        return std::filesystem::path(path).parent_path().string();
    }
    bool is_below(const std::string& path) const {
        return path.starts_with(folder_);
    }
    std::size_t add_file(File file) {
        files_.push_back(std::move(file));
        return files_.size() - 1;
    }
    static void apply(const Change& change, Names& names) {
        if (change.file)
            names[change.name] = *change.file;
        else
            names.erase(change.name);
        if (change.other_file) names[change.other_name] = *change.other_file;
    }
    std::optional<std::size_t> now(const std::string& name) const {
        Names names = names_;
        for (const Change& change : pending_) apply(change, names);
        const auto found = names.find(name);
        return found == names.end() ? std::nullopt : std::optional(found->second);
    }
    bool change(Change change) {
        pending_.push_back(std::move(change));
        return true;
    }
    bool note_opening(const SystemCall& call) {
        if (!is_below(call.path)) return false;
        open_[static_cast<std::uint64_t>(call.result)] = call.path;
        if ((call.arguments[2] & O_CREAT) == 0 || now(call.path)) return false;
        return change({call.path, add_file({}), "", {}});
    }
    bool note_writing(const SystemCall& call) {
        const auto open = open_.find(call.arguments[0]);
        if (open == open_.end()) return false;
        Bytes& written = files_[*now(open->second)].written;
        written.insert(written.end(), call.data.begin(), call.data.begin() + call.result);
        return true;
    }
    bool note_syncing(const SystemCall& call) {
        const auto open = open_.find(call.arguments[0]);
        if (open == open_.end()) return false;
        if (const auto file = now(open->second); file && *file != kFolder) {
            files_[*file].sure = files_[*file].written;
            return true;
        }
        std::erase_if(pending_, [&](const Change& each) {
            if (folder_of(each.name) != open->second) return false;
            apply(each, names_);
            return true;
        });
        return true;
    }
    // Nothing, half or all of what is not sure of each file's content has been written.
    Files files(const Names& names, int part) const {
        Files whole;
        for (const auto& [name, file] : names) {
            const std::string folder = folder_of(name);
            if (file == kFolder || (folder != folder_ && !names.contains(folder))) continue;
            const File& from = files_[file];
            whole[name] = part == 0 ? from.sure : from.written;
            if (part == 1 && from.sure != from.written) whole[name].resize(from.written.size() / 2);
        }
        return whole;
    }

    const std::string folder_;
    std::vector<File> files_;
    Names names_;                  // for sure
    std::vector<Change> pending_;  // in their order
    std::map<std::uint64_t, std::string> open_;
};

}  // namespace oblong::test
