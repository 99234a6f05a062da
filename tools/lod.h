#pragma once
// Level of detail by how large a chunk of hair is in the picture.

#include <span>

#include "procedural/generator.h"
#include "render_test/camera.h"

namespace lancret {

/// Leaves in each chunk of `generator`'s binding, at rest, about `strands_a_pixel`
/// strands for each of the pixels (height of them down the picture) of the rectangle
/// round its box where it is largest to one of the cameras; all of a chunk that reaches
/// behind one. The box is that of a few of its strands: it decides how fine, and need not
/// hold all. Throws InputError where nothing is left.
void prune_by_size(Generator& generator, std::span<const Camera> cameras, int height,
                   double strands_a_pixel);

}  // namespace lancret
