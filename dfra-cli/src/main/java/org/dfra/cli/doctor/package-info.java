/**
 * Checks whether this computer, and the team it discovers, are ready for robots.
 *
 * <p>Entry point: {@link org.dfra.cli.doctor.DoctorCommand}. Each {@link
 * org.dfra.cli.doctor.CheckRunner.Check} examines one aspect and reports {@link
 * org.dfra.cli.doctor.Finding}s; each finding has a {@link org.dfra.cli.doctor.Subject}, which
 * docs/troubleshooting.md explains.
 */
@NullMarked
package org.dfra.cli.doctor;

import org.jspecify.annotations.NullMarked;
