/**
 * Motor schemas: they compute commands from percepts, the second half of every behaviour. A motor
 * schema recommends; the holder of the effector's lease commands.
 */
@NullMarked
package org.dfra.flow.motor;

import org.jspecify.annotations.NullMarked;
