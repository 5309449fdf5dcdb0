/**
 * Motor schemas: what a robot's percepts advise its effectors to do. Enter at {@link
 * org.dfra.behaviors.motor.FuzzyDriveImpl}.
 */
@NullMarked
package org.dfra.behaviors.motor;

import org.jspecify.annotations.NullMarked;
