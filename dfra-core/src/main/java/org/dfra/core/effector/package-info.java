/**
 * Base of the effectors' drivers, and the guard in front of them.
 *
 * <pre>
 *   command(duration) --&gt; Helm --grants one key at a time--&gt; CommandLease
 *   obey(key, command) --&gt; EffectorImpl --&gt; Helm: is it the commander's key? --&gt; the driver
 *   lease over --&gt; Helm --&gt; EffectorImpl --&gt; the driver comes to rest
 *   emergencyStop(by) --&gt; EmergencyStop --&gt; EmergencyStopLatch (no key counts) --&gt; the driver comes to rest
 * </pre>
 *
 * <p>Enter at {@link org.dfra.core.effector.EffectorImpl}; for wheels at {@link
 * org.dfra.core.effector.DriveImpl}, which also stops them when commands fall silent ({@code
 * CommandTimeout}).
 */
@NullMarked
package org.dfra.core.effector;

import org.jspecify.annotations.NullMarked;
