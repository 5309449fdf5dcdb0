/**
 * Simulated time, in lock-step with everything that uses it.
 *
 * <pre>
 *   advance(10 ms)
 *        |
 *        v               tasks of the world, of devices, of leases and deliveries
 *   LockStep --- next ---&lt;
 *        ^       due      readers of drivers: bytes arrived, or a wait ended
 *        '--- all threads wait again, no more events are due
 * </pre>
 *
 * <p>Enter at {@link org.dfra.sim.time.LockStep}. Drivers keep their threads; these run one after
 * the other, in an order independent of the operating system's scheduler. So a run with the same
 * seed has the same bytes at the same times.
 */
@NullMarked
package org.dfra.sim.time;

import org.jspecify.annotations.NullMarked;
