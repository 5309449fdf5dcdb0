/**
 * Measures how well mines are found: simulated fields with mines and with what is taken for them,
 * robots that drive through, and counts of what their cameras say.
 *
 * <p>Enter at {@link org.dfra.app.mines.MineLaneObservations} for what one robot sees, at {@link
 * org.dfra.app.mines.DetectionCounter} for what follows from it.
 */
@NullMarked
package org.dfra.app.mines;

import org.jspecify.annotations.NullMarked;
