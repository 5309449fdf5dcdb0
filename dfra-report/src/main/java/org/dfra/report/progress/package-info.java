/**
 * The progress of a program that runs for minutes, as text: what it does, its assertions, and the
 * quantities in its sentences. Entry point: {@link org.dfra.report.progress.ProgressReporter}.
 */
@NullMarked
package org.dfra.report.progress;

import org.jspecify.annotations.NullMarked;
