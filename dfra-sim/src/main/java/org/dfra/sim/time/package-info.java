/**
 * Time that a simulation moves on itself, in lock-step with everything that lives by it.
 *
 * <pre>
 *   advance(10 ms)
 *        |
 *        v               tasks of the world, of devices, of leases and deliveries
 *   LockStep --- next ---&lt;
 *        ^       due      readers of drivers: their bytes came, or their wait is over
 *        '--- all is still again, nothing more is due
 * </pre>
 *
 * <p>Enter at {@link org.dfra.sim.time.LockStep}. Drivers keep their threads; they get their turns
 * one after the other, in an order that no scheduler of threads has a say in. So a run with the
 * same seed has the same bytes at the same times.
 */
@NullMarked
package org.dfra.sim.time;

import org.jspecify.annotations.NullMarked;
