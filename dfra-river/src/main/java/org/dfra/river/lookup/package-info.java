/**
 * Lookup: how modules enter the lookup services and how clients find them there.
 *
 * <pre>
 *   Join --registers--&gt; lookup services --events--&gt; RegistrarMonitor --&gt; Sightings --&gt; directory
 *     \______________________ Discovery ______________________/
 * </pre>
 *
 * <p>Enter at {@link org.dfra.river.lookup.JiniModuleDirectory} as a client, at {@link
 * org.dfra.river.lookup.LookupJoin} as a server.
 */
@NullMarked
package org.dfra.river.lookup;

import org.jspecify.annotations.NullMarked;
