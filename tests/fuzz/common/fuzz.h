#pragma once

#include <cstdint>
#include <random>
#include <span>
#include <string>
#include <string_view>
#include <vector>

/// What the fuzz targets have in common. A target is a file in targets/ that defines run(), and perhaps mutate().
namespace oblong::fuzz {

using Input = std::span<const std::uint8_t>;
using Bytes = std::vector<std::uint8_t>;

/// Handles one input. An InputError or FileError is an input refused, as it should be: it must name a place.
void run(Input input);

/// Alters an input where bytes altered at random would be refused too early; a target without one has mutate_bytes().
void mutate(Bytes& input, std::minstd_rand& random);
/// What is read before anything else is done, if that takes little time: throws as run() does. Where a target defines
/// it, an input is altered in some other way, and another, until it is read; but for one in eight.
void read(Input input);

/// Alters bytes as libFuzzer does; up to `growth` more of them.
void mutate_bytes(Bytes& bytes, std::size_t growth = 64);

/// Says how far an input came, in words: one that is the first to come there is kept, as one that reaches new code is.
/// Libraries that are not instrumented are led so. Digits, and what stands in quotes, make no difference.
void note_reached(std::string_view where);

/// Ends the program unless something that must hold does.
void expect(bool holds, const std::string& what);

std::size_t below(std::size_t limit, std::minstd_rand& random);
template <class List>
auto& one_of(const List& list, std::minstd_rand& random) {
    return list[below(std::size(list), random)];
}
/// A number in decimals, perhaps with a fraction.
std::string number_text(std::minstd_rand& random);
/// Writes another number in the place of one that a text has, if it has any.
void replace_number(std::string& text, std::minstd_rand& random);
/// Numbers at which readers go wrong: small ones, powers of two and their neighbours, and any.
std::int64_t odd_number(std::minstd_rand& random);

std::string text_of(Input input);
void set_text(Bytes& bytes, const std::string& text);

}  // namespace oblong::fuzz
