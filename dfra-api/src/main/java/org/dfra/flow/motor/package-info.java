/**
 * What makes commands of percepts: the second half of every behaviour. A motor schema advises; who
 * holds the effector's lease commands.
 */
@NullMarked
package org.dfra.flow.motor;

import org.jspecify.annotations.NullMarked;
