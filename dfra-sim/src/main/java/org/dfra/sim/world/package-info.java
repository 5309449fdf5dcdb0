/**
 * The seeded world that simulated robots move in: where they are, what they hit, what their devices
 * measure.
 *
 * <pre>
 *   WorldDescription + start --&gt; World --steps of 10 ms--&gt; History, a row of numbers per step
 *                                 |  ^                        |
 *                     advanceTo   |  | commands               | reads one row
 *                                 v  |                        v
 *              SkidSteerBody, MulticopterBody, Accumulator    SimulatedLaser, SimulatedCamera, SimulatedGpsAntenna ...
 *              (motion, Contacts)                  (org.dfra.sim.physics, with noise)
 * </pre>
 *
 * <p>Enter at {@link org.dfra.sim.world.World}: {@code world.robot("atrv1").rangeView("laser")} is
 * what an emulated laser wants, {@link org.dfra.sim.world.GroundTruth} what a report wants.
 *
 * <p>The state at a time follows from the description with its seed and from the commands with
 * their times, and from nothing else: not from how often or by whom it is asked. A command given at
 * t acts from the first step after t on. Between two steps the world stands still.
 */
@NullMarked
package org.dfra.sim.world;

import org.jspecify.annotations.NullMarked;
