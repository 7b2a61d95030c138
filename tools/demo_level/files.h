#pragma once

#include <string>

namespace oblong {

/// The palette as 768 bytes. Throws FileError where the file can't be written, as all these do.
void write_demo_palette(const std::string& path);

/// The level as a .map source.
void write_demo_map(const std::string& path);

/// Every texture of the demo level as an indexed PNG into `folder`, which is made.
void write_demo_textures(const std::string& folder);

}  // namespace oblong
