#pragma once

namespace app {

/// The state steps at this rate, whatever the rate of frames.
constexpr int TICKS_PER_SECOND = 60;

} // namespace app
