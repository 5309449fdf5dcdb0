/**
 * Lookup: how modules register with lookup services and how clients find them there.
 *
 * <pre>
 *   LookupJoin --&gt; lookup services --events--&gt; RegistrarMonitor --&gt; ServiceTable
 *        \___________________ Discovery ___________________/                 |
 *                                                                 JiniModuleDirectory
 * </pre>
 *
 * <p>Enter at {@link org.dfra.river.lookup.JiniModuleDirectory} as a client, at {@link
 * org.dfra.river.lookup.LookupJoin} as a server.
 */
@NullMarked
package org.dfra.river.lookup;

import org.jspecify.annotations.NullMarked;
