/**
 * The emergency stop of every robot that can be reached. Enter at {@link
 * org.dfra.app.stop.StopCommand}; whom it calls, and how often, is {@link
 * org.dfra.app.stop.StopRound}'s.
 */
@NullMarked
package org.dfra.app.stop;

import org.jspecify.annotations.NullMarked;
