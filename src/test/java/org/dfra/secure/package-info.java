/**
 * Robots of a team whose members know each other by certificates, as users make it: by commands, in
 * processes and state folders of their own.
 *
 * <p>Enter at {@link org.dfra.secure.SecureTeamIT}.
 */
package org.dfra.secure;
