/**
 * The clocks of a robot: {@link org.dfra.core.time.RobotTime} is real time, or that of a faster or
 * slower simulation. {@link org.dfra.core.time.StallProbe} distinguishes a late program from one
 * that the computer delayed.
 */
@NullMarked
package org.dfra.core.time;

import org.jspecify.annotations.NullMarked;
