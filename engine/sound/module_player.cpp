#include "engine/sound/module_player.h"

#include <algorithm>
#include <array>
#include <utility>

#include "engine/base/table.h"

namespace oblong {
namespace {

constexpr std::int32_t kLeastBeats = 32;
constexpr std::int32_t kOwnSide_256 = 192;  // the initial share of a channel's own side

/// The effects by number; those of kExtended by the parameter's upper half.
enum ModuleEffect : std::uint8_t {
    kArpeggio,
    kSlideUp,
    kSlideDown,
    kSlideToNote,
    kVibrato,
    kSlideToNoteAndVolume,
    kVibratoAndVolume,
    kTremolo,
    kPanning,
    kOffset,
    kVolumeSlide,
    kJump,
    kVolume,
    kBreak,
    kExtended,
    kSpeed
};
enum Extended : std::uint8_t {
    kFineSlideUp = 1,
    kFineSlideDown,
    kSemitones,
    kVibratoForm,
    kFinetune,
    kLoop,
    kTremoloForm,
    kRetrigger = 9,
    kFineVolumeUp,
    kFineVolumeDown,
    kCut,
    kDelay,
    kHold
};

std::int32_t upper(const ModuleNote& note) {
    return note.parameter >> 4;
}
std::int32_t lower(const ModuleNote& note) {
    return note.parameter & 15;
}

bool slides_to_note(const ModuleNote& note) {
    return note.effect == kSlideToNote || note.effect == kSlideToNoteAndVolume;
}

std::int32_t bounded_volume(std::int32_t volume_64) {
    return std::clamp(volume_64, 0, kMostModuleVolume_64);
}

}  // namespace

// Channels are left, right, right, left, as on the Amiga.
ModulePlayer::ModulePlayer(TrackerModule module) : module_(std::move(module)), channels_(module_.channels) {
    for (std::size_t i = 0; i < channels_.size(); ++i) {
        const bool is_right = i % 4 == 1 || i % 4 == 2;
        channels_[i].right_share_256 = is_right ? kOwnSide_256 : 256 - kOwnSide_256;
    }
    begin_row();
}

void ModulePlayer::add(std::span<std::int32_t> sums, std::int32_t volume_256) {
    while (!sums.empty()) {
        if (samples_left_ == 0) begin_tick();
        const std::size_t frames = std::min(sums.size() / 2, as_size(samples_left_));
        if (frames == 0) return;
        for (ModuleChannel& channel : channels_) channel.add(sums.first(2 * frames), volume_256);
        sums = sums.subspan(2 * frames);
        samples_left_ -= static_cast<std::int32_t>(frames);
        if (samples_left_ == 0) go_on();
    }
}

// A tick is 1/50 s at 125 beats a minute.
void ModulePlayer::begin_tick() {
    constexpr std::int32_t kSamplesTimesBeats = kRate_hz * 5 / 2;
    rest_ += kSamplesTimesBeats;
    samples_left_ = rest_ / beats_;
    rest_ %= beats_;
}

void ModulePlayer::go_on() {
    if (++tick_ >= speed_) {
        tick_ = 0;
        place_ = next_;
        if (rows_left_ == 0) return begin_row();
    }
    for (ModuleChannel& channel : channels_) apply_at_tick(channel);
    if (tick_ == 0) find_next();
}

void ModulePlayer::begin_row() {
    const std::span<const ModuleNote> row = module_.row(module_.orders[place_.order], place_.row);
    for (std::size_t i = 0; i < channels_.size(); ++i) {
        begin_note(channels_[i], row[i]);
        apply_at_row(channels_[i]);
    }
    find_next();
}

// ProTracker looks for the next row as soon as a row begins. So a row that is held and left by a jump or a break plays
// the rest of its times at the beginning of where that leads, and the row there is not heard.
void ModulePlayer::find_next() {
    next_ = {place_.order, place_.row + 1};
    if (rows_asked_ > 0) rows_left_ = std::exchange(rows_asked_, 0);
    if (rows_left_ > 0 && --rows_left_ > 0) next_.row = place_.row;
    if (loop_to_) next_.row = *loop_to_;
    const bool is_left = order_to_ || row_to_ || next_.row >= kPatternRows;
    if (is_left) next_ = {order_to_.value_or(place_.order + 1), loop_to_ ? 0 : row_to_.value_or(0)};
    if (next_.order >= module_.orders.size()) next_.order = module_.restart;
    order_to_ = row_to_ = loop_to_ = std::nullopt;
}

// An offset counts twice for a note that names its sample: once now, and once for notes that follow without one.
void ModulePlayer::begin_note(ModuleChannel& channel, const ModuleNote& note) {
    channel.note = note;
    if (note.sample > 0) channel.take(module_.samples[note.sample - std::size_t{1}]);
    if (note.sample > 0 && module_.is_protrackers) channel.swap();
    const bool is_delayed = note.effect == kExtended && upper(note) == kDelay;
    if (note.effect == kExtended && upper(note) == kFinetune)
        channel.finetune_8 = lower(note) < 8 ? lower(note) : lower(note) - 16;
    if (note.effect == kOffset && note.parameter > 0) channel.offset = std::size_t{note.parameter} * 256;
    if (note.period > 0 && slides_to_note(note)) channel.target_8 = channel.tuned_8(note.period);
    if (note.period > 0 && !slides_to_note(note)) {
        channel.period_8 = channel.tuned_8(note.period);
        if (channel.vibrato.form < 4) channel.vibrato.at_64 = 0;
        if (channel.tremolo.form < 4) channel.tremolo.at_64 = 0;
        if (note.effect == kOffset) channel.skip();
        if (!is_delayed) channel.strike();
    }
    if (!is_delayed) channel.heard_period_8 = channel.period_8;
    channel.heard_volume_64 = channel.volume_64;
}

void ModulePlayer::apply_at_row(ModuleChannel& channel) {
    const ModuleNote& note = channel.note;
    switch (note.effect) {
        case kSlideToNote:
            if (note.parameter > 0) channel.slide_8 = note.parameter * 256;
            break;
        case kVibrato:
            channel.vibrato.set(note.parameter);
            break;
        case kTremolo:
            channel.tremolo.set(note.parameter);
            break;
        case kPanning:
            channel.right_share_256 = note.parameter;
            break;
        case kOffset:
            if (note.period == 0 || module_.is_protrackers) channel.skip();
            break;
        case kJump:
            order_to_ = note.parameter;
            row_to_ = 0;
            break;
        case kVolume:
            channel.volume_64 = channel.heard_volume_64 = bounded_volume(note.parameter);
            break;
        case kBreak:
            row_to_ = as_size(upper(note) * 10 + lower(note));
            if (*row_to_ >= kPatternRows) row_to_ = 0;
            break;
        case kExtended:
            apply_extended(channel);
            break;
        case kSpeed:
            if (note.parameter >= kLeastBeats)
                beats_ = note.parameter;
            else if (note.parameter > 0)
                speed_ = note.parameter;
            break;
        default:
            break;
    }
}

// In each tick but those with which rows begin; in the first one of a row that is held, too.
void ModulePlayer::apply_at_tick(ModuleChannel& channel) {
    const ModuleNote& note = channel.note;
    if (note.effect == kExtended) return apply_extended(channel);
    bend(channel);
    const bool slides_volume =
        note.effect == kVolumeSlide || note.effect == kSlideToNoteAndVolume || note.effect == kVibratoAndVolume;
    const std::int32_t by = upper(note) > 0 ? upper(note) : -lower(note);
    if (slides_volume) channel.volume_64 = bounded_volume(channel.volume_64 + by);
    channel.heard_volume_64 = channel.volume_64;
    if (note.effect == kTremolo) {
        ModuleWave& wave = channel.tremolo;
        channel.heard_volume_64 = bounded_volume(channel.volume_64 + wave.value_255() * wave.depth / 64);
        wave.advance();
    }
}

/// What changes a channel's period, or only the one that is heard.
void ModulePlayer::bend(ModuleChannel& channel) {
    const ModuleNote& note = channel.note;
    if (note.effect == kSlideUp) slide(channel, -note.parameter);
    if (note.effect == kSlideDown) slide(channel, note.parameter);
    if (slides_to_note(note) && channel.target_8 > 0) {
        channel.period_8 += std::clamp(channel.target_8 - channel.period_8, -channel.slide_8, channel.slide_8);
        if (channel.period_8 == channel.target_8) channel.target_8 = 0;
    }
    channel.heard_period_8 = channel.period_8;
    if (slides_to_note(note) && channel.slides_by_semitones && channel.period_8 > 0)
        channel.heard_period_8 = channel.stepped_8();
    if (note.effect == kArpeggio)
        channel.heard_period_8 =
            channel.raised_8(std::array{0, upper(note), lower(note)}[as_size(tick_ % 3)], module_.is_protrackers);
    if (note.effect != kVibrato && note.effect != kVibratoAndVolume) return;
    ModuleWave& wave = channel.vibrato;
    channel.heard_period_8 += wave.value_255() * wave.depth / 128 * 256;
    wave.advance();
}

void ModulePlayer::slide(ModuleChannel& channel, std::int32_t by) const {
    if (channel.period_8 > 0)
        channel.period_8 = channel.heard_period_8 =
            std::clamp(channel.period_8 + by * 256, module_.least_period() * 256, module_.most_period() * 256);
}

// In each tick of a row; a row that is held has a first tick each time.
void ModulePlayer::apply_extended(ModuleChannel& channel) {
    const std::int32_t value = lower(channel.note);
    const std::int32_t which = upper(channel.note);
    const bool is_first = tick_ == 0, has_period = channel.note.period > 0;
    if (which == kRetrigger && value > 0 && tick_ % value == 0 && !(is_first && has_period)) channel.strike();
    if (which == kDelay && tick_ == value && has_period) channel.strike();
    if (which == kCut && tick_ == value) channel.volume_64 = 0;
    if (is_first && which == kFineSlideUp) slide(channel, -value);
    if (is_first && which == kFineSlideDown) slide(channel, value);
    if (is_first && which == kFineVolumeUp) channel.volume_64 += value;
    if (is_first && which == kFineVolumeDown) channel.volume_64 -= value;
    channel.heard_volume_64 = channel.volume_64 = bounded_volume(channel.volume_64);
    if (which == kSemitones) channel.slides_by_semitones = value > 0;
    if (which == kVibratoForm) channel.vibrato.form = value;
    if (which == kTremoloForm) channel.tremolo.form = value;
    if (is_first && which == kHold && rows_left_ == 0) rows_asked_ = value + 1;
    if (is_first && which == kLoop && value == 0) channel.loop_row = place_.row;
    if (is_first && which == kLoop && value > 0) {
        channel.loops_left = channel.loops_left == 0 ? value : channel.loops_left - 1;
        if (channel.loops_left > 0) loop_to_ = channel.loop_row;
    }
}

}  // namespace oblong
