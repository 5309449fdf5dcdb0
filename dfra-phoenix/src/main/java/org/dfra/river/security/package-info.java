/**
 * How a process becomes a member of its team when it starts.
 *
 * <p>Start at {@link org.dfra.river.security.SecureProcess}: it loads the identity, the policy and
 * the audit trail, and gives the transport the identity with which everything is exported and
 * called. {@link org.dfra.river.security.SecurityWatch} notices later policies and lists of revoked
 * certificates.
 */
@NullMarked
package org.dfra.river.security;

import org.jspecify.annotations.NullMarked;
