#include "game/view/messages.h"

#include <algorithm>
#include <utility>

#include "engine/base/table.h"
#include "engine/draw/text.h"

namespace oblong {
namespace {

constexpr std::uint64_t kLeast_us = 2'500'000, kLetter_us = 60'000;
constexpr std::size_t kMostTold = 32;

std::vector<std::string_view> wrapped(const std::string& text, std::int32_t columns) {
    return lines_of(text, columns * kGlyphAdvance_px);
}

}  // namespace

std::uint64_t Messages::reading_time_us(const std::string& text) {
    return std::max(kLeast_us, text.size() * kLetter_us);
}

void Messages::show(std::string text) {
    std::erase(told_, text);
    told_.insert(told_.begin(), text);
    if (told_.size() > kMostTold) told_.pop_back();
    const std::uint64_t time_us = reading_time_us(text);
    parts_.assign(1, {std::move(text), time_us});
    is_up_ = false;
}

void Messages::pass_time(std::uint64_t now_us) {
    const std::uint64_t elapsed_us = now_us - std::exchange(last_us_, now_us);
    if (!std::exchange(is_up_, false)) return;
    Part& up = parts_.front();
    up.left_us -= std::min(up.left_us, elapsed_us);
    if (up.left_us == 0) parts_.erase(parts_.begin());
}

// The rest becomes the next part.
void Messages::split_first(std::int32_t columns, std::size_t most_lines) {
    Part& first = parts_.front();
    const std::vector<std::string_view> all = wrapped(first.text, columns);
    if (all.size() <= most_lines) return;
    const auto kept = as_size(all[most_lines].data() - first.text.data());
    std::string rest = first.text.substr(kept);
    const std::uint64_t time_us = reading_time_us(rest);
    first.text.resize(kept);
    while (!first.text.empty() && (first.text.back() == ' ' || first.text.back() == '\n')) first.text.pop_back();
    first.left_us = std::min(first.left_us, reading_time_us(first.text));
    parts_.insert(parts_.begin() + 1, {std::move(rest), time_us});
}

std::vector<std::string> Messages::lines(std::uint64_t now_us, std::int32_t columns, std::size_t most_lines) {
    pass_time(now_us);
    if (parts_.empty() || most_lines == 0) return {};
    split_first(columns, most_lines);
    is_up_ = true;
    const std::vector<std::string_view> shown = wrapped(parts_.front().text, columns);
    return {shown.begin(), shown.end()};
}

}  // namespace oblong
