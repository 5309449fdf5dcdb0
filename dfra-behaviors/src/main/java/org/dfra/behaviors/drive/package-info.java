/**
 * What keeps a goal from moving the robot by itself after somebody has stopped it. Enter at {@link
 * org.dfra.behaviors.drive.DriveInterlock}.
 */
@NullMarked
package org.dfra.behaviors.drive;

import org.jspecify.annotations.NullMarked;
