#pragma once

#include "checks/evidence.h"
#include "checks/frame_capture.h"

namespace checks {

/// Task 2.1: the sphere of a mesh is around the average of its vertices and reaches the furthest of them; the
/// smallest one is no larger and lets no vertex out.
void check_mesh_spheres(const CheckSubject& subject, Evidence& evidence);

/// Task 2.2: a sphere for each part, around all that is drawn of it in every pose, and one around all these.
void check_sphere_hierarchy(const CheckSubject& subject, Evidence& evidence);

/// Task 2.3: a point is tested against the whole first, then against every part, and what it penetrates is
/// printed.
void check_point_test(const CheckSubject& subject, Evidence& evidence);

/// Task 2.4: the point is drawn and moved by keys, what it penetrates is drawn transparent around the part.
void check_point_shown(const CheckSubject& subject, Evidence& evidence);

/// Task 2.5: the point of segment, ray and line closest to each centre decides, and is marked.
void check_line_test(const CheckSubject& subject, Evidence& evidence);

/// Task 2.6: sparks fly where the projectile touches a part, for as long as it is inside and no longer.
void check_sparks(const CheckSubject& subject, Evidence& evidence);

} // namespace checks
