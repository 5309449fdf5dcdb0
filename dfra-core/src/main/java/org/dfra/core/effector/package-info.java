/**
 * Base of the effectors' drivers, and the guard of their commands.
 *
 * <pre>
 *   acquireCommandLease(duration) --&gt; CommandArbiter --one key at a time--&gt; CommandLease
 *   execute(key, command) --&gt; EffectorImpl --&gt; CommandArbiter: key valid? --&gt; driver
 *   lease ended --&gt; CommandArbiter --&gt; EffectorImpl --&gt; driver stops
 *   emergencyStop(requester) --&gt; EmergencyStop --&gt; EmergencyStopLatch --&gt; driver stops
 * </pre>
 *
 * <p>Start at {@link org.dfra.core.effector.EffectorImpl}; for wheels at {@link
 * org.dfra.core.effector.DriveImpl}, which also stops them on a command timeout ({@code
 * CommandTimeout}).
 */
@NullMarked
package org.dfra.core.effector;

import org.jspecify.annotations.NullMarked;
