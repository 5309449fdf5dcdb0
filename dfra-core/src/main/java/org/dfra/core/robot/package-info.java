/**
 * A whole robot in one virtual machine, without any network. Start at {@link
 * org.dfra.core.robot.LocalRobot}.
 */
@NullMarked
package org.dfra.core.robot;

import org.jspecify.annotations.NullMarked;
