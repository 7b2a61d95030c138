#include "game/simulation/state.h"

#include "game/simulation/state_fields.h"

namespace oblong {
namespace {

constexpr std::uint64_t kFnvStart = 14'695'981'039'346'656'037u, kFnvPrime = 1'099'511'628'211u;

struct Hash {
    std::uint64_t value = kFnvStart;

    void add(std::int64_t number) {
        for (int byte = 0; byte < 8; ++byte)
            value = (value ^ ((static_cast<std::uint64_t>(number) >> (8 * byte)) & 0xff)) * kFnvPrime;
    }
    template <class Field>
    void operator()(const Field& field) {
        add(static_cast<std::int64_t>(field));
    }
    void operator()(World number) { add(number.raw); }
    void operator()(Angle angle) { add(angle.bam); }
    void operator()(const MoverState& mover) { visit_fields(mover, *this); }
    void operator()(const TriggerState& trigger) { visit_fields(trigger, *this); }
    void operator()(const DelayedFiring& delayed) { visit_fields(delayed, *this); }
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
    return hash.value;
}

}  // namespace oblong
