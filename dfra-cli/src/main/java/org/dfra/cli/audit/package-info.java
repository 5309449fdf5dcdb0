/**
 * {@code ./dfra audit}: who called what on this computer's robots, and what was refused. Entry
 * point: {@link org.dfra.cli.audit.AuditCommand}.
 */
@NullMarked
package org.dfra.cli.audit;

import org.jspecify.annotations.NullMarked;
