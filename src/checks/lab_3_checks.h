#pragma once

#include "checks/evidence.h"
#include "checks/frame_capture.h"

namespace checks {

/// Task 3.1: the low tank has the parts, joints and places of the high one, no light, no texture, a colour a
/// part, and its own lists of far fewer triangles.
void check_low_tank(const CheckSubject& subject, Evidence& evidence);

/// Task 3.2: the low tank moves away along -Z by key and stays in sight; beyond d the two models look alike,
/// well inside of it they do not; a key makes the distance d.
void check_threshold(const CheckSubject& subject, Evidence& evidence);

/// Task 3.3: by keys alone each crossing of d switches what is drawn exactly once; trembling does not.
void check_switching(const CheckSubject& subject, Evidence& evidence);

} // namespace checks
