#pragma once

#include "checks/evidence.h"
#include "checks/frame_capture.h"

namespace checks {

/// Task 1.1: 18 parts in a tree; what hangs on a part is drawn within its push and goes where it goes.
void check_assembly(const CheckSubject& subject, Evidence& evidence);

/// Task 1.2: two keys turn each of turret, main gun, secondary gun and wheels, one way and the other.
void check_joints(const CheckSubject& subject, Evidence& evidence);

/// Task 1.3: every part is drawn by calling its mesh's display list, and by nothing else.
void check_display_lists(const CheckSubject& subject, Evidence& evidence);

/// Task 1.4: what a list holds is the mesh, corner by corner between glBegin(GL_TRIANGLES) and glEnd.
void check_draw_obj(const CheckSubject& subject, Evidence& evidence);

} // namespace checks
