/**
 * Who the processes of this computer are, by the certificates in the folder of their identity.
 *
 * <p>Start at {@link org.dfra.river.identity.IdentityFolder}: it logs in by JAAS and returns {@link
 * org.dfra.river.identity.TeamCredentials}. {@link org.dfra.river.identity.TeamCertificates} checks
 * what it reads; the command that writes the folder uses the same checks.
 */
@NullMarked
package org.dfra.river.identity;

import org.jspecify.annotations.NullMarked;
