#include "engine/frame/span_texturing.h"

namespace oblong {

SpanTexturing make_span_texturing(const Accuracy& accuracy, const Kernels& kernels) {
    Accuracy pixels = accuracy;
    pixels.texturing = Texturing::Exact;
    return {accuracy.texturing,
            make_block_rule(accuracy),
            block_cutter(accuracy, kernels),
            block_cutter(pixels, kernels),
            accuracy.reciprocal == ReciprocalMethod::Exact,
            &kernels};
}

}  // namespace oblong
