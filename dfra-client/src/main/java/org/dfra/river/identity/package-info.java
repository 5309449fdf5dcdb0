/**
 * Who a process is in its team, and whom it believes.
 *
 * <p>Start at {@link org.dfra.river.identity.IdentityFolder}: it logs in by JAAS and returns {@link
 * org.dfra.river.identity.TeamCredentials}. From these comes the {@link
 * org.dfra.river.identity.TeamIdentity} with which the transport encrypts. {@link
 * org.dfra.river.identity.MemberTrust} decides which certificates of others are believed, and
 * {@link org.dfra.river.identity.RevokedCertificates} which no longer are. {@link
 * org.dfra.river.identity.TeamCertificates} checks what is read from files; the command that writes
 * them uses the same checks.
 *
 * <p>The transport knows only {@link org.dfra.river.identity.ChannelIdentity}, which endpoints get
 * from {@link org.dfra.river.identity.CurrentIdentity}, and {@link
 * org.dfra.river.identity.ChannelPeer}. This package knows no transport.
 */
@NullMarked
package org.dfra.river.identity;

import org.jspecify.annotations.NullMarked;
