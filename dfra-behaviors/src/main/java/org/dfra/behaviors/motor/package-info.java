/**
 * Motor schemas: from a robot's percepts to recommended effector commands. Enter at {@link
 * org.dfra.behaviors.motor.FuzzyDriveImpl}.
 */
@NullMarked
package org.dfra.behaviors.motor;

import org.jspecify.annotations.NullMarked;
