/**
 * The demonstration {@code security}: a team whose members know each other, and what the others may
 * not. Start at {@link org.dfra.examples.security.SecurityDemo}.
 */
@NullMarked
package org.dfra.examples.security;

import org.jspecify.annotations.NullMarked;
