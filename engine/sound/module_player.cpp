#include "engine/sound/module_player.h"

#include <algorithm>
#include <array>
#include <utility>

#include "engine/base/table.h"

namespace oblong {
namespace {

constexpr std::int32_t kLeastPeriod = 113, kMostPeriod = 856;
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
    kVibratoForm = 4,
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

std::int32_t bounded_period(std::int32_t period) {
    return std::clamp(period, kLeastPeriod, kMostPeriod);
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
    if (++tick_ < speed_ * (1 + rows_held_)) {
        for (ModuleChannel& channel : channels_) apply_at_tick(channel);
        return;
    }
    tick_ = rows_held_ = 0;
    if (!std::exchange(is_next_set_, false)) next_ = {place_.order, place_.row + 1};
    if (next_.row >= kPatternRows) next_ = {next_.order + 1, 0};
    if (next_.order >= module_.orders.size()) next_.order = module_.restart;
    place_ = next_;
    begin_row();
}

void ModulePlayer::begin_row() {
    const std::span<const ModuleNote> row = module_.row(module_.orders[place_.order], place_.row);
    for (std::size_t i = 0; i < channels_.size(); ++i) {
        begin_note(channels_[i], row[i]);
        apply_at_row(channels_[i]);
    }
}

void ModulePlayer::begin_note(ModuleChannel& channel, const ModuleNote& note) {
    channel.note = note;
    channel.semitones = 0;
    if (note.sample > 0) {
        channel.next_sample = &module_.samples[note.sample - std::size_t{1}];
        channel.volume_64 = channel.next_sample->volume_64;
        channel.finetune_8 = channel.next_sample->finetune_8;
    }
    const bool is_delayed = note.effect == kExtended && upper(note) == kDelay && lower(note) > 0;
    if (note.period > 0) {
        channel.target = note.period;
        if (!slides_to_note(note) && !is_delayed) channel.strike(note.period);
    }
    channel.heard_period = channel.period;
    channel.heard_volume_64 = channel.volume_64;
}

void ModulePlayer::apply_at_row(ModuleChannel& channel) {
    const ModuleNote& note = channel.note;
    switch (note.effect) {
        case kSlideToNote:
            if (note.parameter > 0) channel.slide = note.parameter;
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
            if (note.parameter > 0) channel.offset = std::size_t{note.parameter} * 256;
            if (note.period == 0 || channel.sample == nullptr) break;
            channel.at_32 = std::uint64_t{channel.offset} << 32;
            channel.is_playing = channel.offset < channel.sample->samples.size();
            break;
        case kJump:
            next_ = {note.parameter, 0};
            is_next_set_ = true;
            break;
        case kVolume:
            channel.volume_64 = channel.heard_volume_64 = bounded_volume(note.parameter);
            break;
        case kBreak:
            next_ = {is_next_set_ ? next_.order : place_.order + 1, as_size(upper(note) * 10 + lower(note))};
            if (next_.row >= kPatternRows) next_.row = 0;
            is_next_set_ = true;
            break;
        case kExtended:
            apply_extended_at_row(channel);
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

void ModulePlayer::apply_extended_at_row(ModuleChannel& channel) {
    const std::int32_t value = lower(channel.note);
    switch (upper(channel.note)) {
        case kFineSlideUp:
            channel.period = channel.heard_period = bounded_period(channel.period - value);
            break;
        case kFineSlideDown:
            channel.period = channel.heard_period = bounded_period(channel.period + value);
            break;
        case kVibratoForm:
            channel.vibrato.form = value;
            break;
        case kTremoloForm:
            channel.tremolo.form = value;
            break;
        case kFinetune:
            channel.finetune_8 = value < 8 ? value : value - 16;
            break;
        case kLoop:
            if (value == 0) {
                channel.loop_row = place_.row;
                break;
            }
            channel.loops_left = channel.loops_left == 0 ? value : channel.loops_left - 1;
            if (channel.loops_left == 0) break;
            next_ = {place_.order, channel.loop_row};
            is_next_set_ = true;
            break;
        case kFineVolumeUp:
            channel.volume_64 = channel.heard_volume_64 = bounded_volume(channel.volume_64 + value);
            break;
        case kFineVolumeDown:
            channel.volume_64 = channel.heard_volume_64 = bounded_volume(channel.volume_64 - value);
            break;
        case kCut:
            if (value == 0) channel.volume_64 = channel.heard_volume_64 = 0;
            break;
        case kHold:
            rows_held_ = value;
            break;
        default:
            break;
    }
}

// In each tick of a row except the first.
void ModulePlayer::apply_at_tick(ModuleChannel& channel) {
    const ModuleNote& note = channel.note;
    const bool has_vibrato = note.effect == kVibrato || note.effect == kVibratoAndVolume;
    channel.heard_period = channel.period;
    if (note.effect == kArpeggio) channel.semitones = std::array{0, upper(note), lower(note)}[as_size(tick_ % 3)];
    if (note.effect == kSlideUp) channel.period = bounded_period(channel.period - note.parameter);
    if (note.effect == kSlideDown) channel.period = bounded_period(channel.period + note.parameter);
    if (slides_to_note(note) && channel.period > 0) {
        const std::int32_t way = channel.target - channel.period;
        channel.period += std::clamp(way, -channel.slide, channel.slide);
    }
    if (!has_vibrato) channel.heard_period = channel.period;
    if (has_vibrato && channel.period > 0) {
        ModuleWave& wave = channel.vibrato;
        channel.heard_period = std::max(channel.period + wave.value_255() * wave.depth / 128, 1);
        wave.at_64 = (wave.at_64 + wave.speed) % 64;
    }
    if (note.effect == kVolumeSlide || note.effect == kSlideToNoteAndVolume || note.effect == kVibratoAndVolume) {
        const std::int32_t by = upper(note) > 0 ? upper(note) : -lower(note);
        channel.volume_64 = bounded_volume(channel.volume_64 + by);
    }
    channel.heard_volume_64 = channel.volume_64;
    if (note.effect == kTremolo) {
        ModuleWave& wave = channel.tremolo;
        channel.heard_volume_64 = bounded_volume(channel.volume_64 + wave.value_255() * wave.depth / 64);
        wave.at_64 = (wave.at_64 + wave.speed) % 64;
    }
    if (note.effect == kExtended) apply_extended_at_tick(channel);
}

void ModulePlayer::apply_extended_at_tick(ModuleChannel& channel) {
    const std::int32_t value = lower(channel.note), in_row = tick_ % speed_;
    const std::int32_t which = upper(channel.note);
    if (which == kRetrigger && value > 0 && in_row % value == 0) channel.strike(channel.period);
    if (which == kCut && in_row == value) channel.volume_64 = channel.heard_volume_64 = 0;
    if (which == kDelay && value > 0 && in_row == value && channel.note.period > 0) channel.strike(channel.note.period);
}

}  // namespace oblong
