/**
 * The interfaces through which a device's emulator reads and moves its robot: pose, sensor inputs,
 * actuators.
 *
 * <pre>
 *   org.dfra.sim.world --implements--&gt; these &lt;--read and move-- org.dfra.sim.device
 *   bodies, obstacles, noise     RangeInput, DrivetrainPhysics ...    bytes of a protocol
 * </pre>
 *
 * <p>Each interface is one device's view of the world, small enough for a one-line fake in a test.
 * Units are SI, angles radians, frames right-handed with x forward, y left and z up; the world's
 * frame is ENU. Callers pass the time to every method; times passed to one body never decrease. All
 * bodies of a world share one monitor: any thread may call.
 */
@NullMarked
package org.dfra.sim.physics;

import org.jspecify.annotations.NullMarked;
