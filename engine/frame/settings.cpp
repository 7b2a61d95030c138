#include "engine/frame/settings.h"

#include <array>

namespace oblong {

namespace {

struct NamedTier {
    Tier tier;
    std::string_view name;
    Accuracy accuracy;
};

constexpr std::array<NamedTier, 5> kTiers{{
    {Tier::Year1991, "1991", {Texturing::Affine, 96, 0}},
    {Tier::Year1994, "1994", {Texturing::Affine, 96, 8}},
    {Tier::Year1996, "1996", {Texturing::Every16, 96, 8}},
    {Tier::Bounded, "bounded", {Texturing::Bounded, 96, 8}},
    {Tier::Exact, "exact", {Texturing::Exact, 96, 8}},
}};

const NamedTier& entry_of(Tier tier) {
    return kTiers[static_cast<std::size_t>(tier)];
}

}  // namespace

Accuracy accuracy_of(Tier tier) {
    return entry_of(tier).accuracy;
}

std::string_view name_of(Tier tier) {
    return entry_of(tier).name;
}

std::optional<Tier> tier_named(std::string_view name) {
    for (const NamedTier& entry : kTiers)
        if (entry.name == name) return entry.tier;
    return std::nullopt;
}

}  // namespace oblong
