/**
 * The experiment that evaluates the strategies of recruitment.
 *
 * <pre>
 *   ExperimentCommand --cells, seeds--&gt; org.dfra.experiments.recruit.simulation --CellResults--.
 *                                                                                  v
 *         figures.csv, report.html, SVGs, CSVs &lt;-- ExperimentReport &lt;-- StrategyComparisonReport
 * </pre>
 *
 * <p>Entry point: {@link org.dfra.experiments.recruit.ExperimentCommand}.
 */
@NullMarked
package org.dfra.experiments.recruit;

import org.jspecify.annotations.NullMarked;
