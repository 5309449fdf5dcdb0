/**
 * A world with a device emulator at the end of every line of its robots.
 *
 * <pre>
 *   WorldDescription --&gt; World --views--&gt; Emulators --SerialDevice--&gt; Simulation --links--&gt; drivers
 * </pre>
 *
 * <p>Enter at {@link org.dfra.sim.run.Simulation}: over TCP by a clock, or in lock-step.
 */
@NullMarked
package org.dfra.sim.run;

import org.jspecify.annotations.NullMarked;
