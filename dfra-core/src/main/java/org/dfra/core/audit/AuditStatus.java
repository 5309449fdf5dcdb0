package org.dfra.core.audit;

import java.util.Optional;

/**
 * How an audit trail works at present.
 *
 * @param written records on the disk or in the kernel's cache, since the start
 * @param dropped events without a record, since the start; the trail itself has their number
 * @param fault why records cannot be written now, in a sentence; empty if they can
 */
public record AuditStatus(long written, long dropped, Optional<String> fault) {}
