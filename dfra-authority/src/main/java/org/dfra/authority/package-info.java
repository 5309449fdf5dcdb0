/**
 * The authority of a team: it issues and revokes the certificates of members. It runs on the
 * computer of one person, not on robots. Start at {@link org.dfra.authority.Authority}.
 */
@NullMarked
package org.dfra.authority;

import org.jspecify.annotations.NullMarked;
