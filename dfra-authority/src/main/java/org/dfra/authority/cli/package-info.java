/**
 * The verbs of the authority's tool: {@code security init}, {@code issue}, {@code list}, {@code
 * renew} and {@code revoke}. Start at {@link org.dfra.authority.cli.AuthorityOptions}, which opens
 * the authority for them.
 */
@NullMarked
package org.dfra.authority.cli;

import org.jspecify.annotations.NullMarked;
