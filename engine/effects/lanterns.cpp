#include "engine/effects/lanterns.h"

#include "engine/fixed/arithmetic.h"
#include "engine/fixed/trig.h"

namespace oblong {

Sprite lantern_at(const Lantern& lantern, std::int64_t time_ms) {
    const Angle angle = Angle::from_bam(time_ms % lantern.period_ms * 65536 / lantern.period_ms);
    const Vec3<World> from_middle{
        product<World>(lantern.radius, cosine(angle)), product<World>(lantern.radius, sine(angle)), {}};
    return {lantern.middle + from_middle, lantern.texture, lantern.scale};
}

}  // namespace oblong
