/**
 * The subcommands of {@code ./dfra recruit}: the status of recruitment, and the experiment that
 * evaluates its strategies.
 *
 * <pre>
 *   ExperimentCommand --cells, seeds--&gt; org.dfra.recruit.experiment --CellResults--.
 *                                                                                  v
 *         figures.csv, report.html, SVGs, CSVs &lt;-- ExperimentReport &lt;-- StrategyComparison
 * </pre>
 *
 * <p>Entry point: {@link org.dfra.app.recruit.RecruitCommand}.
 */
@NullMarked
package org.dfra.app.recruit;

import org.jspecify.annotations.NullMarked;
