#include "engine/programs/frame_log.h"

#include <algorithm>
#include <cstdio>

#include "engine/base/text.h"
#include "engine/programs/arguments.h"

namespace oblong {
namespace {

std::string counted(std::size_t count, const char* what) {
    return std::to_string(count) + " " + what;
}

template <class Table>
std::size_t bytes_of(const Table& table) {
    return table.size() * sizeof(*table.data());
}

std::size_t texture_bytes(const Level& level) {
    std::size_t bytes = 0;
    for (const MipTexture& texture : level.textures)
        for (const auto& mip : texture.mips) bytes += mip.size();
    return bytes;
}

std::size_t geometry_bytes(const Level& level) {
    return bytes_of(level.vertices) + bytes_of(level.edges) + bytes_of(level.surf_edges) + bytes_of(level.faces) +
           bytes_of(level.mark_faces) + bytes_of(level.texinfos);
}

std::size_t tree_bytes(const Level& level) {
    return bytes_of(level.planes) + bytes_of(level.nodes) + bytes_of(level.leaves) + bytes_of(level.clip_nodes) +
           bytes_of(level.models);
}

std::size_t claim_bytes(const Claims& claims) {
    std::size_t bytes = bytes_of(claims.spans);
    for (const auto& list : claims.lists) bytes += bytes_of(list);
    return bytes;
}

/// The memory of a part of a room.
struct MemoryUse {
    const char *room, *part;
    std::size_t bytes;
};

std::vector<MemoryUse> memory_of(const LoggedFrame& frame) {
    const Level& level = frame.scene.level;
    const FrameWorkspace& work = frame.work;
    const SurfaceCache& cache = work.cache.surfaces.cache();
    return {{"level", "geometry", geometry_bytes(level)},
            {"level", "tree", tree_bytes(level)},
            {"level", "light", level.lighting.size()},
            {"level", "visible sets", level.visibility.size()},
            {"level", "textures", texture_bytes(level)},
            {"scene", "face table", bytes_of(work.cache.faces.faces) + bytes_of(work.cache.faces.corners)},
            {"geometry", "vertex cache", work.view.claiming->vertices.bytes()},
            {"visibility", "span buffer", work.view.claiming->span_buffer.bytes()},
            {"visibility", "walk",
             bytes_of(work.view.claiming->walk.face_marks) + bytes_of(work.view.claiming->walk.steps)},
            {"surface", "colormap", sizeof frame.scene.colormap},
            {"surface", "lit surfaces", cache.used_bytes()},
            {"surface", "table of lit surfaces", cache.bytes() - cache.arena_bytes()},
            {"effects", "sky", bytes_of(work.cache.sky_layers.tile)},
            {"frame", "claims", claim_bytes(work.view.claims)},
            {"frame", "workspace", sizeof work},
            {"screen", "framebuffer", pixel_count(frame.mode.width_px, frame.mode.height_px)}};
}

}  // namespace

LogChannels parse_log_channels(const std::string& text) {
    LogChannels channels;
    for (const std::string& name : split(text, ",")) {
        const auto known = std::find(kLogChannelNames.begin(), kLogChannelNames.end(), name);
        if (known == kLogChannelNames.end())
            throw UsageError("--log: '" + text + "', expected names of " + names_of(LogChannels::all()));
        channels = channels | LogChannels::only(static_cast<LogChannel>(known - kLogChannelNames.begin()));
    }
    return channels;
}

std::string names_of(LogChannels channels) {
    std::string names;
    for (std::size_t i = 0; i < kLogChannelCount; ++i)
        if (channels.has(static_cast<LogChannel>(i)))
            names += (names.empty() ? "" : ",") + std::string(kLogChannelNames[i]);
    return names.empty() ? "off" : names;
}

LogChannels next_channels(LogChannels channels) {
    if (channels == LogChannels::all()) return {};
    for (std::size_t i = 0; i < kLogChannelCount; ++i) {
        const auto channel = static_cast<LogChannel>(i);
        if (channels != LogChannels::only(channel)) continue;
        return i + 1 < kLogChannelCount ? LogChannels::only(static_cast<LogChannel>(i + 1)) : LogChannels::all();
    }
    return LogChannels::only(LogChannel::Level);
}

LogLines level_lines(const LoggedFrame& frame) {
    const Level& level = frame.scene.level;
    LogLines lines{counted(level.planes.size(), "planes"),
                   counted(level.vertices.size(), "vertices"),
                   counted(level.edges.size(), "edges"),
                   counted(level.faces.size(), "faces"),
                   counted(level.nodes.size(), "nodes"),
                   counted(level.leaves.size(), "leaves"),
                   counted(level.clip_nodes.size(), "clipnodes"),
                   counted(level.models.size(), "models"),
                   counted(level.textures.size(), "textures"),
                   counted(level.entities.size(), "entities"),
                   counted(level.lighting.size(), "bytes of light"),
                   counted(level.visibility.size(), "bytes of visible sets")};
    lines.push_back(counted(frame.work.cache.faces.torn_edges, "torn edges"));
    for (const auto* warnings : {&frame.work.cache.effects.warnings, &frame.work.cache.things.warnings})
        for (const std::string& warning : *warnings) lines.push_back("warning: " + warning);
    return lines;
}

LogLines memory_lines(const LoggedFrame& frame) {
    LogLines lines;
    std::size_t all = 0;
    for (const MemoryUse& use : memory_of(frame)) {
        lines.push_back(std::string(use.room) + ": " + use.part + " " + counted(use.bytes, "bytes"));
        all += use.bytes;
    }
    lines.push_back("all rooms: " + counted(all, "bytes"));
    return lines;
}

LogLines cache_lines(const LoggedFrame& frame, CacheTotals& before) {
    const FaceSurfaces& surfaces = frame.work.cache.surfaces;
    const CacheTotals now{surfaces.built_surfaces(), surfaces.built_texels(), surfaces.cache().evicted_surfaces()};
    const std::size_t asked = frame.work.view.claims.list(FaceList::Walls).size();
    LogLines lines{
        counted(asked, "lit faces in this frame"),
        std::to_string(now.surfaces - before.surfaces) + " surfaces built since the last line, of " +
            std::to_string(now.texels - before.texels) + " texels; " + std::to_string(now.evicted - before.evicted) +
            " evicted",
        counted(surfaces.cache().used_bytes(), "bytes used of") + " " + std::to_string(surfaces.cache().arena_bytes())};
    before = now;
    return lines;
}

void FrameLog::note(const LoggedFrame& frame) {
    const auto write = [&](LogChannel channel, const LogLines& lines) {
        for (const std::string& line : lines) write_(std::string(item(kLogChannelNames, channel)) + ": " + line);
    };
    if (channels_.has(LogChannel::Level) && !has_begun_) write(LogChannel::Level, level_lines(frame));
    has_begun_ = true;
    if (channels_.has(LogChannel::Memory)) write(LogChannel::Memory, memory_lines(frame));
    if (channels_.has(LogChannel::Matrices)) write(LogChannel::Matrices, matrix_lines(frame));
    if (channels_.has(LogChannel::Clip)) write(LogChannel::Clip, clip_lines(frame));
    if (channels_.has(LogChannel::Spans)) write(LogChannel::Spans, span_lines(frame));
    if (channels_.has(LogChannel::Cache)) write(LogChannel::Cache, cache_lines(frame, cache_));
}

void FrameLog::note_each_second(const LoggedFrame& frame, std::uint64_t now_us) {
    if (now_us < next_us_) return;
    next_us_ = now_us + 1'000'000;
    note(frame);
}

FrameLog::Write standard_error_lines() {
    return [](const std::string& line) { std::fprintf(stderr, "%s\n", line.c_str()); };
}

}  // namespace oblong
