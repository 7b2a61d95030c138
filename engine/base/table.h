#pragma once

#include <cassert>
#include <compare>
#include <cstdint>
#include <initializer_list>
#include <span>
#include <type_traits>
#include <vector>

namespace oblong {

/// A count, distance or index >= 0 as a size; builds with assertions check it.
constexpr std::size_t as_size(auto count) {
    if constexpr (std::is_signed_v<decltype(count)>) assert(count >= 0);
    return static_cast<std::size_t>(count);
}

/// An element by an index >= 0 of any integer or enumeration type; builds with assertions check it.
constexpr decltype(auto) item(auto& items, auto index) {
    const std::size_t position = as_size(index);
    if constexpr (requires { items.size(); }) assert(position < items.size());
    return items[position];
}

/// Stored indices, and coordinates of levels in whole units or texels. In small memory (the game under DOS) levels have
/// fewer and lower ones.
#ifdef OBLONG_SMALL_MEMORY
using LevelNumber = std::int16_t;
#else
using LevelNumber = std::int32_t;
#endif

/// The type in which an index of such a record is stored; specialised for records of which there are more.
template <class Record>
struct StoredIndex {
    using Number = LevelNumber;
};

/// The index of a record in a Table, or none.
template <class Record>
class Index {
  public:
    constexpr Index() = default;
    constexpr explicit Index(std::int32_t number) : number_(static_cast<Number>(number)) { assert(number_ == number); }
    static constexpr Index none() { return Index(-1); }

    constexpr std::int32_t number() const { return number_; }
    constexpr std::size_t position() const { return static_cast<std::size_t>(number_); }
    constexpr bool is_none() const { return number_ < 0; }

    constexpr Index& operator++() {
        ++number_;
        return *this;
    }
    constexpr auto operator<=>(const Index&) const = default;

  private:
    using Number = typename StoredIndex<Record>::Number;

    Number number_ = 0;
};

/// Consecutive records of a table: `count` of them from `first` on.
template <class Record>
struct IndexRange {
    Index<Record> first;
    LevelNumber count = 0;

    struct Iterator {
        Index<Record> at;
        constexpr Index<Record> operator*() const { return at; }
        constexpr Iterator& operator++() {
            ++at;
            return *this;
        }
        constexpr bool operator==(const Iterator&) const = default;
    };
    /// Removes the first index and returns it; the range must not be empty.
    constexpr Index<Record> take_first() {
        const Index<Record> taken = first;
        ++first;
        --count;
        return taken;
    }

    constexpr Iterator begin() const { return {first}; }
    constexpr Iterator end() const { return {Index<Record>(first.number() + count)}; }
    constexpr bool operator==(const IndexRange&) const = default;
};

/// A vector subscripted by the typed index of its records, or by a range of them. `Record` differs from the stored type
/// where a table holds additional data on the records of another one.
template <class Value, class Record = Value>
class Table : private std::vector<Value> {
    using Base = std::vector<Value>;

  public:
    using Base::Base, Base::assign, Base::back, Base::begin, Base::clear, Base::data, Base::empty, Base::end,
        Base::front, Base::insert, Base::push_back, Base::reserve, Base::resize, Base::size;

    Value& operator[](Index<Record> index) { return Base::operator[](index.position()); }
    const Value& operator[](Index<Record> index) const { return Base::operator[](index.position()); }
    std::span<const Value> operator[](const IndexRange<Record>& range) const {
        return std::span(Base::data(), Base::size()).subspan(range.first.position(), as_size(range.count));
    }

    std::int32_t count() const { return static_cast<std::int32_t>(Base::size()); }
    IndexRange<Record> indices() const { return {Index<Record>(0), static_cast<LevelNumber>(count())}; }

    bool operator==(const Table&) const = default;
};

}  // namespace oblong
