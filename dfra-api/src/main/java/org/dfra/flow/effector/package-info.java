/**
 * Effectors: the modules that act on the world.
 *
 * <pre>
 *   client --- command(duration) --&gt; Effector     one commander at a time, by a lease
 *          &lt;------- CommandLease ---
 *          --- obey(key, command) --&gt;             who holds no key is refused
 *   lease closed, expired, revoked --&gt; the effector comes to rest
 *   anybody --- emergencyStop(by) --&gt;          it comes to rest and obeys nobody until released
 * </pre>
 *
 * <p>Enter at {@link org.dfra.flow.effector.Effector}. A kind of effector is an interface here, its
 * commands are a sealed interface of records.
 */
@NullMarked
package org.dfra.flow.effector;

import org.jspecify.annotations.NullMarked;
