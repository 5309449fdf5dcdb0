/**
 * The audit trail: who called what, what the guard decided, and what else concerned security.
 *
 * <p>Start at {@link org.dfra.core.audit.AuditTrail}. A process appends lines to files of its own:
 *
 * <pre>
 * AuditedGuard → AuditTrail → AuditIntake (sums, limits, queue) → AuditWriter (one thread)
 *                                                                → TrailAppender → STREAM.NUMBER.jsonl
 * </pre>
 *
 * Each line carries the hash of the line before. {@link org.dfra.core.audit.AuditVerifier} finds
 * the first line that breaks this chain; an {@link org.dfra.core.audit.AuditHead}, which other
 * members keep in a {@link org.dfra.core.audit.HeadStore}, shows that a tail was cut off.
 */
@NullMarked
package org.dfra.core.audit;

import org.jspecify.annotations.NullMarked;
