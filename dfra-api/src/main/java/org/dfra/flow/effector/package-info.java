/**
 * Effectors: the modules that act on the world.
 *
 * <pre>
 *   client --- acquireCommandLease(duration) --&gt; Effector     one commander at a time
 *          &lt;------- CommandLease ---
 *          --- execute(key, command) --&gt;                      refused without a valid key
 *   lease closed, expired, revoked --&gt; the effector stops
 *   any client --- emergencyStop(requester) --&gt;  it stops, and refuses commands until released
 * </pre>
 *
 * <p>Start at {@link org.dfra.flow.effector.Effector}. A kind of effector is an interface here, its
 * commands are a sealed interface of records.
 */
@NullMarked
package org.dfra.flow.effector;

import org.jspecify.annotations.NullMarked;
