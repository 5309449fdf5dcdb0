/**
 * A world with a device emulator on every link of its robots.
 *
 * <pre>
 *   WorldDescription --&gt; World --inputs--&gt; EmulatorFactory --SerialDevice--&gt; Simulation
 *                                                          Simulation --links--&gt; drivers
 * </pre>
 *
 * <p>Enter at {@link org.dfra.sim.run.Simulation}: over TCP with a clock, or in lock-step.
 */
@NullMarked
package org.dfra.sim.run;

import org.jspecify.annotations.NullMarked;
