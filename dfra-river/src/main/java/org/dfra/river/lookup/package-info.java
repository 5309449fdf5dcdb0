/**
 * Lookup: how modules enter the lookup services and how clients find them there.
 *
 * <p>Enter at {@link org.dfra.river.lookup.ModuleFinder} as a client, at {@link
 * org.dfra.river.lookup.Join} as a server.
 */
@NullMarked
package org.dfra.river.lookup;

import org.jspecify.annotations.NullMarked;
