/**
 * The seeded world of simulated robots: their poses, collisions and device measurements.
 *
 * <pre>
 *   WorldDescription + start --&gt; World --steps of 10 ms--&gt; StateHistory, a row of numbers per step
 *                                 |  ^                        |
 *                     advanceTo   |  | commands               | reads one row
 *                                 v  |                        v
 *   SkidSteerBody, MulticopterBody, BatteryModel   SimulatedLaser, SimulatedCamera, ...
 *   (motion, CollisionDetector)                    (org.dfra.sim.physics, with noise)
 * </pre>
 *
 * <p>Enter at {@link org.dfra.sim.world.World}: {@code world.robot("atrv1").rangeView("laser")} is
 * the input of an emulated laser, {@link org.dfra.sim.world.GroundTruth} that of a report.
 *
 * <p>The state at a time depends only on the description with its seed and on the commands with
 * their times, not on queries. A command given at t takes effect from the first step after t on.
 * Between two steps the state is constant.
 */
@NullMarked
package org.dfra.sim.world;

import org.jspecify.annotations.NullMarked;
