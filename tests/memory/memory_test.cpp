#include <gtest/gtest.h>
#include <malloc.h>

#include <atomic>
#include <cstdlib>
#include <limits>
#include <new>

#include "engine/platform/headless.h"
#include "game/program/session.h"
#include "tests/support/folders.h"

namespace {

std::atomic<std::size_t> held_bytes{0}, most_bytes{0}, limit_bytes{std::numeric_limits<std::size_t>::max()};

}  // namespace

// A machine whose memory ends, as under DOS.
void* operator new(std::size_t bytes) {
    if (held_bytes + bytes > limit_bytes) throw std::bad_alloc();
    void* const memory = std::malloc(bytes);
    if (memory == nullptr) throw std::bad_alloc();
    held_bytes += malloc_usable_size(memory);
    most_bytes = std::max(most_bytes.load(), held_bytes.load());
    return memory;
}

void operator delete(void* memory) noexcept {
    held_bytes -= malloc_usable_size(memory);
    std::free(memory);
}

void operator delete(void* memory, std::size_t) noexcept {
    ::operator delete(memory);
}

namespace oblong::test {
namespace {

constexpr std::size_t kKB = 1024;

class Memory : public testing::Test {
  protected:
    /// A walk of 14 pictures with keys pressed before some of them: whether they were off again.
    bool play(std::initializer_list<Action> keys) {
        const std::vector<Action> pressed = keys;
        HeadlessPlatform platform(
            14, 35, [](std::int64_t) { return PlatformInput{}; }, [](Framebuffer, const Palette&) {});
        ViewOptions view_options;
        Session session(loaded_, {}, view_options, TickInputSource(start_of(loaded_->level), std::nullopt, true),
                        platform);
        bool is_off_again = false;
        for (std::size_t frame = 0; platform.is_open(); ++frame) {
            platform.poll();
            Controls controls;
            controls.moves = {Action::Forward, Action::TurnRight};
            if (frame % 3 == 1 && frame / 3 < pressed.size()) controls.commands = {pressed[frame / 3]};
            session.advance(controls, platform.now_us());
            const ShownPicture picture = session.draw(false);
            platform.present(picture.canvas, picture.palette, picture.rect);
            for (const std::string& message : session.messages())
                is_off_again |= message.find("Not enough memory") != std::string::npos;
        }
        return is_off_again;
    }

    const std::shared_ptr<const LoadedLevel> loaded_ =
        std::make_shared<const LoadedLevel>(LevelFiles{"", "", build_folder() + "/assets", ""});
};

// From what a walk needs to what everything needs. The picture that was left off wrote into a buffer that it had not
// got.
TEST_F(Memory, WhatDoesNotFitIsOffAgainAndTheWalkGoesOn) {
    const auto keys = {Action::LabPanel, Action::ErrorMap, Action::FourAspects, Action::FourAspects};
    const auto most_of = [&](std::initializer_list<Action> pressed) {
        most_bytes = held_bytes.load();
        EXPECT_FALSE(play(pressed));
        return most_bytes.load();
    };
    const std::size_t plain = most_of({}), all = most_of(keys);
    ASSERT_GT(all, plain + 512 * kKB);
    std::size_t off = 0, on = 0;
    for (std::size_t limit = plain + 16 * kKB; limit < all + 64 * kKB; limit += 48 * kKB) {
        limit_bytes = limit;
        bool is_off_again = false;
        EXPECT_NO_THROW(is_off_again = play(keys)) << (limit - plain) / kKB << " KB beyond the walk's";
        limit_bytes = std::numeric_limits<std::size_t>::max();
        ++(is_off_again ? off : on);
    }
    EXPECT_GT(off, 5u);
    EXPECT_GT(on, 0u);
}

}  // namespace
}  // namespace oblong::test
