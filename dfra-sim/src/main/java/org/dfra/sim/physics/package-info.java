/**
 * What a device's emulator wants of the robot that carries it: where it is, what it sees, what it
 * moves.
 *
 * <pre>
 *   org.dfra.sim.world --implements--&gt; these &lt;--ask and move-- org.dfra.sim.device
 *   bodies, walls, noise               RangeInput, DrivetrainPhysics ...  bytes of a protocol
 * </pre>
 *
 * <p>Each interface is one device's view of the world, small enough for a test to fake in a line.
 * Units are SI, angles radians, frames right-handed with x forward, y left and z up; the world's
 * frame is ENU. Every method is told what time it is, and times given to one body never go back.
 * All bodies of a world are one monitor: any thread may ask.
 */
@NullMarked
package org.dfra.sim.physics;

import org.jspecify.annotations.NullMarked;
