/**
 * The verbs of {@code ./dfra recruit}: the experiment that judges how robots recruit each other.
 *
 * <pre>
 *   ExperimentCommand --cells, seeds--&gt; org.dfra.recruit.experiment --CellResults--.
 *                                                                                  v
 *               figures.csv, report.html, SVGs, CSVs  &lt;-- ExperimentReport &lt;-- Comparison
 * </pre>
 *
 * <p>Enter at {@link org.dfra.app.recruit.RecruitCommand}.
 */
@NullMarked
package org.dfra.app.recruit;

import org.jspecify.annotations.NullMarked;
