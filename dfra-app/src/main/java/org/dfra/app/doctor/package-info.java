/**
 * Whether this computer, and the team it sees, are fit for robots.
 *
 * <p>Enter at {@link org.dfra.app.doctor.DoctorCommand}. Each {@link org.dfra.app.doctor.Check}
 * looks at one thing and reports {@link org.dfra.app.doctor.Finding}s; each finding is about a
 * {@link org.dfra.app.doctor.Subject}, which docs/troubleshooting.md explains.
 */
@NullMarked
package org.dfra.app.doctor;

import org.jspecify.annotations.NullMarked;
