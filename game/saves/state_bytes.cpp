#include <type_traits>

#include "engine/base/checksum.h"
#include "game/saves/saved_game.h"
#include "game/simulation/state.h"

namespace oblong {
namespace {

// The types that visit_fields() reaches: numbers, and lists of numbers or structs.
template <class Field>
concept PlainNumber = std::is_integral_v<Field> || std::is_enum_v<Field>;

class Writer {
  public:
    explicit Writer(std::vector<std::uint8_t>& bytes) : bytes_(bytes) {}

    template <PlainNumber Field>
    void operator()(const Field& field) {
        append_little_endian(bytes_, field);
    }
    template <class Int, int kFraction>
    void operator()(const Fixed<Int, kFraction>& number) {
        append_little_endian(bytes_, number.raw);
    }
    void operator()(const Angle& angle) { append_little_endian(bytes_, angle.bam); }
    void operator()(const HasFields auto& each) { visit_fields(each, *this); }
    template <class Element>
    void operator()(const std::vector<Element>& list) {
        append_little_endian(bytes_, static_cast<std::uint32_t>(list.size()));
        for (const Element& element : list) (*this)(element);
    }

  private:
    std::vector<std::uint8_t>& bytes_;
};

class FieldReader {
  public:
    explicit FieldReader(LittleEndianReader& bytes) : bytes_(bytes) {}

    template <PlainNumber Field>
    void operator()(Field& field) {
        field = bytes_.next<Field>();
    }
    void operator()(bool& field) {
        const auto byte = bytes_.next<std::uint8_t>();
        expect_at(bytes_.offset() - 1, byte <= 1, std::to_string(byte) + " for no or yes, expected 0 or 1");
        field = byte == 1;
    }
    template <class Int, int kFraction>
    void operator()(Fixed<Int, kFraction>& number) {
        number.raw = bytes_.next<Int>();
    }
    void operator()(Angle& angle) { angle.bam = bytes_.next<std::uint16_t>(); }
    void operator()(HasFields auto& each) { visit_fields(each, *this); }
    template <class Element>
    void operator()(std::vector<Element>& list) {
        const auto length = bytes_.next<std::uint32_t>();
        expect_at(bytes_.offset() - 4, length <= bytes_.rest(),
                  "a list of " + std::to_string(length) + " in the last " + std::to_string(bytes_.rest()) +
                      " bytes, expected one that fits there");
        list.resize(length);
        for (Element& element : list) (*this)(element);
    }

  private:
    LittleEndianReader& bytes_;
};

// A list is hashed as one of its elements between brackets.
class Layout {
  public:
    template <class Field>
    void operator()(const Field&) {
        fnv_.add(sizeof(Field));
        fnv_.add(std::is_enum_v<Field> ? 'e' : std::is_integral_v<Field> ? 'i' : 'f');
    }
    void operator()(const HasFields auto& each) { visit_fields(each, *this); }
    template <class Element>
    void operator()(const std::vector<Element>&) {
        fnv_.add('[');
        (*this)(Element{});
        fnv_.add(']');
    }
    std::uint64_t hash() const { return fnv_.value(); }

  private:
    Fnv1a fnv_;
};

}  // namespace

void append_state(std::vector<std::uint8_t>& bytes, const GameState& state) {
    Writer writer(bytes);
    visit_fields(state, writer);
}

GameState read_state(LittleEndianReader& reader) {
    GameState state;
    FieldReader fields(reader);
    visit_fields(state, fields);
    return state;
}

std::uint64_t state_layout() {
    const GameState state;
    Layout layout;
    visit_fields(state, layout);
    return layout.hash();
}

}  // namespace oblong
