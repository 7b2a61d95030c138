#include "engine/files/log_channels.h"

#include <algorithm>

#include "engine/base/text.h"
#include "engine/files/arguments.h"

namespace oblong {

LogChannels parse_log_channels(const std::string& text) {
    LogChannels channels;
    for (const std::string& name : split(text, ',')) {
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

}  // namespace oblong
