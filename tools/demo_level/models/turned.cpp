#include "tools/demo_level/models/turned.h"

#include <cmath>

namespace oblong::model_source {

std::vector<std::vector<ModelPoint>> turned(const std::vector<ProfilePoint>& profile, int sides) {
    std::vector<std::vector<ModelPoint>> rows;
    for (const ProfilePoint& p : profile) {
        auto& row = rows.emplace_back();
        for (int i = 0; i < sides; ++i) {
            const double angle = -kTurn * i / sides;
            row.push_back({p.radius * std::cos(angle), p.y, p.radius * std::sin(angle)});
        }
    }
    return rows;
}

std::vector<ProfilePoint> sphere_profile(double radius, int rows) {
    std::vector<ProfilePoint> profile;
    for (int i = 0; i <= rows; ++i) {
        const double latitude = kTurn * (2 * i - rows) / (4 * rows);
        profile.push_back({radius * std::cos(latitude), radius * std::sin(latitude)});
    }
    return profile;
}

std::vector<ProfilePoint> lens_profile(double radius, double half_thickness, int rows) {
    std::vector<ProfilePoint> profile;
    for (int i = -rows; i <= rows; ++i) {
        const double across = 1 - std::abs(i) / static_cast<double>(rows);
        const double height = half_thickness * (1 - across * across);
        profile.push_back({radius * across, i < 0 ? -height : height});
    }
    return profile;
}

}  // namespace oblong::model_source
