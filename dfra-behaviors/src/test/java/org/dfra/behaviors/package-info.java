/** What tests of several packages share: {@link org.dfra.behaviors.ScriptedRobot} and its time. */
@NullMarked
package org.dfra.behaviors;

import org.jspecify.annotations.NullMarked;
