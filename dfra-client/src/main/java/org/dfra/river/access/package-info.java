/**
 * Access control of a robot's administration.
 *
 * <pre>
 *   call --&gt; GuardedDispatcher --- an @Administrative method? ---&gt; AdministrationPolicy
 *                 |                                                  OwnAddresses, AddressRange
 *                 '--- every other method: arguments are read, the method runs
 * </pre>
 *
 * <p>Enter at {@link org.dfra.river.access.GuardedDispatcher}, which precedes every object that
 * DFRA exports. Clients download this package too, so it needs the API and River only.
 */
@NullMarked
package org.dfra.river.access;

import org.jspecify.annotations.NullMarked;
