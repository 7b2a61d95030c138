#include "game/program/view_choice.h"

#include <algorithm>
#include <array>

namespace oblong {
namespace {

struct ViewRung {
    ViewSize size;
    Preset preset;
    std::uint64_t cost;  // of a picture, per cent of the first rung's on QEMU's 486
};

// Smaller ones are hardly faster: most of what is left is work for no pixel.
constexpr std::array<ViewRung, 7> kViewRungs{{{{100, false}, Preset::Pixel, 100},
                                              {{100, true}, Preset::Pixel, 90},
                                              {{90, true}, Preset::Pixel, 83},
                                              {{80, true}, Preset::Pixel, 76},
                                              {{70, true}, Preset::Pixel, 70},
                                              {{60, true}, Preset::Pixel, 63},
                                              {{60, true}, Preset::Year1991, 58}}};

void take_rung(const ViewRung& rung, Preferences& preferences) {
    static_cast<ViewSize&>(preferences) = rung.size;
    preferences.preset = rung.preset;
    preferences.accuracy = accuracy_of(rung.preset);
}

bool is_on_rung(const ViewRung& rung, const Preferences& preferences) {
    return static_cast<const ViewSize&>(preferences) == rung.size && preferences.accuracy == accuracy_of(rung.preset);
}

}  // namespace

void ViewChoice::begin(Preferences& preferences) {
    *this = {};
    is_on_ = true;
    take_rung(kViewRungs.front(), preferences);
}

void ViewChoice::note(std::uint64_t drawing_us, Preferences& preferences) {
    constexpr int kUncounted = 2, kCounted = 4;
    const ViewRung& now = kViewRungs[rung_];
    is_on_ = is_on_ && is_on_rung(now, preferences);
    if (!is_on_ || ++pictures_ <= kUncounted) return;
    total_us_ += drawing_us;
    if (pictures_ < kUncounted + kCounted) return;
    const std::uint64_t mean_us = total_us_ / kCounted;
    const auto next = std::find_if(kViewRungs.begin() + static_cast<std::ptrdiff_t>(rung_), kViewRungs.end() - 1,
                                   [&](const ViewRung& one) { return mean_us * one.cost <= kMost_us * now.cost; });
    is_on_ = &*next != &now;
    rung_ = static_cast<std::size_t>(next - kViewRungs.begin());
    pictures_ = 0;
    total_us_ = 0;
    take_rung(*next, preferences);
}

}  // namespace oblong
