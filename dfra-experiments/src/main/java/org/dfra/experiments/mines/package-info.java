/**
 * Measures the detection rates of mines: simulated fields with mines and similar objects, robots
 * that drive through, and counts of their cameras' detections.
 *
 * <p>Entry points: {@link org.dfra.experiments.mines.MineLaneObservations} for the images of one
 * robot, {@link org.dfra.experiments.mines.DetectionCounter} for the counts.
 */
@NullMarked
package org.dfra.experiments.mines;

import org.jspecify.annotations.NullMarked;
