/**
 * The experiment that evaluates recruitment: agents in a field of 100 m by 100 m, as a
 * discrete-event simulation, with the same agent code as a robot's. The environment of a run is its
 * {@link org.dfra.experiments.recruit.simulation.ExperimentEnvironment}: this package contains the
 * simulated one.
 *
 * <pre>
 *   ExperimentGrid --cells--&gt; Experiment --a seed and a cell--&gt; FieldRun --RunResult--&gt; CellResult
 * </pre>
 *
 * <p>Enter at {@link org.dfra.experiments.recruit.simulation.Experiment}.
 */
@NullMarked
package org.dfra.experiments.recruit.simulation;

import org.jspecify.annotations.NullMarked;
