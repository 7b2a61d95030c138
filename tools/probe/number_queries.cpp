#include "engine/fixed/arithmetic.h"
#include "engine/fixed/root.h"
#include "engine/fixed/sine_methods.h"
#include "engine/methods/square_root.h"
#include "tools/probe/decimal.h"
#include "tools/probe/queries.h"

namespace oblong {

namespace {

/// N / 65536, N from 0 to 2^31 - 1.
using Number = Fixed<std::int64_t, 16>;
// The finest formats that hold every answer: roots up to 182, reciprocals up to 65,536.
using Root = Fixed<std::int64_t, 38>;
using Reciprocal = Fixed<std::int64_t, 46>;

Angle read_only_angle(Fields& fields) {
    const Angle angle = fields.angle();
    fields.expect_end();
    return angle;
}

Number read_only_number(Fields& fields) {
    const Number number = Number::from_raw(fields.integer(0, 2147483647));
    fields.expect_end();
    return number;
}

}  // namespace

std::string answer_sine(Fields& fields, const Accuracy& accuracy) {
    return format_fixed(sine(read_only_angle(fields), accuracy.sine));
}

std::string answer_cosine(Fields& fields, const Accuracy& accuracy) {
    return format_fixed(cosine(read_only_angle(fields), accuracy.sine));
}

std::string answer_root(Fields& fields) {
    return format_fixed(square_root<Root>(read_only_number(fields), Rounding::NearestHalfUp));
}

std::string answer_reciprocal(Fields& fields) {
    const Number number = read_only_number(fields);
    return number == Number{} ? "inf" : format_fixed(reciprocal<Reciprocal>(number));
}

}  // namespace oblong
