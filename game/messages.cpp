#include "game/messages.h"

#include <algorithm>
#include <utility>

#include "tools/common/font.h"
#include "tools/common/text.h"

namespace oblong {
namespace {

constexpr std::uint64_t kLeast_us = 2'500'000, kLetter_us = 60'000;

std::vector<std::string_view> wrapped(const std::string& text, std::int32_t columns) {
    return lines_of(text, columns * kGlyphAdvance_px);
}

}  // namespace

std::uint64_t Messages::reading_time_us(const std::string& text) {
    return std::max(kLeast_us, text.size() * kLetter_us);
}

void Messages::show(std::string text, MessageKind kind) {
    const std::uint64_t time_us = reading_time_us(text);
    const auto same = std::find_if(messages_.begin(), messages_.end(), [&](const Message& message) {
        return kind == MessageKind::Answer ? message.kind == kind : message.text == text;
    });
    if (same == messages_.end())
        messages_.push_back({std::move(text), kind, time_us});
    else
        *same = {std::move(text), kind, time_us};
}

void Messages::pass_time(std::uint64_t now_us) {
    const std::uint64_t elapsed_us = now_us - std::exchange(last_us_, now_us);
    for (std::size_t i = 0; i < up_; ++i) messages_[i].left_us -= std::min(messages_[i].left_us, elapsed_us);
    std::erase_if(messages_, [](const Message& message) { return message.left_us == 0; });
    up_ = 0;
}

// What does not fit becomes the message after it.
void Messages::split_first(std::int32_t columns, std::size_t most_lines) {
    Message& first = messages_.front();
    const std::vector<std::string_view> all = wrapped(first.text, columns);
    if (all.size() <= most_lines) return;
    const auto kept = static_cast<std::size_t>(all[most_lines].data() - first.text.data());
    std::string rest = first.text.substr(kept);
    const MessageKind kind = first.kind;
    const std::uint64_t time_us = reading_time_us(rest);
    first.text.resize(kept);
    while (!first.text.empty() && (first.text.back() == ' ' || first.text.back() == '\n')) first.text.pop_back();
    first.left_us = std::min(first.left_us, reading_time_us(first.text));
    messages_.insert(messages_.begin() + 1, {std::move(rest), kind, time_us});
}

std::vector<std::string> Messages::lines(std::uint64_t now_us, std::int32_t columns, std::size_t most_lines) {
    pass_time(now_us);
    std::vector<std::string> shown;
    if (messages_.empty() || most_lines == 0) return shown;
    split_first(columns, most_lines);
    for (const Message& message : messages_) {
        const std::vector<std::string_view> of = wrapped(message.text, columns);
        if (shown.size() + of.size() > most_lines) break;
        shown.insert(shown.end(), of.begin(), of.end());
        ++up_;
    }
    return shown;
}

}  // namespace oblong
