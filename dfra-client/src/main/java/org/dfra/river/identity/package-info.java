/**
 * Who a process is in its team, and whom it believes.
 *
 * <p>Start at {@link org.dfra.river.identity.TeamIdentity}: the transport encrypts with it. {@link
 * org.dfra.river.identity.MemberTrust} decides which certificates are believed, and {@link
 * org.dfra.river.identity.RevokedCertificates} which no longer are.
 */
@NullMarked
package org.dfra.river.identity;

import org.jspecify.annotations.NullMarked;
