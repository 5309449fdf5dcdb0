/**
 * What every behaviour does: takes up a goal, works at it at a rate, pauses, and ends. Enter at
 * {@link org.dfra.core.behavior.BehaviorImpl}.
 */
@NullMarked
package org.dfra.core.behavior;

import org.jspecify.annotations.NullMarked;
