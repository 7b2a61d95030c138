#include "game/simulation/state.h"

#include "engine/base/checksum.h"

namespace oblong {
namespace {

struct Hash {
    Fnv1a fnv;

    void add(std::int64_t number) { fnv.add_number(static_cast<std::uint64_t>(number)); }
    template <class Field>
    void operator()(const Field& field) {
        add(static_cast<std::int64_t>(field));
    }
    void operator()(World number) { add(number.raw); }
    void operator()(Angle angle) { add(angle.bam); }
    template <HasFields Struct>
    void operator()(const Struct& each) {
        if constexpr (requires { each.is_empty(); })
            if (each.is_empty()) return;
        visit_fields(each, *this);
    }
    template <class Element>
    void operator()(const std::vector<Element>& list) {
        add(static_cast<std::int64_t>(list.size()));
        for (const Element& element : list) (*this)(element);
    }
};

}  // namespace

std::uint64_t hash_of(const GameState& state) {
    Hash hash;
    visit_fields(state, hash);
    return hash.fnv.value();
}

}  // namespace oblong
