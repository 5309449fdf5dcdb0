/**
 * Checks whether this computer, and the team it discovers, are ready for robots.
 *
 * <p>Entry point: {@link org.dfra.app.doctor.DoctorCommand}. Each {@link org.dfra.app.doctor.Check}
 * examines one aspect and reports {@link org.dfra.app.doctor.Finding}s; each finding has a {@link
 * org.dfra.app.doctor.Subject}, which docs/troubleshooting.md explains.
 */
@NullMarked
package org.dfra.app.doctor;

import org.jspecify.annotations.NullMarked;
