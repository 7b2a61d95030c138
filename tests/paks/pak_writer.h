#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "tests/support/bsp_writer.h"

namespace oblong::test {

struct PakFile {
    std::string name;
    Bytes data;
};

/// A pak file: header, the files' data, directory; as id's tools write it.
inline Bytes write_pak(const std::vector<PakFile>& files) {
    std::int32_t size = 12;
    for (const PakFile& file : files) size += static_cast<std::int32_t>(file.data.size());
    Bytes bytes;
    ByteWriter out(bytes);
    out.text("PACK").i32(size).i32(static_cast<std::int32_t>(64 * files.size()));
    for (const PakFile& file : files) bytes.insert(bytes.end(), file.data.begin(), file.data.end());
    std::int32_t offset = 12;
    for (const PakFile& file : files) {
        out.text(file.name);
        bytes.resize(bytes.size() + 56 - file.name.size());
        out.i32(offset).i32(static_cast<std::int32_t>(file.data.size()));
        offset += static_cast<std::int32_t>(file.data.size());
    }
    return bytes;
}

}  // namespace oblong::test
