#pragma once

#include "legacygl/backend/backend.h"
#include "legacygl/backend/es3_functions.h"
#include "legacygl/backend/es3_target.h"

#include <optional>

namespace legacygl {

/// The fixed state of the ES context, set only where a draw wants another than the last one.
class Es3FixedState
{
public:
    Es3FixedState(const Es3Functions& functions, Es3Target& target) : gl_(functions), target_(target) {}

    void apply(const Pipeline& wanted);
    /// Forgets what ES has, which others changed.
    void forget() { known_.reset(); }

private:
    void apply(const StencilState& stencil);
    void apply(const BlendState& blend);
    void set_enabled(GLenum capability, bool enabled);

    const Es3Functions& gl_;
    Es3Target& target_;
    std::optional<Pipeline> known_; ///< What ES has now; empty when that is not known.
};

} // namespace legacygl
