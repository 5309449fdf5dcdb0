/**
 * What time it is on a robot: {@link org.dfra.core.time.RobotTime} is real, or that of a simulation
 * that runs faster or slower. {@link org.dfra.core.time.StallProbe} tells a program that was late
 * from one that the computer kept waiting.
 */
@NullMarked
package org.dfra.core.time;

import org.jspecify.annotations.NullMarked;
